//! The pictures, each drawn from the tables alone.

mod depth;
mod front;
mod parts;
mod peers;
mod setup_and_fill;

use crate::table::Table;

/// All tables.
#[derive(Clone, Debug)]
pub(crate) struct Tables {
    pub(crate) texels: Table,
    pub(crate) picks: Table,
    pub(crate) within: Table,
    pub(crate) resolution: Table,
    pub(crate) inversions: Table,
    pub(crate) setup_and_fill: Table,
    pub(crate) parts: Table,
    pub(crate) ram: Table,
    pub(crate) colour: Table,
    pub(crate) traversal: Table,
    /// Written by `tools/peers`, where it was.
    pub(crate) peers: Option<Table>,
}

/// The pictures' files and texts.
pub(crate) fn all(tables: &Tables) -> Vec<(&'static str, String)> {
    let mut figures = vec![
        ("front-m0plus.svg", front::draw(&tables.texels, &front::M0PLUS)),
        ("front-m4.svg", front::draw(&tables.texels, &front::M4)),
        ("front-host.svg", front::draw(&tables.texels, &front::HOST)),
        ("depth.svg", depth::draw(&tables.resolution, &tables.inversions)),
        ("setup-and-fill.svg", setup_and_fill::draw(&tables.setup_and_fill)),
        ("parts.svg", parts::draw(&tables.parts)),
    ];
    figures.extend(tables.peers.as_ref().map(|peers| ("peers.svg", peers::draw(peers))));
    figures
}

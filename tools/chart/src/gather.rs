//! All tables: errors from the reference, costs from the committed tables, times from this machine.

use std::path::Path;

use indicatif::{ProgressBar, ProgressStyle};

use crate::cost::{self, Core};
use crate::figures::Tables;
use crate::host::{self, Timed};
use crate::method::{Family, PER_PIXEL};
use crate::table::{Table, figure, number};
use crate::texels::{self, Texels};
use crate::{colour, depth, method, ram, traversal, within};

/// What is read.
#[derive(Clone, Debug)]
pub(crate) struct Inputs {
    cores: Vec<Core>,
    flash: Table,
    peers: Option<Table>,
    /// The texels' table as it is, for the host's columns.
    texels: Option<Table>,
}

impl Inputs {
    /// # Errors
    /// A line that says which file cannot be read.
    pub(crate) fn read(root: &Path) -> Result<Self, String> {
        let there = |name: &str| {
            let path = root.join("docs").join(name);
            Table::read_if_there(&path).map_err(|error| format!("{}: {error}", path.display()))
        };
        let needed = |name: &str| {
            there(name)?.ok_or_else(|| format!("{}: not there", root.join("docs").join(name).display()))
        };
        let core = |name, total, per_pixel, file| {
            Ok::<_, String>(Core { name, total, per_pixel, table: needed(file)? })
        };
        Ok(Self {
            cores: vec![
                core("m0plus", "cycles_total", "cycles_per_pixel", "measured/rp2040.csv")?,
                core("m4", "instructions_total", "instructions_per_pixel", "measured/cortex-m4.csv")?,
            ],
            flash: needed("measured/flash.csv")?,
            peers: there("chart/peers.csv")?,
            texels: there("chart/texels.csv")?,
        })
    }
}

/// All tables. The host's columns are measured, or kept as they are.
///
/// # Errors
/// A line that names a method whose texels are further off than its bound.
pub(crate) fn tables(inputs: &Inputs, keep_host: bool) -> Result<Tables, String> {
    let errors = method::count() * texels::SCENES.len();
    let rounds = if keep_host { 0 } else { host::rounds() };
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}").expect("a template");
    let bar = ProgressBar::new((errors + 6 + rounds) as u64).with_style(style);
    bar.set_message("texels");
    let errors = texels::all(|| bar.inc(1));
    if let Some(wrong) = errors.iter().find(|errors| errors.worst > errors.bound) {
        let Texels { scene, method, worst, bound, .. } = wrong;
        return Err(format!("{scene}, {}: off by {worst} texels, and the bound is {bound}", method.row));
    }
    bar.set_message("depth");
    let m0plus = &inputs.cores[0];
    let [flat, deep, float] =
        ["flat", "flat+depth", "flat+depth-float"].map(|way| m0plus.per_pixel("grid240", way, "16"));
    let sorted = m0plus.per_pixel_from_the_list("grid240", ["flat+painter", "flat"], "3");
    let inversions = depth::inversions([flat, sorted, deep, float], || bar.inc(1));
    let resolution = depth::resolution(|| bar.inc(1));
    bar.set_message("time on this machine");
    let times = if keep_host { Vec::new() } else { host::all(|| bar.inc(1)) };
    bar.finish_and_clear();
    let setup_and_fill = cost::setup_and_fill(&inputs.cores);
    let texels = texels_table(inputs, &errors, &times);
    let ram = ram::table();
    Ok(Tables {
        picks: picks(&texels),
        within: within::table(&texels),
        texels,
        resolution,
        inversions,
        parts: cost::parts(&setup_and_fill, &inputs.cores, &inputs.flash, &ram),
        ram,
        setup_and_fill,
        colour: colour::table(&inputs.cores),
        traversal: traversal::table(&inputs.cores),
        peers: inputs.peers.clone(),
    })
}

/// The cheapest method of each scene and core whose texels are no further off than so much.
fn picks(texels: &Table) -> Table {
    let mut table = Table::new(&["scene", "texels", "Cortex-M0+", "cycles", "Cortex-M4", "instructions"]);
    for scene in texels::SCENES {
        for (allowed, name) in [(1.0, "1"), (0.25, "1/4"), (0.0625, "1/16")] {
            let mut row = vec![scene.to_owned(), name.to_owned()];
            for column in ["m0_cycles_per_px", "m4_instructions_per_px"] {
                let right = texels
                    .find(&[("scene", scene)])
                    .filter(|row| number(row, "texel_worst").is_some_and(|worst| worst <= allowed));
                let costs = right.filter_map(|row| Some((number(&row, column)?, row)));
                let cheapest = costs.min_by(|a, b| a.0.total_cmp(&b.0));
                row.extend(cheapest.map_or(Default::default(), |(cost, row)| {
                    [format!("{} {}", row["family"], row["setting"]).trim_end().to_owned(), figure(cost)]
                }));
            }
            table.rows.push(row);
        }
    }
    table
}

fn texels_table(inputs: &Inputs, errors: &[Texels], times: &[Timed]) -> Table {
    let mut table = Table::new(&[
        "scene",
        "method",
        "family",
        "setting",
        "texel_worst",
        "texel_p999",
        "texel_bound",
        "m0_cycles_per_px",
        "m4_instructions_per_px",
        "m0_cycles_per_px_at_s",
        "m4_instructions_per_px_at_s",
        "host_ratio",
        "host_ns_per_px",
    ]);
    for Texels { scene, method, worst, most, bound, pixels } in errors {
        // Triangles that `Within` draws affine are found when the list is made: with what that takes more.
        let than = if method.family == Family::Within { PER_PIXEL } else { method.row };
        let cost = |level: &'static str| {
            let of = move |core: &Core| core.per_pixel_from_the_list(scene, [method.row, than], level);
            inputs.cores.iter().map(move |core| of(core).map_or(String::new(), figure))
        };
        let host = times
            .iter()
            .find(|timed| timed.scene == *scene && timed.row == method.row)
            .map(|timed| [figure(timed.ratio), figure(timed.least.as_secs_f64() * 1e9 / *pixels as f64)]);
        let kept = || {
            let before = inputs.texels.as_ref()?;
            let wanted = [("scene", *scene), ("method", method.row)];
            let row = before.find(&wanted).next()?;
            Some(["host_ratio", "host_ns_per_px"].map(|column| row.get(column).unwrap_or(&"").to_string()))
        };
        let mut row: Vec<String> =
            [*scene, method.row, method.family.name(), method.setting].map(str::to_owned).into();
        row.extend([*worst, *most, *bound].map(figure));
        row.extend(cost("3").chain(cost("s")));
        row.extend(host.or_else(kept).unwrap_or_default());
        table.rows.push(row);
    }
    table
}

//! What each stage takes on this machine. `cargo bench -- raster` measures one; the names are those of `src/`.
//!
//! What they take on chips is counted by `firmware/measure.sh`, and what others take beside us by `tools/peers`.

mod clip;
mod depth;
mod list;
mod raster;
mod setup;
mod shade;
mod target;
mod transform;

use criterion::{criterion_group, criterion_main};
use embedded_graphics::geometry::Size;
use topleft::ListTriangle;

/// What is drawn for.
const PANEL: Size = Size::new(240, 240);

/// Room for the list of any scene, and for a frame.
struct Buffers {
    words: Vec<u32>,
    triangles: Vec<ListTriangle>,
    colours: Vec<u16>,
    depths: Vec<u16>,
}

impl Buffers {
    fn new() -> Self {
        let pixels = (PANEL.width * PANEL.height) as usize;
        Self {
            words: vec![0; 1 << 15],
            triangles: vec![ListTriangle::EMPTY; 2000],
            colours: vec![0; pixels],
            depths: vec![0; pixels],
        }
    }
}

/// The list has room for all scenes.
const FITS: &str = "the list is long enough";

criterion_group! {
    name = stages;
    config = criterion::Criterion::default().sample_size(30);
    targets = transform::bench, clip::bench, setup::bench, raster::bench, depth::bench, shade::bench, target::bench,
        list::bench
}
criterion_main!(stages);

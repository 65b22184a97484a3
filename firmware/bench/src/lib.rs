//! Draws each scene in each way, and measures what it costs on the chip that it runs on.
//!
//! The same cases run on a host, where nothing is measured: the checksums of their frames have to be the same.
#![no_std]

mod budget;
mod crc;
mod grid;
mod measure;
mod row;
mod scene;
mod sizes;
mod small;
mod strewn;
mod texels;
mod traversal;

pub use measure::{Clock, PANEL, Part};
pub use row::Row;

use crc::Crc;
use measure::{Bench, Buffers};
use topleft::ListTriangle;

/// The compiler that built this.
pub const COMPILER: &str = env!("BENCH_COMPILER");
/// The opt level that this was built with.
pub const OPT_LEVEL: &str = env!("BENCH_OPT_LEVEL");

const WIDTH: usize = PANEL.width as usize;
const HEIGHT: usize = PANEL.height as usize;
/// Rows of a strip.
const STRIP: usize = 16;

/// The checksum of a frame's words, as a [`Row`] has it.
pub fn checksum(words: &[u16]) -> u32 {
    let mut crc = Crc::new();
    crc.add(words);
    crc.value()
}

/// Runs all cases, and hands each row to `report` as it is done.
pub fn run(clock: &mut dyn Clock, report: &mut dyn FnMut(&Row)) {
    let mut bench = Bench::new(clock, report);
    whole_frame(&mut bench);
    halves(&mut bench);
    strips(&mut bench);
}

/// The grid, and triangles of five sizes, into a whole frame with depth: 225 KB of the stack, and 18 KB for the list.
#[inline(never)]
fn whole_frame(bench: &mut Bench<'_>) {
    let (mut colours, mut depths) = ([0; WIDTH * HEIGHT], [0; WIDTH * HEIGHT]);
    let (mut words, mut triangles, mut scratch) = ([0; 289 * 6], [ListTriangle::EMPTY; 512], [[0; 3]; 512]);
    let mut buffers = Buffers {
        colours: &mut colours,
        depths: &mut depths,
        words: &mut words,
        triangles: &mut triangles,
        scratch: &mut scratch,
    };
    grid::all(bench, &mut buffers);
    sizes::all(bench, &mut buffers);
    small::all(bench, &mut buffers);
}

/// The scenes in halves of the panel, as an RP2040 has no room for a whole frame beside their lists: 113 KB of the stack,
/// and 54 KB for the list of the largest scene.
#[inline(never)]
fn halves(bench: &mut Bench<'_>) {
    let (mut colours, mut depths) = ([0; WIDTH * HEIGHT / 2], [0; WIDTH * HEIGHT / 2]);
    let (mut words, mut triangles, mut scratch) = ([0; 6000], [ListTriangle::EMPTY; 1500], [[0; 3]; 1500]);
    let mut buffers = Buffers {
        colours: &mut colours,
        depths: &mut depths,
        words: &mut words,
        triangles: &mut triangles,
        scratch: &mut scratch,
    };
    scene::all(bench, &mut buffers);
}

/// The grid and the scenes in strips: 15 KB for a strip, and 54 KB for the list of the largest scene.
#[inline(never)]
fn strips(bench: &mut Bench<'_>) {
    let (mut colours, mut depths) = ([0; WIDTH * STRIP], [0; WIDTH * STRIP]);
    let (mut words, mut triangles, mut scratch) = ([0; 6000], [ListTriangle::EMPTY; 1500], [[0; 3]; 1500]);
    let mut buffers = Buffers {
        colours: &mut colours,
        depths: &mut depths,
        words: &mut words,
        triangles: &mut triangles,
        scratch: &mut scratch,
    };
    grid::all(bench, &mut buffers);
    scene::all(bench, &mut buffers);
    strewn::all(bench, &mut buffers);
    texels::all(bench, &mut buffers);
    budget::all(bench, &mut buffers);
}

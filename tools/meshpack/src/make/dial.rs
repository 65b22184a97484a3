//! A gauge: a drawing in the plane, one layer over the other.

use super::surface::{corner, pack};
use crate::model::{Corner, Welder};
use crate::quantise::Packed;
use std::f64::consts::PI;

/// Corners of the disc, ticks on the scale, and where the needle points, of the scale.
const CORNERS: usize = 64;
const TICKS: usize = 31;
const SHOWN: f64 = 0.63;
/// The disc's radius in pixels.
const RADIUS: f64 = 112.0;
const INK: [u8; 3] = [24, 32, 44];
const PAPER: [u8; 3] = [240, 236, 220];
const RED: [u8; 3] = [214, 64, 60];

/// A disc of paper, ticks over three quarters of a turn, and a needle: one unit is one pixel, and layers are a quarter of a unit apart.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    let rim = |corner: usize| {
        let (sin, cos) = (2.0 * PI * (corner % CORNERS) as f64 / CORNERS as f64).sin_cos();
        point([RADIUS * cos, RADIUS * sin], 0.0)
    };
    for k in 0..CORNERS {
        welder.face([point([0.0; 2], 0.0), rim(k), rim(k + 1)], Some(PAPER));
    }
    for tick in 0..TICKS {
        let place = tick as f64 / (TICKS - 1) as f64;
        let long = tick % 5 == 0;
        let colour = if place > 0.8 { RED } else { INK };
        let inner = if long { 84.0 } else { 92.0 };
        bar(&mut welder, place, [inner, 104.0], if long { [1.75; 2] } else { [0.75; 2] }, 0.25, colour);
    }
    bar(&mut welder, SHOWN, [-20.0, 88.0], [4.0, 0.5], 0.5, RED);
    pack(welder, |model| model)
}

/// A bar along a place on the scale, from one radius to another, as wide on each side as it says at its ends.
fn bar(welder: &mut Welder, place: f64, radii: [f64; 2], widths: [f64; 2], layer: f64, colour: [u8; 3]) {
    // From lower left over the top to lower right.
    let (sin, cos) = ((1.25 - 1.5 * place) * PI).sin_cos();
    let at = |end: usize, side: f64| {
        let (along, across) = (radii[end], side * widths[end]);
        point([along * cos - across * sin, along * sin + across * cos], layer)
    };
    let [a, b, c, d] = [at(0, -1.0), at(1, -1.0), at(1, 1.0), at(0, 1.0)];
    welder.face([a, b, c], Some(colour));
    welder.face([a, c, d], Some(colour));
}

fn point([x, y]: [f64; 2], layer: f64) -> Corner {
    let uv = [0.5 + x / (2.0 * RADIUS), 0.5 - y / (2.0 * RADIUS)];
    corner([x, y, layer], [0.0, 0.0, 1.0], Some(uv))
}

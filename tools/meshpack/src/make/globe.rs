//! A sphere with a texture round it.

use super::surface::{corner, pack};
use crate::model::{Corner, Welder};
use crate::quantise::Packed;
use std::f64::consts::{PI, TAU};

/// Rings from pole to pole, and slices round the axis: together 1152 triangles.
const RINGS: usize = 25;
const SLICES: usize = 24;
/// Repeats of a texture round the axis, and from pole to pole.
const REPEATS: [f64; 2] = [4.0, 2.0];

/// A sphere of radius 1 about the y axis. At the poles each slice ends in one triangle.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    for ring in 0..RINGS {
        for slice in 0..SLICES {
            let [a, b, c, d] =
                [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(down, right)| point(ring + down, slice + right));
            if ring + 1 < RINGS {
                welder.face([a, b, c], None);
            }
            if ring > 0 {
                welder.face([a, c, d], None);
            }
        }
    }
    pack(welder, |model| model)
}

fn point(ring: usize, slice: usize) -> Corner {
    let [u, v] = [slice as f64 / SLICES as f64, ring as f64 / RINGS as f64];
    let (sin, cos) = (u * TAU).sin_cos();
    let (radius, height) = (v * PI).sin_cos();
    let position = [radius * sin, height, radius * cos];
    // A pole belongs to the middle of its slice, so that its triangle is upright in the texture.
    let u = if ring == 0 || ring == RINGS { u + 0.5 / SLICES as f64 } else { u };
    corner(position, position, Some([u * REPEATS[0], v * REPEATS[1]]))
}

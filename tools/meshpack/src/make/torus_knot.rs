//! The (2, 3) torus knot.

use super::surface::{Point, pack};
use crate::model::{Corner, Welder};
use crate::normals::{cross, unit};
use crate::quantise::Packed;
use std::f64::consts::TAU;

/// Rings along the knot, and points round each.
const RINGS: usize = 80;
const SIDES: usize = 8;
/// Repeats of a texture along the knot.
const REPEATS: f64 = 12.0;
/// Radii: of the torus, of its tube, and of the rope that is wound on it.
const TORUS: f64 = 1.0;
const WOUND: f64 = 0.45;
const ROPE: f64 = 0.22;

/// A rope that goes twice round the axis and three times round the tube of a torus.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    super::surface::sheet(&mut welder, RINGS, SIDES, |ring, side| Corner {
        colour: Some(rainbow(ring % RINGS)),
        ..point(ring, side).corner([0.0; 3])
    });
    pack(welder, |model| model.fit(1.0))
}

fn point(ring: usize, side: usize) -> Point {
    let angle = |index: usize, count: usize| (index % count) as f64 / count as f64 * TAU;
    let (t, around) = (angle(ring, RINGS), angle(side, SIDES));
    let (long, short) = (2.0 * t, 3.0 * t);
    let radius = TORUS + WOUND * short.cos();
    let centre = [radius * long.cos(), WOUND * short.sin(), radius * long.sin()];
    let along = [
        -3.0 * WOUND * short.sin() * long.cos() - 2.0 * radius * long.sin(),
        3.0 * WOUND * short.cos(),
        -3.0 * WOUND * short.sin() * long.sin() + 2.0 * radius * long.cos(),
    ];
    // The normal of the torus and its companion: a frame that closes after a turn.
    let out = [short.cos() * long.cos(), short.sin(), short.cos() * long.sin()];
    let side_way = unit(cross(out, along)).unwrap_or(out);
    let out = unit(cross(along, side_way)).unwrap_or(out);
    let (sin, cos) = around.sin_cos();
    let mix = |a: f64, b: f64| std::array::from_fn(|axis| out[axis] * a + side_way[axis] * b);
    let spoke: [f64; 3] = mix(cos, sin);
    Point {
        position: std::array::from_fn(|axis| centre[axis] + ROPE * spoke[axis]),
        right: mix(-sin, cos),
        // Straight along: the normal of the rope is its spoke.
        down: along,
        uv: [side as f64 / SIDES as f64, ring as f64 / RINGS as f64 * REPEATS],
    }
}

/// The bright colours in a circle, by ring.
fn rainbow(ring: usize) -> [u8; 3] {
    let channel = |shift: usize| {
        // A hill: up in a sixth of the way, a third at the top, down in a sixth.
        let place = (ring * 6 * 255 / RINGS + shift * 2 * 255) % (6 * 255);
        let height = place.min(6 * 255 - place) as i32;
        (2 * 255 - height).clamp(0, 255) as u8
    };
    [channel(0), channel(2), channel(1)].map(|value| value / 2 + 96)
}

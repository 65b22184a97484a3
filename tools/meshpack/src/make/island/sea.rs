//! The sea: a level ring from below the coast to the edge of the board.

use std::f64::consts::TAU;

use super::super::surface::{corner, pack, sheet};
use super::land::coast;
use crate::model::Welder;
use crate::quantise::Packed;

/// Segments of the board round its edge.
pub(super) const SEGMENTS: usize = 36;
/// Rings of the sea: so narrow that its texture needs no perspective.
const RINGS: usize = 2;
/// Where it begins, in parts of the way to the coast.
const BELOW: f64 = 0.95;
/// Repeats of a texture to the unit.
const REPEATS: f64 = 3.0;

pub(in super::super) fn make() -> Packed {
    let mut welder = Welder::default();
    // Rows go outwards and columns clockwise, which is to the right as seen from the middle.
    sheet(&mut welder, RINGS, SEGMENTS, |ring, segment| {
        let angle = -TAU * (segment % SEGMENTS) as f64 / SEGMENTS as f64;
        let inner = coast(angle) * BELOW;
        let radius = inner + (1.0 - inner) * ring as f64 / RINGS as f64;
        let [x, z] = [radius * angle.cos(), radius * angle.sin()];
        corner([x, 0.0, z], [0.0, 1.0, 0.0], Some([x * REPEATS, z * REPEATS]))
    });
    pack(welder, |model| model)
}

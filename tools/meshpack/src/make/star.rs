//! A star of slivers.

use super::surface::{corner, pack};
use crate::model::{Corner, Welder};
use crate::quantise::Packed;
use std::f64::consts::TAU;

const NEEDLES: usize = 360;
/// Where needles begin; they end at 1.
const HUB: f64 = 0.25;

/// Needles that stand side by side on a circle in the plane z = 0, each with the colour of a third of them.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    for needle in 0..NEEDLES {
        let at = |part: f64, radius: f64| point((needle as f64 + part) / NEEDLES as f64, radius);
        let colour = [[232, 140, 44], [66, 98, 200], [240, 236, 220]][needle % 3];
        welder.face([at(0.0, HUB), at(0.5, 1.0), at(1.0, HUB)], Some(colour));
    }
    pack(welder, |model| model)
}

/// Counter-clockwise, a texture's whole image over the star.
fn point(turn: f64, radius: f64) -> Corner {
    let (sin, cos) = (turn.fract() * TAU).sin_cos();
    let [x, y] = [radius * cos, radius * sin];
    corner([x, y, 0.0], [0.0, 0.0, 1.0], Some([(1.0 + x) / 2.0, (1.0 - y) / 2.0]))
}

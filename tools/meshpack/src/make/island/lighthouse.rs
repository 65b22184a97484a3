//! The lighthouse: a round tower with bands, a gallery, a lantern and a roof.

use std::f64::consts::TAU;

use super::super::surface::{corner, pack};
use super::land::height;
use crate::model::{Corner, Welder};
use crate::quantise::Packed;

const SIDES: usize = 8;
/// Where it stands.
const AT: [f64; 2] = [0.40, 0.22];
const RED: [u8; 3] = [216, 52, 44];
const WHITE: [u8; 3] = [250, 246, 236];
const IRON: [u8; 3] = [60, 62, 74];
const LAMP: [u8; 3] = [255, 224, 110];

/// Its outline from the top down: heights above its foot and radii; and the colour from there to the next.
const OUTLINE: [(f64, f64, [u8; 3]); 9] = [
    (0.60, 0.0, RED),
    (0.515, 0.068, IRON),
    (0.508, 0.045, LAMP),
    (0.44, 0.045, IRON),
    (0.425, 0.072, WHITE),
    (0.32, 0.060, RED),
    (0.21, 0.067, WHITE),
    (0.10, 0.075, RED),
    (-0.04, 0.086, RED),
];

/// Each band has vertices of its own, so that colours do not run from one into the next.
pub(in super::super) fn make() -> Packed {
    let mut welder = Welder::default();
    for pair in OUTLINE.windows(2) {
        let [(top, upper, colour), (bottom, lower, _)] = [pair[0], pair[1]];
        for side in 0..SIDES {
            // Clockwise as seen from above, which is to the left as seen from outside.
            let at = |height: f64, radius: f64, side: usize| {
                point([top - bottom, lower - upper], [height, radius], side, colour)
            };
            let (a, b) = (at(top, upper, side + 1), at(bottom, lower, side + 1));
            let (c, d) = (at(bottom, lower, side), at(top, upper, side));
            welder.face([a, b, c], None);
            welder.face([a, c, d], None);
        }
    }
    pack(welder, |model| model)
}

/// A point of a band that is so high and so much wider at its foot.
fn point([high, wider]: [f64; 2], [above, radius]: [f64; 2], side: usize, colour: [u8; 3]) -> Corner {
    let angle = TAU * (side % SIDES) as f64 / SIDES as f64;
    let (sin, cos) = angle.sin_cos();
    // At the tip of the roof the sides would share one vertex with a normal each: straight up for all.
    let normal = if radius > 0.0 { [cos * high, wider, sin * high] } else { [0.0, 1.0, 0.0] };
    let place = [AT[0] + radius * cos, height(AT) + above, AT[1] + radius * sin];
    Corner { colour: Some(colour), ..corner(place, normal, None) }
}

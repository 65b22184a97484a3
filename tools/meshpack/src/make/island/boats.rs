//! Boats under sail, counter-clockwise round the island as seen from above: the way in which scenes turn.

use std::f64::consts::TAU;

use super::super::surface::pack;
use super::{face, quad};
use crate::model::Welder;
use crate::quantise::Packed;

/// Where they are on their way round: parts of a turn, and distances from the middle.
const BOATS: [(f64, f64); 3] = [(0.0, 0.86), (0.36, 0.89), (0.7, 0.85)];

pub(in super::super) fn make() -> Packed {
    let mut welder = Welder::default();
    for (place, radius) in BOATS {
        boat(&mut welder, place * TAU, radius);
    }
    pack(welder, |model| model)
}

/// A hull of four sides and a deck, and a sail of two sides.
fn boat(welder: &mut Welder, angle: f64, radius: f64) {
    const HULL: [u8; 3] = [150, 84, 52];
    const DECK: [u8; 3] = [214, 168, 116];
    const SAIL: [u8; 3] = [252, 250, 244];
    let (sin, cos) = angle.sin_cos();
    // Along the way, to the inside of it, and up.
    let place = |along: f64, inside: f64, up: f64| {
        [(radius - inside) * cos + along * sin, up, (radius - inside) * sin - along * cos]
    };
    let (bow, stern) = (place(0.085, 0.0, 0.03), [place(-0.055, 0.024, 0.026), place(-0.055, -0.024, 0.026)]);
    let keel = [place(0.05, 0.0, -0.01), place(-0.045, 0.0, -0.01)];
    let [inner, outer] = stern;
    quad(welder, [bow, keel[0], keel[1], inner], HULL);
    quad(welder, [outer, keel[1], keel[0], bow], HULL);
    face(welder, [inner, keel[1], outer], HULL);
    face(welder, [bow, inner, outer], DECK);
    let (top, tack) = (place(0.0, 0.0, 0.17), place(0.055, 0.0, 0.035));
    // Filled by the wind: its two sides part.
    face(welder, [top, tack, place(-0.05, 0.018, 0.035)], SAIL);
    face(welder, [top, place(-0.05, 0.006, 0.035), tack], SAIL);
}

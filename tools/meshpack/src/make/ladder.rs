//! Pairs of parallel faces that are ever closer together: what a depth buffer can tell apart.

use super::surface::{corner, pack};
use crate::model::Welder;
use crate::quantise::Packed;

/// How much nearer to the eye the front one of each pair is.
const CLOSER: [f64; 6] = [0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
const HALF_WIDTH: f64 = 0.04;
const HALF_HEIGHT: f64 = 0.045;
/// From the middle of a rung to the middle of the next.
const STEP: f64 = 0.13;
/// How far a rung leans: its lower edge is nearer.
const LEAN: f64 = 0.05;

/// Six rungs one unit before an eye at the origin. The front face of a pair is the other one, closer to the eye by a
/// share of its distance: as the eye sees them they have the same outline. It comes second.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    for (rung, closer) in CLOSER.into_iter().enumerate() {
        let middle = STEP * (2.5 - rung as f64);
        for (share, colour) in [(1.0, [214, 64, 60]), (1.0 - closer, [64, 160, 84])] {
            let [a, b, c, d] = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|[u, v]: [f64; 2]| {
                let position = [
                    HALF_WIDTH * (2.0 * u - 1.0),
                    middle + HALF_HEIGHT * (1.0 - 2.0 * v),
                    LEAN * (2.0 * v - 1.0) - 1.0,
                ];
                let normal = [0.0, LEAN, HALF_HEIGHT].map(|c| c / LEAN.hypot(HALF_HEIGHT));
                corner(position.map(|c| c * share), normal, Some([u, v]))
            });
            welder.face([a, b, c], Some(colour));
            welder.face([a, c, d], Some(colour));
        }
    }
    pack(welder, |model| model)
}

//! A tessellated floor.

use super::surface::{corner, pack, sheet};
use crate::model::Welder;
use crate::quantise::Packed;

/// Tiles each way.
const TILES: usize = 8;
/// From the middle to an edge.
const HALF: f64 = 2.0;
/// Repeats of a texture each way.
const REPEATS: f64 = 4.0;

/// A level square. Seen from above with -z at the top, a texture is upright on it.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    sheet(&mut welder, TILES, TILES, |row, column| {
        let [u, v] = [column, row].map(|index| index as f64 / TILES as f64);
        let position = [HALF * (2.0 * u - 1.0), 0.0, HALF * (2.0 * v - 1.0)];
        corner(position, [0.0, 1.0, 0.0], Some([u * REPEATS, v * REPEATS]))
    });
    pack(welder, |model| model)
}

//! A corridor, and open ground: few large faces that reach from beside the viewer into the distance.

use super::surface::{corner, pack};
use crate::model::Welder;
use crate::normals::cross;
use crate::quantise::Packed;

/// Where the corridor begins, behind a viewer at 0, and where its end wall stands.
const ENDS: [f64; 2] = [0.5, -11.5];
/// Units of a texture's repeat, along and across.
const REPEAT: f64 = 2.0;
/// Repeats on the ground, each way.
const GROUND_REPEATS: f64 = 8.0;

/// Four walls 2 units apart along the z axis, seen from inside, and the one at the end.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    let [near, far] = ENDS;
    // Where a wall faces, and what is its right as seen from inside.
    for (normal, right) in [
        ([1.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
        ([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
        ([0.0, -1.0, 0.0], [1.0, 0.0, 0.0]),
        ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]),
    ] {
        let down = cross(right, normal);
        let side = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|[u, v]: [f64; 2]| {
            let place = |axis: usize| -> f64 {
                let at = right[axis] * (2.0 * u - 1.0) + down[axis] * (2.0 * v - 1.0) - normal[axis];
                // The z axis goes from one end to the other.
                if axis == 2 { if at > 0.0 { near } else { far } } else { at }
            };
            let position = [place(0), place(1), place(2)];
            let long = |axis: &[f64; 3]| if axis[2] == 0.0 { 2.0 } else { near - far } / REPEAT;
            corner(position, normal, Some([u * long(&right), v * long(&down)]))
        });
        let [a, b, c, d] = side;
        welder.face([a, b, c], None);
        welder.face([a, c, d], None);
    }
    pack(welder, |model| model)
}

/// A level square of two faces.
pub(super) fn ground() -> Packed {
    let mut welder = Welder::default();
    let [a, b, c, d] = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|[u, v]: [f64; 2]| {
        let position = [2.0 * u - 1.0, 0.0, 2.0 * v - 1.0];
        corner(position, [0.0, 1.0, 0.0], Some([u * GROUND_REPEATS, v * GROUND_REPEATS]))
    });
    welder.face([a, b, c], None);
    welder.face([a, c, d], None);
    pack(welder, |model| model)
}

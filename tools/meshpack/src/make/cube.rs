//! A cube.

use super::surface::{corner, pack};
use crate::model::Welder;
use crate::normals::cross;
use crate::quantise::Packed;

/// The sides: where they face, where their right is as seen from outside, and their colour.
const SIDES: [([f64; 3], [f64; 3], [u8; 3]); 6] = [
    ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [214, 64, 60]),
    ([1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [64, 160, 84]),
    ([0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [232, 140, 44]),
    ([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [66, 98, 200]),
    ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [240, 236, 220]),
    ([0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [240, 208, 64]),
];

/// Four vertices and two triangles a side, each side with a texture's whole image.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    for (normal, right, colour) in SIDES {
        let down = cross(right, normal);
        let [a, b, c, d] = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|[u, v]: [f64; 2]| {
            let position = std::array::from_fn(|axis| {
                normal[axis] + right[axis] * (2.0 * u - 1.0) + down[axis] * (2.0 * v - 1.0)
            });
            corner(position, normal, Some([u, v]))
        });
        welder.face([a, b, c], Some(colour));
        welder.face([a, c, d], Some(colour));
    }
    pack(welder, |model| model)
}

//! Surfaces made of rows and columns of points.

use crate::model::{Corner, Model, Welder};
use crate::normals::{cross, dot, of_face, subtract, unit};
use crate::quantise::Packed;
use std::path::Path;

/// A point of a surface and the directions in which it goes on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) position: [f64; 3],
    /// Along the rows: to the right, as seen from outside.
    pub(super) right: [f64; 3],
    /// Along the columns: down, as seen from outside.
    pub(super) down: [f64; 3],
    pub(super) uv: [f64; 2],
}

impl Point {
    /// The corner with the surface's normal, or with `pole` where the surface has none.
    pub(super) fn corner(&self, pole: [f64; 3]) -> Corner {
        let normal = unit(cross(self.down, self.right)).unwrap_or(pole);
        corner(self.position, normal, Some(self.uv))
    }
}

/// A corner whose values are on a grid of 2^-40, so that a sine or a cosine that differs in its last bit from one
/// machine to another changes nothing.
pub(super) fn corner(position: [f64; 3], normal: [f64; 3], uv: Option<[f64; 2]>) -> Corner {
    const STEPS: f64 = (1_u64 << 40) as f64;
    let snap = |value: f64| (value * STEPS).round() / STEPS;
    Corner {
        position: position.map(snap),
        normal: Some(normal.map(snap)),
        uv: uv.map(|uv| uv.map(snap)),
        colour: None,
    }
}

/// Adds the quads between `rows + 1` rows and `columns + 1` columns of corners, each as two triangles.
pub(super) fn sheet(
    welder: &mut Welder,
    rows: usize,
    columns: usize,
    corner: impl Fn(usize, usize) -> Corner,
) {
    for row in 0..rows {
        for column in 0..columns {
            let [a, b, c, d] =
                [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(down, right)| corner(row + down, column + right));
            welder.face([a, b, c], None);
            welder.face([a, c, d], None);
        }
    }
}

/// Closes a ring of points that lie in a plane, counter-clockwise as seen from outside, `repeats` of a texture to the
/// unit.
pub(super) fn cap(welder: &mut Welder, ring: &[[f64; 3]], repeats: f64) {
    let [first, .., last] = ring else { return };
    let middle = ring[ring.len() / 2];
    let Some(normal) = unit(of_face([*first, ring[ring.len() / 4], middle])) else { return };
    let Some(right) = unit(subtract(middle, *first)) else { return };
    let down = cross(right, normal);
    let place = |position: [f64; 3]| {
        let from = subtract(position, *first);
        corner(position, normal, Some([dot(from, right) * repeats, dot(from, down) * repeats]))
    };
    for pair in ring[1..].windows(2) {
        welder.face([place(*first), place(pair[0]), place(pair[1])], None);
    }
    debug_assert_ne!(first, last);
}

/// A cubic Bézier curve at `t`, and its derivative.
pub(super) fn bezier<const N: usize>(points: [[f64; N]; 4], t: f64) -> ([f64; N], [f64; N]) {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    let slopes = [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t];
    let sum = |weights: [f64; 4]| {
        std::array::from_fn(|axis| (0..4).map(|index| weights[index] * points[index][axis]).sum())
    };
    (sum(weights), sum(slopes))
}

/// The mesh that the welder holds, after `change`, packed with normals for its faces too.
pub(super) fn pack(welder: Welder, change: impl Fn(Model) -> Model) -> Packed {
    let model = change(welder.finish(Path::new("a made mesh"))).with_face_normals();
    model.quantise().expect("a made mesh fits the formats")
}

//! Convex meshes at random, and scenes of them one behind the other.

use proptest::collection::vec;
use proptest::prelude::*;
use topleft::{Length, Mesh, Pose, Turn};

/// The slices of a mesh.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    pub(crate) positions: Vec<[i16; 3]>,
    pub(crate) faces: Vec<[u16; 3]>,
}

impl Solid {
    pub(crate) fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.faces).expect("faces name vertices that are there")
    }
}

/// Six times the volume of a tetrahedron: positive where `d` lies in front of the plane through the others. Exact.
pub(crate) fn volume([a, b, c, d]: [[i16; 3]; 4]) -> i128 {
    let [u, v, w] = [b, c, d].map(|p| [0, 1, 2].map(|axis| i128::from(p[axis]) - i128::from(a[axis])));
    u[0] * (v[1] * w[2] - v[2] * w[1])
        + u[1] * (v[2] * w[0] - v[0] * w[2])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
}

/// The hull of points by brute force: every three of them that all others lie behind.
fn hull(positions: Vec<[i16; 3]>) -> Solid {
    let count = positions.len();
    let mut faces = Vec::new();
    for [i, j, k] in (0..count).flat_map(|i| (0..count).flat_map(move |j| (0..count).map(move |k| [i, j, k])))
    {
        let behind =
            |l: usize| [i, j, k].contains(&l) || volume([i, j, k, l].map(|corner| positions[corner])) < 0;
        if i < j && i < k && j != k && (0..count).all(behind) {
            faces.push([i as u16, j as u16, k as u16]);
        }
    }
    Solid { positions, faces }
}

/// A box, each side as long as it likes, as two triangles a side.
fn block([x, y, z]: [i16; 3]) -> Solid {
    let positions = (0..8)
        .map(|corner: i16| {
            [(x, 1), (y, 2), (z, 4)].map(|(half, bit)| if corner & bit == 0 { -half } else { half })
        })
        .collect();
    let sides = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    Solid { positions, faces: sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect() }
}

/// Boxes, and hulls of up to ten points.
pub(crate) fn solid() -> impl Strategy<Value = Solid> {
    let component = -32_767..=32_767_i16;
    let point = [component.clone(), component.clone(), component];
    let side = 2_000..=32_767_i16;
    prop_oneof![[side.clone(), side.clone(), side].prop_map(block), vec(point, 4..10).prop_map(hull),]
}

/// A solid somewhere: turned, so far beyond the one before, so large as a share of its distance, and beside the axis.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) solid: Solid,
    turns: [u16; 3],
    beyond: f64,
    size: f64,
    beside: [f64; 2],
}

pub(crate) fn placed() -> impl Strategy<Value = Placed> {
    (solid(), any::<[u16; 3]>(), -0.3..0.8, 0.02..0.3, [-0.15..0.15, -0.15..0.15])
        .prop_map(|(solid, turns, beyond, size, beside)| Placed { solid, turns, beyond, size, beside })
}

/// The poses of solids that stand one behind the other, from `near` on, along the scene's -z. Some overlap a little.
pub(crate) fn poses(placed: &[Placed], near: f64) -> Vec<Pose> {
    let mut end = near * 0.8;
    let place = |thing: &Placed| {
        // Cubes turned have a radius of up to 1.7 of their half.
        let distance = end * (1.0 + thing.beyond) / (1.0 - 1.2 * thing.size);
        end = distance * (1.0 + 1.2 * thing.size);
        let [x, y] = thing.beside.map(|part| Length::saturating_from_num(part * distance));
        let [a, b, c] = thing.turns.map(Turn::new);
        Pose::new()
            .turned_x(a)
            .turned_y(b)
            .turned_z(c)
            .scaled(Length::saturating_from_num(thing.size * distance))
            .at([x, y, Length::saturating_from_num(-distance)])
    };
    placed.iter().map(place).collect()
}

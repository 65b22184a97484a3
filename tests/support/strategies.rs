//! Inputs biased to where rasterizers fail: ties on pixel centres, slivers, lattices, boxes as large as the guard
//! rectangle. All shrink.

use embedded_graphics::prelude::Size;
use proptest::collection::vec;
use proptest::prelude::*;
use reference::setup::Triangle;
use topleft::stages::Window;
use topleft::{Mesh, Viewport};

/// A triangle in 1/256 px, and the part of the screen where it is looked at.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) triangle: Triangle,
    pub(crate) window: Window,
}

/// The steps of a coordinate in pixel `whole`: which, says `kind`.
fn steps(kind: u8, whole: i32, within: i32) -> i32 {
    whole * 256
        + match kind % 4 {
            // Anywhere.
            0 => within,
            // On the half-pixel lattice.
            1 => (within & 1) * 128,
            // On a pixel centre, or one or two steps beside it.
            2 => 126 + within % 5,
            // On centres alone: ties everywhere.
            _ => 128,
        }
}

/// A point of `columns` by `rows` pixels: on a lattice, near a centre, or anywhere.
fn point_in(columns: i32, rows: i32) -> impl Strategy<Value = [i32; 2]> {
    (any::<[u8; 2]>(), -4..columns, -4..rows, any::<[u8; 2]>())
        .prop_map(|([kx, ky], x, y, [fx, fy])| [steps(kx, x, i32::from(fx)), steps(ky, y, i32::from(fy))])
}

/// A window from somewhere in the first rows and columns on.
fn window(columns: i32, rows: i32) -> impl Strategy<Value = Window> {
    (0..4, 0..rows, 1..=columns, 1..=rows).prop_map(|(left, top, width, height)| Window {
        columns: left..left + width,
        rows: top..top + height,
    })
}

/// Three points of a box, many of them ties: small triangles, and flat ones.
pub(crate) fn near_ties(columns: i32, rows: i32) -> impl Strategy<Value = Case> {
    let point = || point_in(columns, rows);
    ([point(), point(), point()], window(columns, rows))
        .prop_map(|(triangle, window)| Case { triangle, window })
}

/// Needles: the third point lies within three steps, or a quarter of a pixel, of the line through the others, between
/// them or beyond.
pub(crate) fn slivers(columns: i32, rows: i32) -> impl Strategy<Value = Case> {
    let ends = [point_in(columns, rows), point_in(columns, rows)];
    let window = (0..rows, 1..=rows)
        .prop_map(move |(top, height)| Window { columns: 0..columns, rows: top..top + height });
    (ends, -64..=320, [-3..=3, -3..=3], any::<bool>(), 0..3_usize, window).prop_map(
        |([a, b], part, beside, wider, turn, window)| {
            let wide = if wider { 21 } else { 1 };
            let c = [0, 1].map(|axis| a[axis] + (b[axis] - a[axis]) * part / 256 + beside[axis] * wide);
            let mut triangle = [a, b, c];
            triangle.rotate_left(turn);
            Case { triangle, window }
        },
    )
}

/// Sizes of targets: usual ones, the largest, and the longest.
pub(crate) const SIZES: [[u32; 2]; 8] =
    [[240, 240], [320, 240], [800, 480], [1920, 1080], [2890, 2890], [8190, 1], [1, 4094], [1, 1]];

/// Triangles as large as the guard rectangle of some target, seen through a window of up to 40 px on one of the edges.
pub(crate) fn guard_sized() -> impl Strategy<Value = Case> {
    let corner = || any::<[(u8, u32); 2]>();
    ([corner(), corner(), corner()], 0..SIZES.len(), 0..3_usize, 0..=1024_i64, [-20..20_i32, -20..20])
        .prop_map(|(corners, size, edge, part, beside)| {
            let [width, height] = SIZES[size];
            let viewport = Viewport::new(Size::new(width, height)).expect("these sizes are allowed");
            let margin = i32::from(viewport.margin()) * 256;
            let size = [width, height].map(u32::cast_signed);
            let place = |(kind, within): (u8, u32), length: i32| {
                let (low, high) = (-margin, length * 256 + margin);
                let near = (within % 520).cast_signed();
                match kind % 8 {
                    0 => low,
                    1 => high,
                    2 => low + near,
                    3 => high - near,
                    4 => (within % (length * 2 + 1).cast_unsigned()).cast_signed() * 128,
                    _ => low + ((u64::from(within) * u64::from(low.abs_diff(high))) >> 32) as i32,
                }
            };
            let triangle = corners.map(|[x, y]| [place(x, size[0]), place(y, size[1])]);
            let (from, to) = (triangle[edge], triangle[(edge + 1) % 3]);
            let range = |axis: usize| {
                let along = i64::from(to[axis]) - i64::from(from[axis]);
                let centre =
                    (i64::from(from[axis]) + along * part / 1024).div_euclid(256) as i32 + beside[axis];
                let start = centre.clamp(0, size[axis] - 1);
                start..(start + 20).min(size[axis])
            };
            Case { triangle, window: Window { columns: range(0), rows: range(1) } }
        })
}

/// The slices of a mesh with all its attributes.
#[derive(Clone, Debug)]
pub(crate) struct MeshData {
    pub(crate) positions: Vec<[i16; 3]>,
    pub(crate) faces: Vec<[u16; 3]>,
    normals: Vec<[i8; 3]>,
    face_normals: Vec<[i8; 3]>,
    uvs: Vec<[i16; 2]>,
    vertex_colours: Vec<[u8; 3]>,
    face_colours: Vec<[u8; 3]>,
}

impl MeshData {
    /// The mesh, in the cube from -1 to 1.
    pub(crate) fn mesh(&self) -> Mesh<'_> {
        self.with_faces(&self.faces)
    }

    /// The mesh with other faces, as many.
    pub(crate) fn with_faces<'a>(&'a self, faces: &'a [[u16; 3]]) -> Mesh<'a> {
        Mesh::new(&self.positions, faces)
            .and_then(|mesh| mesh.with_normals(&self.normals))
            .and_then(|mesh| mesh.with_face_normals(&self.face_normals))
            .and_then(|mesh| mesh.with_uvs(&self.uvs, 2))
            .and_then(|mesh| mesh.with_vertex_colours(&self.vertex_colours))
            .and_then(|mesh| mesh.with_face_colours(&self.face_colours))
            .expect("every slice has its length")
    }
}

/// A soup of triangles that share vertices, lie through each other, and have any attributes.
pub(crate) fn mesh_data() -> impl Strategy<Value = MeshData> {
    (3..10_usize, 1..8_usize).prop_flat_map(|(vertices, faces)| {
        let index = 0..vertices as u16;
        (
            vec(any::<[i16; 3]>(), vertices),
            vec([index.clone(), index.clone(), index], faces),
            vec(any::<[i8; 3]>(), vertices),
            vec(any::<[i8; 3]>(), faces),
            vec(any::<[i16; 2]>(), vertices),
            vec(any::<[u8; 3]>(), vertices),
            vec(any::<[u8; 3]>(), faces),
        )
            .prop_map(
                |(positions, faces, normals, face_normals, uvs, vertex_colours, face_colours)| MeshData {
                    positions,
                    faces,
                    normals,
                    face_normals,
                    uvs,
                    vertex_colours,
                    face_colours,
                },
            )
    })
}

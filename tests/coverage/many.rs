//! Randomised meshes until each traversal was compared at 10^8 pixels, and hit as many.
//!
//! `cargo test --release --test coverage -- --nocapture hundred_million` does it as chips do, without overflow checks.

use std::cell::Cell;

use embedded_graphics::prelude::Size;
use proptest::collection::vec;
use proptest::prelude::*;
use scenes::mesh::{ICOSPHERE, TEAPOT, TORUS_KNOT};
use topleft::{Camera, Length, Mesh, Orthographic, Perspective, Pose, Turn};

use crate::support::check;
use crate::support::exact::compare_mesh;
use crate::support::measured::{Row, hold};

/// Pixels that are compared, and pixels that each traversal hits, at the least.
const PIXELS: u64 = 100_000_000;
const MESHES: u32 = 2_000;

/// A mesh, and from where it is seen.
#[derive(Clone, Debug)]
struct View {
    positions: Vec<[i16; 3]>,
    faces: Vec<[u16; 3]>,
    size: [u32; 2],
    turns: [u16; 3],
    scale: i32,
    eye: [f32; 3],
    target: [f32; 3],
    /// The field of view in degrees; without one, there is no perspective.
    field: Option<i32>,
    near: f32,
    far: f32,
}

/// Faces of any three vertices, which stand in clusters from a 4096th of the mesh's cube to all of it.
fn soups() -> impl Strategy<Value = (Vec<[i16; 3]>, Vec<[u16; 3]>)> {
    (3..300_u16, 1..500_usize).prop_flat_map(|(vertices, faces)| {
        let cluster = (any::<[i16; 3]>(), 0..13_u32, vec(any::<[i16; 3]>(), 3..40));
        // Of three neighbours, most of which are of one cluster, or of any three.
        let face = (0..vertices, [0..4_u16, 0..4], any::<[u16; 2]>(), 0..8_u8).prop_map(
            move |(first, beside, any, kind)| {
                let others = if kind == 0 { any } else { beside.map(|by| first + by) };
                [first % vertices, others[0] % vertices, others[1] % vertices]
            },
        );
        (vec(cluster, usize::from(vertices).div_ceil(3)), vec(face, faces)).prop_map(
            move |(clusters, faces)| {
                let positions = clusters.into_iter().flat_map(|(centre, size, points)| {
                    points.into_iter().map(move |point| {
                        [0, 1, 2].map(|axis| (point[axis] >> size).saturating_add(centre[axis]))
                    })
                });
                (positions.take(vertices.into()).collect(), faces)
            },
        )
    })
}

/// Closed meshes whose vertices are moved, so that faces lie through each other and some turn over.
fn crumpled() -> impl Strategy<Value = (Vec<[i16; 3]>, Vec<[u16; 3]>)> {
    let mesh = prop::sample::select(vec![ICOSPHERE, TORUS_KNOT, TEAPOT]);
    (mesh, 4..16_u32, any::<u64>()).prop_map(|(mesh, size, seed)| {
        let mut random = seed;
        let mut moved = |c: i16| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            c.saturating_add((random >> 48) as i16 >> size)
        };
        (mesh.positions().iter().map(|at| at.map(&mut moved)).collect(), mesh.faces().to_vec())
    })
}

fn views() -> impl Strategy<Value = View> {
    let mesh = prop_oneof![3 => soups().boxed(), 1 => crumpled().boxed()];
    let sizes = prop::sample::select(vec![[240, 240], [320, 240], [61, 97], [480, 320], [1024, 16]]);
    let place = (any::<[u16; 3]>(), 20_000..200_000_i32, [-2.0..2.0_f32, -2.0..2.0, -2.0..2.0]);
    let target = [-0.5..0.5_f32, -0.5..0.5, -0.5..0.5];
    let depth = (prop::sample::select(vec![0.01_f32, 0.2, 1.0]), 0.5..6.0_f32);
    let camera = (target, prop::option::weighted(0.8, 10..130), depth);
    (mesh, sizes, place, camera).prop_map(|(mesh, size, place, camera)| {
        let ((positions, faces), (turns, scale, eye), (target, field, (near, depth))) = (mesh, place, camera);
        View { positions, faces, size, turns, scale, eye, target, field, near, far: near + depth }
    })
}

/// What was compared.
#[derive(Default)]
struct Counts {
    meshes: Cell<u64>,
    clipped: Cell<u64>,
    triangles: Cell<u64>,
    pixels: Cell<u64>,
    hits: Cell<u64>,
}

fn add(count: &Cell<u64>, more: usize) {
    count.set(count.get() + more as u64);
}

impl View {
    fn compare(&self, counts: &Counts) -> Result<(), String> {
        let size = Size::new(self.size[0], self.size[1]);
        let depth = self.near..self.far;
        match self.field {
            Some(degrees) => {
                let camera = Perspective::new(size, Turn::from_degrees(degrees), depth);
                self.seen_by(&camera.look_at(self.eye, self.target), counts)
            }
            None => {
                let camera = Orthographic::new(size, 1.5, depth);
                self.seen_by(&camera.look_at(self.eye, self.target), counts)
            }
        }
    }

    fn seen_by(&self, camera: &impl Camera, counts: &Counts) -> Result<(), String> {
        let mesh = Mesh::new(&self.positions, &self.faces).map_err(|error| error.to_string())?;
        let [x, y, z] = self.turns.map(Turn::new);
        let pose = Pose::new().turned_x(x).turned_y(y).turned_z(z).scaled(Length::from_bits(self.scale));
        let (polygons, hits) = compare_mesh(camera, &mesh, &pose)?;
        add(&counts.meshes, 1);
        add(&counts.clipped, polygons.clipped);
        add(&counts.triangles, polygons.triangles().count());
        add(&counts.pixels, hits.len());
        add(&counts.hits, hits.iter().sum::<i32>() as usize);
        Ok(())
    }
}

/// That meshes hit each pixel as often as their triangles do, exactly.
pub(crate) fn meshes() -> Row {
    let counts = Counts::default();
    check(MESHES, &views(), |view| view.compare(&counts));
    let Counts { meshes, clipped, triangles, pixels, hits } = counts;
    assert!(hits.get() >= PIXELS && pixels.get() >= PIXELS);
    assert!(clipped.get() * 20 > triangles.get(), "hardly any face was clipped");
    let drawn = format!("px hit; {} meshes with {} triangles", meshes.get(), triangles.get());
    Row::none_of(hits.get(), &drawn, "coverage", "random meshes", "spans and box walk")
}

// Red when one pixel in 10^8 is hit once too often or too rarely, from the list's clipped vertices on.
#[test]
fn a_hundred_million_pixels_of_random_meshes_are_exact() {
    hold(&[meshes()]);
}

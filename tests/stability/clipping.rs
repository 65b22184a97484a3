//! Rows 10 to 12: vertices on the eye's plane and behind it, and edges that are cut in two triangles.

use std::cell::Cell;

use embedded_graphics::prelude::*;
use proptest::prelude::*;
use reference::clip::{ClipVertex, clip};
use reference::matrix::{Matrix, Vec4};
use reference::naive::near;
use reference::raster::coverage_counts;
use reference::setup::{Triangle, fan, snap};
use reference::transform::{Viewport, model_position};
use topleft::{Length, MatrixCamera, Mesh, Pose};

use crate::edges::to_edges;
use crate::figure::{grouped, unsigned};
use crate::support::check;
use crate::support::counter::{ALL, draw};
use crate::support::exact::compare_mesh;
use crate::support::polygons::polygons;
use crate::support::tolerance::{self, vertex_on_screen};

const VIEW: Viewport = Viewport { width: 64, height: 48 };
pub(crate) const SIZE: Size = Size::new(64, 48);
/// Where the near plane is; positions reach from -1 to 1.
const NEAR: f64 = 1.0 / 64.0;

/// A camera at the origin that looks along z, exactly: w is z, and the near plane is at 1/64.
fn eye() -> MatrixCamera<true> {
    let (o, one) = (Length::ZERO, Length::ONE);
    let near = Length::from_num(-NEAR);
    MatrixCamera::new(
        SIZE,
        topleft::Matrix::new([[one, o, o, o], [o, one, o, o], [o, o, one, near], [o, o, one, o]]),
    )
}

/// The same for the reference.
const EYE: Matrix =
    Matrix([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, -NEAR], [0.0, 0.0, 1.0, 0.0]]);

/// What is seen of triangles that reach behind the eye, in pixels.
#[derive(Clone, Debug, Default)]
pub(crate) struct Seen {
    /// Pixels that should be drawn.
    pub(crate) visible: Cell<u64>,
    /// Of them those that are drawn where every w is divided by, and those that are drawn and should not be.
    pub(crate) by_any_w: Cell<u64>,
    pub(crate) mirrored: Cell<u64>,
    /// Of the visible those drawn where triangles are skipped.
    pub(crate) not_skipped: Cell<u64>,
    /// Triangles with a w of 0, or a 1/w that Q16.16 does not hold.
    pub(crate) without_inverse: Cell<u64>,
    /// Pixels that `topleft` draws otherwise, all of them within the bound of an edge.
    pub(crate) on_an_edge: Cell<u64>,
}

fn add(sum: &Cell<u64>, more: usize) {
    sum.set(sum.get() + more as u64);
}

impl Seen {
    /// One triangle, alone in the cube from -1 to 1.
    fn add(&self, positions: [[i16; 3]; 3]) -> Result<(), String> {
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).map_err(|error| format!("{error:?}"))?;
        let mesh = mesh.with_box([Length::ZERO; 3], Length::ONE);
        let clips: [Vec4; 3] = [0, 1, 2].map(|vertex| EYE.apply_point(model_position(&mesh, vertex)));
        let polygon = clip(clips.map(|position| ClipVertex { position, varyings: [] }), &[]);
        let places: Vec<[f64; 2]> = polygon.iter().map(|vertex| VIEW.to_screen(vertex.position)).collect();
        let snapped: Vec<[i32; 2]> =
            places.iter().map(|place| place.map(|c| snap(c).expect("finite"))).collect();
        let parts: Vec<Triangle> = fan(&snapped).into_iter().map(|part| part.map(|i| snapped[i])).collect();
        let right = coverage_counts(&parts, VIEW);
        add(&self.visible, right.iter().filter(|&&hits| hits > 0).count());

        let by_any_w = near::divided_by_any_w(clips, VIEW);
        for (hits, right) in coverage_counts(by_any_w.as_slice(), VIEW).iter().zip(&right) {
            let kept = if *right > 0 { &self.by_any_w } else { &self.mirrored };
            add(kept, usize::from(*hits > 0));
        }
        let skipped = coverage_counts(near::skipped_if_behind(clips, VIEW).as_slice(), VIEW);
        add(
            &self.not_skipped,
            skipped.iter().zip(&right).filter(|&(hits, right)| *hits > 0 && *right > 0).count(),
        );
        let none = clips.iter().any(|&[.., w]| near::inverse_in_q16((w * 65_536.0) as i32).is_none());
        add(&self.without_inverse, usize::from(none));

        // The largest element of the camera and of the pose is 1, and two elements of w are at most 1 together.
        let error = tolerance::clip(1.0, 2.0);
        let moved = polygon.iter().zip(&places).map(|(vertex, [x, y])| {
            1.0 + vertex_on_screen(error, vertex.position[3], 32.0, (x - 32.0).hypot(y - 24.0))
        });
        let band = moved.fold(0.0, f64::max) * 2.0_f64.sqrt();
        let ours = unsigned(&draw(&eye(), &mesh, &Pose::new(), ALL).hits);
        for (index, (&ours, &right)) in ours.iter().zip(&right).enumerate() {
            if ours == right {
                continue;
            }
            add(&self.on_an_edge, 1);
            let (x, y) = ((index % 64) as i64, (index / 64) as i64);
            let away = parts.iter().map(|&part| to_edges(part, x, y)).fold(f64::INFINITY, f64::min);
            if ours > 1 || away > band {
                return Err(format!(
                    "{ours} hits instead of {right} at {x}, {y}; {away} of {band} steps away"
                ));
            }
        }
        Ok(())
    }
}

/// A vertex in view: z from a quarter to 1, and less than z aside.
pub(crate) fn in_view() -> impl Strategy<Value = [i16; 3]> {
    (8_192..32_767_i32, [-1000..=1000_i32, -1000..=1000_i32])
        .prop_map(|(z, aside)| [(aside[0] * z / 1000) as i16, (aside[1] * z / 1000) as i16, z as i16])
}

/// Triangles of two vertices in view and one on the eye's plane or within three steps of it.
pub(crate) fn on_the_eye() -> Seen {
    let seen = Seen::default();
    let near = [-32_767..=32_767_i16, -32_767..=32_767_i16, -3..=3_i16];
    check(3_000, &(in_view(), in_view(), near, 0..3_usize), |(a, b, near, place)| {
        let mut positions = [a, b, near];
        positions.rotate_left(place);
        seen.add(positions)
    });
    seen
}

// Red when no near plane is cut, or clipped vertices are computed with fewer bits: `Outcode::new`, `crossing`.
#[test]
fn row_10_a_vertex_on_the_plane_of_the_eye_has_no_inverse() {
    let seen = on_the_eye();
    println!(
        "row 10, 1/w in Q16.16: none for {} of 3 000 triangles; topleft {} of {} px differ, on an edge",
        grouped(seen.without_inverse.get()),
        seen.on_an_edge.get(),
        grouped(seen.visible.get())
    );
    // w is 0, or one step of 2^-15 = two of Q16.16: 2^31, which is one too large; or -2^31, which fits. Of seven places
    // those are 0 and 1: two in seven, less a fifth for chance.
    assert!(seen.without_inverse.get() * 7 > 3_000 * 2 * 4 / 5);
    assert!(seen.visible.get() > 100_000);
}

/// Triangles of one or two vertices behind the eye.
pub(crate) fn behind() -> Seen {
    let seen = Seen::default();
    let behind = || [-32_767..=32_767_i16, -32_767..=32_767_i16, -32_767..=-700_i16];
    let second = prop_oneof![in_view().boxed(), behind().boxed()];
    check(3_000, &(in_view(), second, behind(), 0..3_usize), |(a, b, behind, place)| {
        let mut positions = [a, b, behind];
        positions.rotate_left(place);
        seen.add(positions)
    });
    seen
}

// Red when a triangle is left out because one of its vertices is behind, or the second triangle of its polygon is.
#[test]
fn row_11_what_reaches_behind_the_eye_is_mirrored_or_vanishes() {
    let seen = behind();
    println!(
        "row 11, divided by any w: {} of {} visible px drawn, {} mirrored; skipped: {}; topleft {} px differ, on an edge",
        grouped(seen.by_any_w.get()),
        grouped(seen.visible.get()),
        grouped(seen.mirrored.get()),
        grouped(seen.not_skipped.get()),
        seen.on_an_edge.get()
    );
    // What is divided by a negative w lies on the other side of the edge, or of the vertex, that is in view: no pixel of
    // what is visible is drawn, but for those on that edge that rounding gives to both: one in ten thousand is ample.
    assert!(seen.by_any_w.get() * 10_000 <= seen.visible.get());
    assert!(seen.visible.get() > 100_000 && seen.mirrored.get() > 10_000);
    assert_eq!(seen.not_skipped.get(), 0);
}

/// A vertex that comes nearer through the near plane, a 32768th of a unit a frame: the pixels that triangles skipped for
/// it lose from one frame to the next, and the most that `topleft` changes.
pub(crate) fn through_the_near_plane() -> (u64, usize) {
    let (lost, most) = (Cell::new(0), Cell::new(0));
    check(500, &(in_view(), in_view(), [-500..=500_i16, -500..=500_i16]), |(a, b, [x, y])| {
        let frame = |z: i16| {
            let positions = [a, b, [x, y, z]];
            let mesh = Mesh::new(&positions, &[[0, 1, 2]]).expect("three vertices");
            let mesh = mesh.with_box([Length::ZERO; 3], Length::ONE);
            let clips = [0, 1, 2].map(|vertex| EYE.apply_point(model_position(&mesh, vertex)));
            let skipped = coverage_counts(near::skipped_if_behind(clips, VIEW).as_slice(), VIEW);
            (skipped.iter().sum::<u32>(), draw(&eye(), &mesh, &Pose::new(), ALL).hits)
        };
        // The near plane is at 512.
        let mut before = frame(516);
        for z in (508..516).rev() {
            let now = frame(z);
            if z == 511 {
                add(&lost, (before.0 - now.0) as usize);
            }
            let changed = before.1.iter().zip(&now.1).filter(|(a, b)| a != b).count();
            most.set(most.get().max(changed));
            before = now;
        }
        Ok(())
    });
    (lost.get(), most.get())
}

// Red when a triangle is left out because the near plane cuts it: all of it goes at once.
#[test]
fn row_11_a_triangle_pops_where_its_vertex_crosses_the_near_plane() {
    let (lost, most) = through_the_near_plane();
    println!(
        "row 11, skipped: {} px of 500 triangles vanish in one frame; topleft changes {most} px of one at most",
        grouped(lost)
    );
    // Three points of a rectangle have 11/144 of it between them on average; half of that for chance.
    assert!(lost > 500 * 64 * 48 * 11 / 144 / 2);
    // The vertex moves by 32/512 px and 1/256 for its rounding, and so no centre but one a column, or a row, of 64 is
    // passed by either of its two edges. What is cut off of it is moved by 65 535 / 7 680 steps of 1/16 px along them:
    // below a pixel, so two of a row and of the next.
    assert!(most <= 2 * 64 + 4);
}

/// Edges cut in both of their triangles: of how many the two crossings are snapped apart in `f32` and in Q16.16, how far
/// at most in steps; and how many pairs share a vertex that `topleft` made.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shared {
    pub(crate) in_f32: Cell<u64>,
    pub(crate) in_q16: Cell<u64>,
    pub(crate) furthest: Cell<i32>,
    pub(crate) ours: Cell<u64>,
}

pub(crate) fn shared_edges() -> Shared {
    let shared = Shared::default();
    let units = 0.0..1.0_f64;
    let ends = (units.clone(), units.clone(), units);
    let eye = eye();
    let behind = || [-32_767..=32_767_i16, -32_767..=32_767_i16, -32_767..=0_i16];
    // Two triangles on either side of an edge from a vertex in view to one behind.
    check(
        3_000,
        &(ends, in_view(), behind(), in_view(), in_view()),
        |((s, t, u), front, back, left, right)| {
            // 160 px of focal length, near at 0.1: an x from -0.1 to 0.1 is seen there.
            let inside = [4.0 + 4.0 * s, 0.2 + 4.0 * t];
            let outside = [-4.0 * u, -4.0 * t - 0.1];
            let steps = |x: f64| (x / 0.1 * 160.0 * 256.0).round() as i32;
            let floats = [inside, outside].map(|end| end.map(|c| c as f32));
            let [f, g] = [[0, 1], [1, 0]].map(|[a, b]| near::crossing_in_f32(floats[a], floats[b], 0.1));
            shared.in_f32.set(shared.in_f32.get() + u64::from(steps(f64::from(f)) != steps(f64::from(g))));
            let fixed = [inside, outside].map(|end| end.map(|c| (c * 65_536.0) as i32));
            let [f, g] = [[0, 1], [1, 0]].map(|[a, b]| near::crossing_in_q16(fixed[a], fixed[b], 6_554));
            let [f, g] = [f, g].map(|x| steps(f64::from(x) / 65_536.0));
            shared.in_q16.set(shared.in_q16.get() + u64::from(f != g));
            shared.furthest.set(shared.furthest.get().max((f - g).abs()));

            let positions = [front, back, left, right];
            let alone = |face: [u16; 3]| {
                let faces = [face];
                let mesh = Mesh::new(&positions, &faces).expect("four vertices");
                polygons(&eye, &mesh.with_box([Length::ZERO; 3], Length::ONE), &Pose::new()).made
            };
            let (one, other) = (alone([0, 1, 2]), alone([3, 1, 0]));
            shared.ours.set(shared.ours.get() + u64::from(one.intersection(&other).next().is_some()));
            let faces = [[0, 1, 2], [3, 1, 0]];
            let mesh = Mesh::new(&positions, &faces).expect("four vertices");
            compare_mesh(&eye, &mesh.with_box([Length::ZERO; 3], Length::ONE), &Pose::new()).map(|_| ())
        },
    );
    shared
}

// Red when a crossing is computed from the vertex that comes first: `cut` in src/clip.rs.
#[test]
fn row_12_an_edge_cut_from_either_end_is_torn() {
    let shared = shared_edges();
    println!(
        "row 12, cut from either end in f32: {} of 3 000 vertices differ; in Q16.16: {}, by up to {} steps; topleft {}",
        grouped(shared.in_f32.get()),
        grouped(shared.in_q16.get()),
        shared.furthest.get(),
        3_000 - shared.ours.get()
    );
    // A step of an f32 between 4 and 8, where the inside end lies, is 2^-21: a fifth of a step on the screen, 0.1 / 160 /
    // 256. Results that differ by one are rounded apart in one of five. One in ten that differ gives 60.
    assert!(shared.in_f32.get() >= 60);
    // Both parts of the edge are rounded down, so they miss a whole by 2^-16, of 4 units or more: 25 steps. No part but
    // one of 16 bits is exact, and its neighbours are one in 2^16.
    assert!(shared.in_q16.get() >= 2_990 && shared.furthest.get() >= 25);
    assert_eq!(shared.ours.get(), 3_000);
}

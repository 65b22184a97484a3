//! Which meshes are convex, against products of 128 bits.

use proptest::collection::vec;
use proptest::prelude::*;
use scenes::SCENES;
use topleft::Mesh;

use crate::solids::{Solid, solid, volume};
use crate::support::check;

/// By definition: no vertex is in front of a face, or none is behind one; and no face has three corners in a row, in three
/// places.
fn is_convex(positions: &[[i16; 3]], faces: &[[u16; 3]]) -> bool {
    [1, -1].iter().any(|side| all_on_one(positions, faces, *side))
}

fn all_on_one(positions: &[[i16; 3]], faces: &[[u16; 3]], side: i128) -> bool {
    faces.iter().all(|face| {
        let [a, b, c] = face.map(|corner| positions[usize::from(corner)]);
        // Out of a face's plane something lies somewhere: in a row, nothing does.
        let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        let flat = axes.iter().all(|axis| {
            let beside = [0, 1, 2].map(|i| if a[i] == i16::MAX { a[i] - axis[i] } else { a[i] + axis[i] });
            volume([a, b, c, beside]) == 0
        });
        if flat {
            a == b || b == c || c == a
        } else {
            positions.iter().all(|&p| side * volume([a, b, c, p]) <= 0)
        }
    })
}

// Red when a plane is one vertex's that is not its face's, when a side is taken for the other, or products have 32 bits.
#[test]
fn hulls_are_convex_and_with_a_vertex_pushed_in_or_out_as_the_reference_says() {
    let found = std::cell::Cell::new([0; 2]);
    let pushed = (solid(), any::<prop::sample::Index>(), any::<[i16; 3]>(), any::<bool>());
    check(3000, &pushed, |(solid, vertex, to, push)| {
        let mut solid: Solid = solid;
        if !solid.mesh().is_convex() {
            return Err("a hull is not convex".into());
        }
        if push {
            let vertex = vertex.index(solid.positions.len());
            solid.positions[vertex] = to;
        }
        let expected = is_convex(&solid.positions, &solid.faces);
        let mut counts = found.get();
        counts[usize::from(expected)] += 1;
        found.set(counts);
        if solid.mesh().is_convex() != expected {
            return Err(format!("not {expected}"));
        }
        // Inside out it is a room.
        solid.faces.iter_mut().for_each(|[a, b, _]| core::mem::swap(a, b));
        if solid.mesh().is_convex() == expected { Ok(()) } else { Err(format!("inside out, not {expected}")) }
    });
    let [not, yes] = found.get();
    println!("{yes} convex, {not} not");
    assert!(yes > 1500 && not > 500, "{yes} {not}");
}

// Red when a face without area has a plane, or when one with three corners in a row counts as nothing.
#[test]
fn flat_and_degenerate_meshes_are_as_the_reference_says() {
    let found = std::cell::Cell::new([0; 2]);
    // Few steps: vertices in one place, in a row and in a plane are the rule. And the extremes.
    let few = prop_oneof![-1..=1_i16, Just(i16::MIN), Just(i16::MAX)];
    let points = vec([few.clone(), few.clone(), few], 3..8);
    let faces = vec(any::<[prop::sample::Index; 3]>(), 0..7);
    check(20_000, &(points, faces), |(positions, faces)| {
        let faces: Vec<[u16; 3]> =
            faces.iter().map(|face| face.map(|corner| corner.index(positions.len()) as u16)).collect();
        let expected = is_convex(&positions, &faces);
        let mut counts = found.get();
        counts[usize::from(expected)] += 1;
        found.set(counts);
        let mesh = Mesh::new(&positions, &faces).expect("faces name vertices that are there");
        if mesh.is_convex() == expected { Ok(()) } else { Err(format!("not {expected}")) }
    });
    let [not, yes] = found.get();
    println!("{yes} convex, {not} not");
    assert!(yes > 3000 && not > 1500, "{yes} {not}");
}

// Red when the cube's own faces are not behind each other, or a mesh that hides itself is taken for one that does not.
#[test]
fn the_scenes_meshes_are_convex_where_they_look_so() {
    let convex: Vec<&str> = SCENES
        .iter()
        .filter(|scene| scene.objects.iter().all(|object| object.mesh.is_convex()))
        .map(|scene| scene.name)
        .collect();
    assert_eq!(convex, EXPECTED);
    for scene in SCENES {
        for object in scene.objects {
            let mesh = object.mesh;
            assert_eq!(mesh.is_convex(), is_convex(mesh.positions(), mesh.faces()), "{}", scene.name);
        }
    }
}

const EXPECTED: [&str; 9] =
    ["cube", "near-cube", "sphere", "floor", "grid240", "leaning-cube", "horizon", "corridor", "star"];

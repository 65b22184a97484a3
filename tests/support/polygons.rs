//! What clipping and snapping leave of a mesh's faces.

use std::collections::HashSet;

use reference::setup::Triangle;
use topleft::{Camera, Mesh, Pose};

use super::counter::placed;
use super::winding::Edge;

/// What is left of each face, as the list has it: three vertices or more, or none.
pub(crate) struct Polygons {
    faces: Vec<Vec<[i32; 2]>>,
    /// Where clipping made vertices.
    pub(crate) made: HashSet<[i32; 2]>,
    /// Faces that were clipped.
    pub(crate) clipped: usize,
}

impl Polygons {
    /// The edges of all polygons, each in its face's direction.
    pub(crate) fn edges(&self) -> Vec<Edge> {
        let edges = |face: &Vec<[i32; 2]>| {
            let next = face.iter().cycle().skip(1);
            face.iter().zip(next).map(|(&from, &to)| [from, to]).collect::<Vec<_>>()
        };
        self.faces.iter().flat_map(edges).collect()
    }

    /// The fans of all polygons, each from its first vertex.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = Triangle> {
        self.faces.iter().flat_map(|face| face.windows(2).skip(1).map(|pair| [face[0], pair[0], pair[1]]))
    }
}

/// Each face put into a list alone: what its vertices become does not depend on any other.
pub(crate) fn polygons(camera: &impl Camera, mesh: &Mesh<'_>, pose: &Pose) -> Polygons {
    let mut polygons = Polygons { faces: Vec::new(), made: HashSet::new(), clipped: 0 };
    let [low, high] = mesh.bounds();
    for face in mesh.faces() {
        let [a, b, c] = face.map(|vertex| mesh.positions()[usize::from(vertex)]);
        // The ends of the mesh's box, so that the face is not rejected as a mesh of its own.
        let positions = [a, b, c, low, high];
        let alone = Mesh::new(&positions, &[[0, 1, 2]]).expect("three vertices");
        let drawn = placed(camera, &alone.with_box(mesh.centre(), mesh.half()), pose);
        let places = drawn.words.chunks(2).map(|at| [0, 1].map(|axis| at[axis].cast_signed()));
        let places: Vec<[i32; 2]> = places.collect();
        let Some((corners, clipped)) = places.split_at_checked(positions.len()) else { continue };
        let corners = &corners[..3];
        if drawn.clipped == 1 {
            // A new vertex may lie where a corner is: then the place is there once more.
            let times = |places: &[[i32; 2]], place| places.iter().filter(|&&other| other == place).count();
            let new = |&&place: &&[i32; 2]| times(clipped, place) > times(corners, place);
            polygons.made.extend(clipped.iter().filter(new));
            polygons.clipped += 1;
            polygons.faces.push(clipped.to_vec());
        } else if corners.iter().all(|&[x, _]| x != i32::MIN) {
            polygons.faces.push(corners.to_vec());
        }
    }
    polygons
}

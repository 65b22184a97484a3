//! A sphere of nearly equal triangles.

use super::surface::{corner, pack};
use crate::model::Welder;
use crate::normals::unit;
use crate::quantise::Packed;

/// A sphere of radius 1: an icosahedron, each triangle split in four `splits` times.
pub(super) fn make(splits: u32) -> Packed {
    let mut triangles = icosahedron();
    for _ in 0..splits {
        triangles = triangles.into_iter().flat_map(split).collect();
    }
    let mut welder = Welder::default();
    for triangle in triangles {
        welder.face(triangle.map(|position| corner(position, position, None)), None);
    }
    pack(welder, |model| model)
}

/// The 20 triangles round three golden rectangles that cross.
fn icosahedron() -> Vec<[[f64; 3]; 3]> {
    const GOLDEN: f64 = 1.618_033_988_749_895;
    // Corners by their signs: on the yz, the zx and the xy rectangle.
    let yz = |y: f64, z: f64| on_sphere([0.0, y, GOLDEN * z]);
    let zx = |z: f64, x: f64| on_sphere([GOLDEN * x, 0.0, z]);
    let xy = |x: f64, y: f64| on_sphere([x, GOLDEN * y, 0.0]);
    let mut triangles = Vec::new();
    for a in [1.0, -1.0] {
        for b in [1.0, -1.0] {
            // One at each short side of a rectangle.
            triangles.push([yz(1.0, a), yz(-1.0, a), zx(a, b)]);
            triangles.push([zx(1.0, a), zx(-1.0, a), xy(a, b)]);
            triangles.push([xy(1.0, a), xy(-1.0, a), yz(a, b)]);
            // One in each octant.
            triangles.push([yz(b, a), zx(a, 1.0), xy(1.0, b)]);
            triangles.push([yz(b, a), zx(a, -1.0), xy(-1.0, b)]);
        }
    }
    triangles.into_iter().map(outward).collect()
}

/// The triangle counter-clockwise as seen from outside the sphere.
fn outward([a, b, c]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let volume = crate::normals::dot(a, crate::normals::cross(b, c));
    if volume > 0.0 { [a, b, c] } else { [a, c, b] }
}

fn split([a, b, c]: [[f64; 3]; 3]) -> [[[f64; 3]; 3]; 4] {
    let middle = |a: [f64; 3], b: [f64; 3]| on_sphere(std::array::from_fn(|axis| a[axis] + b[axis]));
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

fn on_sphere(position: [f64; 3]) -> [f64; 3] {
    unit(position).unwrap_or(position)
}

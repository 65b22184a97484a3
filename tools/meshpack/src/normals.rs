//! Normals where a file gives none.

use std::collections::HashMap;

/// Unit normals of faces; a face without area gets (0, 0, 1).
pub(crate) fn of_faces(positions: &[[f64; 3]], faces: &[[u32; 3]]) -> Vec<[f64; 3]> {
    faces.iter().map(|&face| unit(of_face(corners(positions, face))).unwrap_or([0.0, 0.0, 1.0])).collect()
}

/// The normals as given, and smooth ones for the vertices that have none, or one without length.
///
/// A smooth normal is the sum of the normals of all faces at the same point, weighted by their angles there, so that
/// it depends neither on the triangulation nor on seams of the texture.
pub(crate) fn of_vertices(
    positions: &[[f64; 3]],
    faces: &[[u32; 3]],
    given: &[Option<[f64; 3]>],
) -> Vec<[f64; 3]> {
    let mut sums: HashMap<[u64; 3], [f64; 3]> = HashMap::new();
    if given.iter().any(|normal| normal.and_then(unit).is_none()) {
        for &face in faces {
            add_face(&mut sums, corners(positions, face));
        }
    }
    let smooth = |position: &[f64; 3]| sums.get(&position.map(point)).and_then(|&sum| unit(sum));
    let any = |position| smooth(position).unwrap_or([0.0, 0.0, 1.0]);
    positions
        .iter()
        .zip(given)
        .map(|(position, normal)| normal.and_then(unit).unwrap_or_else(|| any(position)))
        .collect()
}

fn add_face(sums: &mut HashMap<[u64; 3], [f64; 3]>, corners: [[f64; 3]; 3]) {
    let Some(normal) = unit(of_face(corners)) else { return };
    for (index, corner) in corners.iter().enumerate() {
        let [next, last] = [corners[(index + 1) % 3], corners[(index + 2) % 3]];
        let (Some(a), Some(b)) = (unit(subtract(next, *corner)), unit(subtract(last, *corner))) else {
            continue;
        };
        let angle = dot(a, b).clamp(-1.0, 1.0).acos();
        let sum = sums.entry(corner.map(point)).or_default();
        *sum = std::array::from_fn(|axis| sum[axis] + normal[axis] * angle);
    }
}

/// The bits of a coordinate, equal for 0 and -0.
fn point(coordinate: f64) -> u64 {
    (coordinate + 0.0).to_bits()
}

fn corners(positions: &[[f64; 3]], face: [u32; 3]) -> [[f64; 3]; 3] {
    face.map(|index| positions[index as usize])
}

/// A vector along a face's normal: as long as twice the face's area.
pub(crate) fn of_face([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    cross(subtract(b, a), subtract(c, a))
}

pub(crate) fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The vector at length 1, unless it has no length or no finite one.
pub(crate) fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    // Dividing by the largest first keeps the squares of tiny and of huge vectors in range.
    let largest = vector.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    if largest == 0.0 || !largest.is_finite() || vector.iter().any(|value| value.is_nan()) {
        return None;
    }
    let vector = vector.map(|value| value / largest);
    let length = dot(vector, vector).sqrt();
    Some(vector.map(|value| value / length))
}

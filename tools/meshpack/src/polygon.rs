//! Splits polygons that a fan of triangles would not cover.

use crate::normals::{cross, dot, subtract};

/// Corners above which a polygon is left to the fan: cutting ears takes the cube of their number at worst.
const MOST_CORNERS: usize = 1000;

/// Triangles, as places in `corners`, that cover a flat polygon with a dent; nothing for a polygon without one.
///
/// Ears are cut off one by one: a corner whose triangle turns the polygon's way and holds no other corner.
pub(crate) fn split_dented(corners: &[[f64; 3]]) -> Option<Vec<[usize; 3]>> {
    if corners.len() < 4 || corners.len() > MOST_CORNERS {
        return None;
    }
    // Newell's normal: the sum over the edges, which no dent upsets.
    let next = corners.iter().cycle().skip(1);
    let normal = corners.iter().zip(next).fold([0.0; 3], |sum, (&a, &b)| {
        let part = cross(subtract(a, corners[0]), subtract(b, corners[0]));
        std::array::from_fn(|axis| sum[axis] + part[axis])
    });
    let turn = |[a, b, c]: [usize; 3]| {
        dot(cross(subtract(corners[b], corners[a]), subtract(corners[c], corners[a])), normal)
    };
    let mut rest: Vec<usize> = (0..corners.len()).collect();
    let ear_at = |rest: &[usize], middle: usize| {
        let count = rest.len();
        [rest[(middle + count - 1) % count], rest[middle], rest[(middle + 1) % count]]
    };
    if (0..rest.len()).all(|middle| turn(ear_at(&rest, middle)) >= 0.0) {
        return None;
    }
    let holds = |[a, b, c]: [usize; 3], point: usize| {
        let same = [a, b, c].iter().any(|&corner| corners[corner] == corners[point]);
        !same && turn([a, b, point]) >= 0.0 && turn([b, c, point]) >= 0.0 && turn([c, a, point]) >= 0.0
    };
    let mut triangles = Vec::new();
    while rest.len() > 3 {
        let is_ear = |&middle: &usize| {
            let ear = ear_at(&rest, middle);
            turn(ear) > 0.0 && !rest.iter().any(|&point| holds(ear, point))
        };
        // A polygon that crosses itself may have no ear: then any corner will do.
        let middle = (0..rest.len()).find(is_ear).unwrap_or(0);
        triangles.push(ear_at(&rest, middle));
        rest.remove(middle);
    }
    triangles.push([rest[0], rest[1], rest[2]]);
    Some(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners of a polygon in the plane z = 0.
    fn flat(corners: &[[f64; 2]]) -> Vec<[f64; 3]> {
        corners.iter().map(|&[x, y]| [x, y, 0.0]).collect()
    }

    fn area(corners: &[[f64; 3]], [a, b, c]: [usize; 3]) -> f64 {
        cross(subtract(corners[b], corners[a]), subtract(corners[c], corners[a]))[2] / 2.0
    }

    #[test]
    fn a_square_is_left_to_the_fan() {
        assert_eq!(split_dented(&flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])), None);
    }

    #[test]
    fn an_arrow_and_a_comb_are_covered_once() {
        let arrow = flat(&[[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [1.0, 1.0]]);
        let comb = flat(&[
            [0.0, 0.0],
            [5.0, 0.0],
            [5.0, 2.0],
            [4.0, 2.0],
            [4.0, 1.0],
            [3.0, 1.0],
            [3.0, 2.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [0.0, 2.0],
        ]);
        for (polygon, expected) in [(arrow, 1.0), (comb, 8.0)] {
            let triangles = split_dented(&polygon).unwrap();
            assert_eq!(triangles.len(), polygon.len() - 2);
            assert!(triangles.iter().all(|&triangle| area(&polygon, triangle) >= 0.0));
            let sum: f64 = triangles.iter().map(|&triangle| area(&polygon, triangle)).sum();
            assert!((sum - expected).abs() < 1e-12, "{sum} and not {expected}");
        }
    }

    #[test]
    fn a_polygon_that_crosses_itself_ends() {
        let bow = flat(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.5, 3.0]]);
        assert!(split_dented(&bow).is_none_or(|triangles| triangles.len() == 3));
        assert!(
            split_dented(&flat(&[[f64::MAX, 0.0], [0.0, f64::MAX], [-1.0, 0.0], [0.0, 0.0]]))
                .is_none_or(|t| t.len() == 2)
        );
    }
}

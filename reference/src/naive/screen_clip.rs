//! Clipping on the screen, a triangle at a time: each new vertex is rounded to 1/256 px, and the neighbour, which is not
//! clipped or clipped elsewhere, keeps the edge as it was.

use crate::setup::{Triangle, fan};
use std::ops::Range;

/// A corner in 1/256 px, not rounded, and a value at it.
type Corner = ([f64; 2], f64);

/// A triangle, and values at its corners.
pub type Valued = (Triangle, [f64; 3]);

/// The parts of triangles that are wider or higher than `longest` pixels inside a rectangle in 1/256 px, and the others
/// as they are: clipping for the sake of the numbers' range, decided for each triangle. Where two neighbours are decided
/// differently their edge is torn.
pub fn by_size(triangles: &[Triangle], longest: i32, [left, top, right, bottom]: [i32; 4]) -> Vec<Triangle> {
    let extent = |triangle: &Triangle, axis: usize| {
        let [a, b, c] = triangle.map(|corner| corner[axis]);
        a.max(b).max(c) - a.min(b).min(c)
    };
    let mut parts = Vec::new();
    for triangle in triangles {
        if extent(triangle, 0).max(extent(triangle, 1)) <= longest * 256 {
            parts.push(*triangle);
            continue;
        }
        let mut polygon = triangle.map(|corner| (corner.map(f64::from), 0.0)).to_vec();
        for (axis, limit, sign) in [(0, left, 1.0), (0, right, -1.0), (1, top, 1.0), (1, bottom, -1.0)] {
            polygon = cut(&polygon, axis, f64::from(limit), sign);
        }
        parts.extend(fanned(&polygon).into_iter().map(|(part, _)| part));
    }
    parts
}

/// The part of a triangle in some rows of pixels, as a strip that clips to itself and sets up what it gets would have it.
pub fn to_rows((triangle, values): Valued, rows: Range<i32>) -> Vec<Valued> {
    let polygon: Vec<Corner> =
        triangle.iter().zip(values).map(|(corner, value)| (corner.map(f64::from), value)).collect();
    let below = cut(&polygon, 1, f64::from(rows.start * 256), 1.0);
    fanned(&cut(&below, 1, f64::from(rows.end * 256), -1.0))
}

/// Sutherland and Hodgman: what is beyond `limit` on an axis, in the direction of `sign`.
fn cut(polygon: &[Corner], axis: usize, limit: f64, sign: f64) -> Vec<Corner> {
    let mut kept = Vec::new();
    for (i, &(a, p)) in polygon.iter().enumerate() {
        let (b, q) = polygon[(i + 1) % polygon.len()];
        let (from, to) = ((a[axis] - limit) * sign, (b[axis] - limit) * sign);
        if from >= 0.0 {
            kept.push((a, p));
        }
        if from * to < 0.0 {
            let part = from / (from - to);
            let place = [0, 1].map(|k| a[k] + (b[k] - a[k]) * part);
            kept.push((place, p + (q - p) * part));
        }
    }
    kept
}

/// The triangles of a polygon, its corners rounded to 1/256 px.
fn fanned(polygon: &[Corner]) -> Vec<Valued> {
    let places: Vec<[i32; 2]> = polygon.iter().map(|(place, _)| place.map(|c| c.round() as i32)).collect();
    fan(&places).into_iter().map(|part| (part.map(|i| places[i]), part.map(|i| polygon[i].1))).collect()
}

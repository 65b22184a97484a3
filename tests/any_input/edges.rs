//! Where the edges of a triangle are.

use reference::raster::edges;
use reference::setup::Triangle;

/// How far a pixel's centre lies from the lines through a triangle's edges, in steps.
pub(crate) fn to_edges(triangle: Triangle, x: i64, y: i64) -> f64 {
    let values = edges(triangle, x, y);
    let [a, b, c] = triangle.map(|p| p.map(f64::from));
    let length = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]).max(1.0);
    let away = [length(b, c), length(c, a), length(a, b)];
    values
        .iter()
        .zip(away)
        .map(|(&edge, length)| edge as f64 / length)
        .fold(f64::INFINITY, |a, b| a.min(b.abs()))
}

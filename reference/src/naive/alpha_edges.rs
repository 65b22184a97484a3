//! Edges drawn with alpha, triangle by triangle, in a mesh.

use crate::raster::{edges, pixel_box};
use crate::setup::{Triangle, area2};
use crate::transform::Viewport;

/// How much of a pixel a triangle covers, by the distance of its centre to the nearest edge: 1/2 on the edge, 0 and 1
/// half a pixel beside it. Good for an edge against the background.
pub fn coverage(triangle: Triangle, x: i64, y: i64) -> f64 {
    let area = area2(triangle) as f64;
    if area == 0.0 {
        return 0.0;
    }
    let [a, b, c] = triangle.map(|corner| corner.map(f64::from));
    let length = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
    edges(triangle, x, y)
        .iter()
        .zip([length(b, c), length(c, a), length(a, b)])
        .map(|(&edge, length)| (edge as f64 * area.signum() / length / 256.0 + 0.5).clamp(0.0, 1.0))
        .fold(1.0, f64::min)
}

/// What is left of the background at each pixel when the triangles are blended over it one after the other: on the edge
/// between two, c (1 - c) where 0 is right, up to a quarter.
pub fn background_left(triangles: &[Triangle], viewport: Viewport) -> Vec<f64> {
    let mut left = vec![1.0; (viewport.width * viewport.height) as usize];
    for &triangle in triangles {
        // A pixel more on each side: coverage reaches half a pixel beyond the box.
        let (columns, rows) = pixel_box(triangle, viewport);
        for y in (rows.start - 1).max(0)..(rows.end + 1).min(i64::from(viewport.height)) {
            for x in (columns.start - 1).max(0)..(columns.end + 1).min(i64::from(viewport.width)) {
                left[(y * i64::from(viewport.width) + x) as usize] *= 1.0 - coverage(triangle, x, y);
            }
        }
    }
    left
}

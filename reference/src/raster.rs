//! Stage 5. Which pixel centres a triangle covers: the top-left rule in exact integers.
//!
//! A pixel (x, y) is covered when its centre, (x*256 + 128, y*256 + 128) in 1/256 pixel, is inside the triangle, or on
//! a left edge or on a horizontal top edge. Either winding covers the same pixels.
//!
//! Two independent answers are given, to be held against each other: [`covers`] from edge functions, a pixel at a
//! time, and [`row_span`] from where a row crosses the edges, without any edge function or fill rule of its own.

use crate::setup::{Facing, Triangle, area2, facing};
use crate::transform::Viewport;
use std::ops::Range;

/// A pixel's centre in 1/256 pixel.
fn centre(pixel: i64) -> i128 {
    i128::from(pixel) * 256 + 128
}

/// The edge functions at a pixel's centre: entry k belongs to the edge opposite corner k, is twice the area between
/// that edge and the centre, and has the sign of [`area2`] inside. The three add up to [`area2`].
pub fn edges(triangle: Triangle, x: i64, y: i64) -> [i128; 3] {
    let [a, b, c] = triangle.map(|corner| corner.map(i128::from));
    let edge = |from: [i128; 2], to: [i128; 2]| {
        (to[0] - from[0]) * (centre(y) - from[1]) - (to[1] - from[1]) * (centre(x) - from[0])
    };
    [edge(b, c), edge(c, a), edge(a, b)]
}

/// Whether the triangle covers the pixel.
pub fn covers(triangle: Triangle, x: i64, y: i64) -> bool {
    // Clockwise on the screen, so that inside is positive.
    let [a, b, c] = match facing(triangle) {
        Facing::Edge => return false,
        Facing::Back => triangle,
        Facing::Front => [triangle[0], triangle[2], triangle[1]],
    };
    let values = edges([a, b, c], x, y);
    [(b, c), (c, a), (a, b)].iter().zip(values).all(|(&(from, to), value)| {
        let left = to[1] < from[1];
        let top = to[1] == from[1] && to[0] > from[0];
        value > 0 || (value == 0 && (left || top))
    })
}

/// The covered pixels of row `y` as a half-open range of x, not limited to any viewport, or nothing.
///
/// An edge takes part in the rows whose centre is at or below its upper end and above its lower end. A row crosses two
/// edges or none, each at an exact fraction, and covers the centres from the left crossing up to, but not including,
/// the right one.
pub fn row_span(triangle: Triangle, y: i64) -> Option<(i64, i64)> {
    let [a, b, c] = triangle.map(|corner| corner.map(i128::from));
    let row = centre(y);
    let mut firsts = Vec::new();
    for (p, q) in [(a, b), (b, c), (c, a)] {
        let (upper, lower) = if p[1] < q[1] { (p, q) } else { (q, p) };
        if upper[1] <= row && row < lower[1] {
            let height = lower[1] - upper[1];
            // The crossing is at `numerator / height`; the first centre at or right of it is the least x with
            // (256 x + 128) * height >= numerator.
            let numerator = upper[0] * height + (lower[0] - upper[0]) * (row - upper[1]);
            firsts.push(ceiling(numerator - 128 * height, 256 * height));
        }
    }
    let (first, last) = (*firsts.iter().min()?, *firsts.iter().max()?);
    // Both ends are less than 2^24 pixels from the origin.
    (first < last).then_some((first as i64, last as i64))
}

fn ceiling(numerator: i128, denominator: i128) -> i128 {
    -(-numerator).div_euclid(denominator)
}

/// The pixels of the viewport in the triangle's bounding box, as ranges of x and of y: no other can be covered.
pub fn pixel_box(triangle: Triangle, viewport: Viewport) -> (Range<i64>, Range<i64>) {
    let range = |axis: usize, size: u32| {
        let values = triangle.map(|corner| i64::from(corner[axis]));
        let least = values[0].min(values[1]).min(values[2]).div_euclid(256);
        let greatest = values[0].max(values[1]).max(values[2]).div_euclid(256);
        least.max(0)..(greatest + 1).min(i64::from(size))
    };
    (range(0, viewport.width), range(1, viewport.height))
}

/// How many of the triangles cover each pixel, in rows from the top.
pub fn coverage_counts(triangles: &[Triangle], viewport: Viewport) -> Vec<u32> {
    counts_by(covers, triangles, viewport)
}

/// The same by another test of whether a triangle covers a pixel, at the pixels of its bounding box.
pub fn counts_by(
    test: impl Fn(Triangle, i64, i64) -> bool,
    triangles: &[Triangle],
    viewport: Viewport,
) -> Vec<u32> {
    let mut counts = vec![0; pixels(viewport)];
    for &triangle in triangles {
        for_covered(&test, triangle, viewport, |index| counts[index] += 1);
    }
    counts
}

/// Front hits minus back hits of each pixel, in rows from the top: the winding number, 0 everywhere for a closed mesh.
pub fn winding_numbers(triangles: &[Triangle], viewport: Viewport) -> Vec<i32> {
    let mut windings = vec![0; pixels(viewport)];
    for &triangle in triangles {
        let sign = if area2(triangle) < 0 { 1 } else { -1 };
        for_covered(covers, triangle, viewport, |index| windings[index] += sign);
    }
    windings
}

fn pixels(viewport: Viewport) -> usize {
    viewport.width as usize * viewport.height as usize
}

fn for_covered(
    test: impl Fn(Triangle, i64, i64) -> bool,
    triangle: Triangle,
    viewport: Viewport,
    mut visit: impl FnMut(usize),
) {
    let (columns, rows) = pixel_box(triangle, viewport);
    for y in rows {
        for x in columns.clone() {
            if test(triangle, x, y) {
                visit(y as usize * viewport.width as usize + x as usize);
            }
        }
    }
}

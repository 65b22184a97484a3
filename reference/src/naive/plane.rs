//! Interpolation by plane equations that lose what a sliver's gradients need.
//!
//! Each has the form of [`linear`], of which it is an approximation.

use crate::setup::{Triangle, area2};
use crate::varying::linear;

/// Gradients in Q16.16, held at the ends of the range where they do not fit, and added up without wrapping: what
/// "saturate, do not overflow" gives. A sliver's gradients are far steeper than its values are wide.
pub fn saturated(triangle: Triangle, values: [f64; 3], x: i64, y: i64) -> f64 {
    let held = |slope: f64| (slope * 65_536.0).round() as i32;
    let [gx, gy] = slopes(triangle, values).map(held).map(i64::from);
    from_the_first_vertex(triangle, values[0], [gx, gy], x, y)
}

/// The reciprocal of the area as `2^32 / area`, not normalised: of a large triangle no bit is left.
pub fn reciprocal_of_32_bits(triangle: Triangle, values: [f64; 3], x: i64, y: i64) -> f64 {
    let [[ax, ay], [bx, by], [cx, cy]] = triangle.map(|corner| corner.map(i128::from));
    let area = area2(triangle);
    let reciprocal = (1_i128 << 32) / area;
    let [a, b, c] = values.map(|value| (value * 65_536.0).round() as i128);
    // Differences are in 1/256 px, and so are gradients: 8 bits more to a pixel.
    let gradient = |numerator: i128| ((numerator * reciprocal) >> (32 - 8)) as i64;
    let gx = gradient((b - a) * (cy - ay) - (c - a) * (by - ay));
    let gy = gradient((c - a) * (bx - ax) - (b - a) * (cx - ax));
    from_the_first_vertex(triangle, values[0], [gx, gy], x, y)
}

/// `A x + B y + C` in `f32`, x and y counted from the corner of the screen, as textbooks write a plane. On a steep
/// plane A x and B y are large and cancel.
pub fn from_the_corner(triangle: Triangle, values: [f64; 3], x: i64, y: i64) -> f64 {
    let corners = triangle.map(|corner| corner.map(|c| c as f32 / 256.0));
    let values = values.map(|value| value as f32);
    let [gx, gy] = slopes_of_f32(corners, values);
    let [[ax, ay], ..] = corners;
    let at_corner = values[0] - gx * ax - gy * ay;
    f64::from(gx * centre(x) + gy * centre(y) + at_corner)
}

/// The same counted from the triangle's first vertex, whichever that is: the last bits depend on the order of the
/// vertices. (Mesa's llvmpipe says so of its own set-up, of z in particular.)
pub fn from_the_given_vertex(triangle: Triangle, values: [f64; 3], x: i64, y: i64) -> f64 {
    let corners = triangle.map(|corner| corner.map(|c| c as f32 / 256.0));
    let values = values.map(|value| value as f32);
    let [gx, gy] = slopes_of_f32(corners, values);
    let [[ax, ay], ..] = corners;
    f64::from(values[0] + gx * (centre(x) - ax) + gy * (centre(y) - ay))
}

/// Depth with a bias of its steepest slope and no clamp, which keeps decals on gentle slopes in front: a sliver comes in
/// front of everything.
pub fn with_slope_bias(triangle: Triangle, depths: [f64; 3], x: i64, y: i64) -> f64 {
    let [gx, gy] = slopes(triangle, depths);
    linear(triangle, depths, x, y) + gx.abs().max(gy.abs())
}

/// A sum of Q16.16 gradients from the pixel of the first vertex on.
fn from_the_first_vertex(triangle: Triangle, first: f64, [gx, gy]: [i64; 2], x: i64, y: i64) -> f64 {
    let [ax, ay] = triangle[0].map(i64::from);
    let start = (first * 65_536.0).round() as i64
        + ((gx * (128 - ax.rem_euclid(256)) + gy * (128 - ay.rem_euclid(256))) >> 8);
    let sum = start + (x - ax.div_euclid(256)) * gx + (y - ay.div_euclid(256)) * gy;
    sum as f64 / 65_536.0
}

/// The exact steps of a plane a pixel to the right and a pixel down.
pub(super) fn slopes(triangle: Triangle, values: [f64; 3]) -> [f64; 2] {
    let at = |x, y| linear(triangle, values, x, y);
    [at(1, 0) - at(0, 0), at(0, 1) - at(0, 0)]
}

fn slopes_of_f32([[ax, ay], [bx, by], [cx, cy]]: [[f32; 2]; 3], [a, b, c]: [f32; 3]) -> [f32; 2] {
    let area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    let gx = (b - a) * (cy - ay) - (c - a) * (by - ay);
    let gy = (c - a) * (bx - ax) - (b - a) * (cx - ax);
    [gx / area, gy / area]
}

fn centre(pixel: i64) -> f32 {
    pixel as f32 + 0.5
}

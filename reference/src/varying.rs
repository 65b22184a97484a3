//! What is carried over a triangle: exact interpolation at pixel centres.
//!
//! The weights are the `i128` edge functions at the snapped corners, so needles lose nothing; what is rounded is only
//! the final sums, a few units of the last place of an `f64`. A triangle without area has no answer: the result is not finite.

use crate::raster::edges;
use crate::setup::{Triangle, area2};

/// How a varying is carried over a triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Linear on the screen.
    Affine,
    /// Linear in clip space: divided by w at each pixel.
    #[default]
    Perspective,
}

/// The share of each corner in the value at a pixel's centre. They add up to 1; outside the triangle some are negative.
pub fn barycentrics(triangle: Triangle, x: i64, y: i64) -> [f64; 3] {
    let area = area2(triangle) as f64;
    edges(triangle, x, y).map(|edge| edge as f64 / area)
}

/// The value at a pixel's centre of the plane through the corners' `values`. A constant stays exactly what it is.
pub fn linear(triangle: Triangle, values: [f64; 3], x: i64, y: i64) -> f64 {
    let weights = edges(triangle, x, y).map(|edge| edge as f64);
    let [base, b, c] = values;
    base + (weights[1] * (b - base) + weights[2] * (c - base)) / area2(triangle) as f64
}

/// The perspective-correct value at a pixel's centre; `q` is 1/w of the corners. A constant stays exactly what it is.
pub fn perspective(triangle: Triangle, values: [f64; 3], q: [f64; 3], x: i64, y: i64) -> f64 {
    let edges = edges(triangle, x, y);
    let weights = [0, 1, 2].map(|k| edges[k] as f64 * q[k]);
    let [base, b, c] = values;
    base + (weights[1] * (b - base) + weights[2] * (c - base)) / (weights[0] + weights[1] + weights[2])
}

/// [`linear`] or [`perspective`].
pub fn carry(method: Method, triangle: Triangle, values: [f64; 3], q: [f64; 3], x: i64, y: i64) -> f64 {
    match method {
        Method::Affine => linear(triangle, values, x, y),
        Method::Perspective => perspective(triangle, values, q, x, y),
    }
}

//! Perspective with too few bits, or between places that lie outside of the triangle.

use super::plane::slopes;
use crate::setup::Triangle;
use crate::varying::{linear, perspective};

/// A texel from planes of u/w and 1/w with `bits` fraction bits of their largest value, and an exact quotient: far from
/// the viewer 1/w has few bits left, and it is what u/w is divided by.
pub fn with_fraction_bits(
    triangle: Triangle,
    texels: [f64; 3],
    q: [f64; 3],
    bits: u32,
    [x, y]: [i64; 2],
) -> f64 {
    let most = |values: [f64; 3]| values.into_iter().fold(0.0, f64::max);
    let (size, nearest) = (most(texels), most(q));
    let over_w = [0, 1, 2].map(|i| texels[i] / size * q[i] / nearest);
    let step = f64::from(bits).exp2();
    let plane = |values: [f64; 3]| {
        let round = |value: f64| (value * step).round() / step;
        let [gx, gy] = slopes(triangle, values).map(round);
        let [ax, ay] = triangle[0].map(|c| i64::from(c >> 8));
        round(linear(triangle, values, ax, ay)) + (x - ax) as f64 * gx + (y - ay) as f64 * gy
    };
    plane(over_w) / plane(q.map(|q| q / nearest)) * size
}

/// A texel of a row from `start` on, linear between exact ones every `length` pixels, whether or not the last of them
/// still lies in the triangle: beyond its edge 1/w may be 0 or less.
pub fn of_whole_subspans(
    triangle: Triangle,
    texels: [f64; 3],
    q: [f64; 3],
    [start, length]: [i64; 2],
    [x, y]: [i64; 2],
) -> f64 {
    let left = start + (x - start) / length * length;
    let [from, to] = [left, left + length].map(|x| perspective(triangle, texels, q, x, y));
    from + (to - from) * (x - left) as f64 / length as f64
}

/// One level of detail for a triangle, from its areas in texels and in pixels, both doubled: where a small one meets a
/// large one on the same plane the level jumps.
pub fn level_of_triangle(texels2: f64, pixels2: f64) -> u32 {
    (texels2 / pixels2).sqrt().max(1.0).log2().round() as u32
}

//! Coverage by edge functions, with no fill rule or with too few bits.
//!
//! Each test has the form of [`covers`](crate::raster::covers), so [`counts_by`](crate::raster::counts_by) draws with it.

use crate::raster::edges;
use crate::setup::{Facing, Triangle, facing};
use crate::varying::barycentrics;

/// All three barycentrics from 0 to 1, as lectures teach it: a centre on a shared edge belongs to both triangles, and a
/// hub on a centre to all of its fan.
pub fn inclusive(triangle: Triangle, x: i64, y: i64) -> bool {
    barycentrics(triangle, x, y).iter().all(|weight| (0.0..=1.0).contains(weight))
}

/// All three barycentrics above 0, the first remedy that comes to mind: a centre on a shared edge belongs to nobody.
pub fn exclusive(triangle: Triangle, x: i64, y: i64) -> bool {
    barycentrics(triangle, x, y).iter().all(|&weight| weight > 0.0)
}

/// All three edge functions of one sign, zero included, and no look at the area (`Pico3D`'s test). As [`inclusive`], and
/// a triangle without an area covers its whole line.
pub fn one_sign(triangle: Triangle, x: i64, y: i64) -> bool {
    let values = edges(triangle, x, y);
    values.iter().all(|&value| value >= 0) || values.iter().all(|&value| value <= 0)
}

/// The edge functions in 32 bits at 8 sub-pixel bits, and the right fill rule: exact up to boxes of 2^15 px² (181 px
/// square), and wrapped beyond. Mesa's llvmpipe takes this path up to 128 px only.
pub fn in_32_bits(triangle: Triangle, x: i64, y: i64) -> bool {
    top_left(triangle, |[ax, ay], [bx, by], bias| {
        let [px, py] = [x, y].map(|pixel| pixel as i32 * 256 + 128);
        let (dx, dy) = (bx.wrapping_sub(ax), by.wrapping_sub(ay));
        dx.wrapping_mul(py.wrapping_sub(ay)).wrapping_sub(dy.wrapping_mul(px.wrapping_sub(ax))) >= bias
    })
}

/// The edge functions in steps of 2^-8 px² in 32 bits, and no guard rectangle: what `topleft` computes where it must not.
/// Exact up to boxes of 2^23 px², and wrapped beyond.
pub fn without_guard(triangle: Triangle, x: i64, y: i64) -> bool {
    top_left(triangle, |[ax, ay], [bx, by], bias| {
        let (dx, dy) = (bx.wrapping_sub(ax), by.wrapping_sub(ay));
        // From a to the centre: whole pixels, and what is left, below one pixel.
        let [(i, fx), (j, fy)] = [(x, ax), (y, ay)].map(|(pixel, from)| {
            let steps = (pixel as i32).wrapping_mul(256).wrapping_add(128).wrapping_sub(from);
            (steps >> 8, steps & 255)
        });
        let within = dx.wrapping_mul(fy).wrapping_sub(dy.wrapping_mul(fx)).wrapping_sub(bias) >> 8;
        dx.wrapping_mul(j).wrapping_sub(dy.wrapping_mul(i)).wrapping_add(within) >= 0
    })
}

/// The top-left rule with another edge function: `inside` is given both ends of an edge of the triangle turned
/// clockwise, and 1 where its centres do not count, else 0.
fn top_left(triangle: Triangle, inside: impl Fn([i32; 2], [i32; 2], i32) -> bool) -> bool {
    let [a, b, c] = match facing(triangle) {
        Facing::Edge => return false,
        Facing::Back => triangle,
        Facing::Front => [triangle[0], triangle[2], triangle[1]],
    };
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let top_or_left = to[1] < from[1] || (to[1] == from[1] && to[0] > from[0]);
        inside(from, to, i32::from(!top_or_left))
    })
}

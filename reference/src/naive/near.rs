//! What is done with triangles that reach behind the eye, other than clipping them from the inside to the outside.

use crate::matrix::Vec4;
use crate::setup::{Triangle, snap};
use crate::transform::Viewport;

/// A triangle on the screen by dividing by w whatever it is: what is behind the eye is mirrored through its centre.
/// Nothing where a w is 0.
pub fn divided_by_any_w(triangle: [Vec4; 3], viewport: Viewport) -> Option<Triangle> {
    let place = |position: Vec4| {
        let [x, y] = viewport.to_screen(position).map(snap);
        Some([x?, y?])
    };
    let [a, b, c] = triangle.map(place);
    Some([a?, b?, c?])
}

/// A triangle only where all of it lies in front of the near plane, as lectures and games leave out the others: it
/// vanishes when its first vertex comes too near.
pub fn skipped_if_behind(triangle: [Vec4; 3], viewport: Viewport) -> Option<Triangle> {
    if triangle.iter().any(|&[_, _, z, _]| z < 0.0) { None } else { divided_by_any_w(triangle, viewport) }
}

/// 1/w in Q16.16 of a w in Q16.16: nothing where it does not fit, which stops a debug build.
pub fn inverse_in_q16(w: i32) -> Option<i32> {
    i32::try_from((1_i64 << 32).checked_div(i64::from(w))?).ok()
}

/// Where an edge from (x, w) to another meets w = `near`, as x, in `f32` and from the end that is given first: the other
/// triangle of the edge is given the other one.
pub fn crossing_in_f32([ax, aw]: [f32; 2], [bx, bw]: [f32; 2], near: f32) -> f32 {
    let part = (near - aw) / (bw - aw);
    ax + (bx - ax) * part
}

/// The same in Q16.16 with 16 fraction bits of the edge.
pub fn crossing_in_q16([ax, aw]: [i32; 2], [bx, bw]: [i32; 2], near: i32) -> i32 {
    let [ax, aw, bx, bw, near] = [ax, aw, bx, bw, near].map(i64::from);
    let part = ((near - aw) << 16) / (bw - aw);
    (ax + (((bx - ax) * part) >> 16)) as i32
}

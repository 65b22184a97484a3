//! Plane equations from values at three vertices.
//!
//! Gradients come from one normalised reciprocal of the doubled area: `g = (d1 dy2 - d2 dy1) / area2`, the numerator
//! exact, the product with the reciprocal as well, and one rounding to nearest. An error of the reciprocal scales the
//! plane about its first vertex, so it is harmless even for slivers.

use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS, SUBPIXELS};
use crate::math::recip;
use crate::snapped::Snapped;

mod small;
mod wide;

/// A plane equation: its value at the anchor pixel's centre, and its step a pixel to the right and a pixel down.
///
/// The value at a pixel that is n columns and m rows from the anchor is off by at most `(n + m + 2) / 2` steps of the
/// format, rounding, and 2^-30 of the largest difference between vertices, the reciprocal of the area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plane<V> {
    /// The value at the anchor: the centre of the pixel that holds the triangle's first vertex.
    pub start: V,
    /// A pixel to the right.
    pub dx: V,
    /// A pixel down.
    pub dy: V,
}

/// The reciprocal of the area and the edges from the first vertex: what all planes of a triangle share.
#[derive(Clone, Copy, Debug)]
pub struct Gradients {
    /// From the first vertex to the second and to the third, in 1/256 px: the other way where the area is negative.
    first: [i32; 2],
    second: [i32; 2],
    /// `1 / |area2| = reciprocal * 2^-(shift + 8)`.
    reciprocal: u32,
    shift: u32,
    /// No two vertices are 32 px or more apart on an axis, and the area is less than 2^8 px^2.
    small: bool,
    anchor: [i32; 2],
    to_centre: [i32; 2],
}

impl Gradients {
    /// Of no triangle: for planes of nothing.
    pub(crate) const NONE: Self = Self {
        first: [0; 2],
        second: [0; 2],
        reciprocal: 0,
        shift: 0,
        small: false,
        anchor: [0; 2],
        to_centre: [0; 2],
    };

    /// Of a triangle in canonical order, with an area; `small` where no two vertices are 32 px or more apart on an axis.
    #[inline]
    pub(crate) fn new([a, b, c]: [Snapped; 3], area2: i64, small: bool) -> Self {
        let ((ax, ay), (bx, by), (cx, cy)) = (a.bits(), b.bits(), c.bits());
        let (first, second) = if area2 < 0 {
            ([ax - bx, ay - by], [ax - cx, ay - cy])
        } else {
            ([bx - ax, by - ay], [cx - ax, cy - ay])
        };
        let area2 = area2.unsigned_abs();
        let small = small && area2 >> small::AREA_BITS == 0;
        let (reciprocal, normalised) =
            if small { recip::small_area(area2 as u32) } else { recip::area(area2) };
        // From the vertex to the centre of the pixel that holds it: -127 to 128.
        let to_centre = |coordinate: i32| HALF_PIXEL - (coordinate & (SUBPIXELS - 1));
        Self {
            first,
            second,
            reciprocal,
            shift: (54 - normalised).unsigned_abs(),
            small,
            to_centre: [to_centre(ax), to_centre(ay)],
            anchor: [ax >> SUBPIXEL_BITS, ay >> SUBPIXEL_BITS],
        }
    }

    /// The column and row of the pixel that planes start from: the one that holds the first vertex.
    #[inline]
    pub const fn anchor(&self) -> [i32; 2] {
        self.anchor
    }

    /// The plane through three values of up to 32 bits, in canonical order, modulo 2^32.
    #[inline(never)]
    pub(crate) fn plane(&self, [a, b, c]: [i64; 3]) -> Plane<u32> {
        let (d1, d2) = (b - a, c - a);
        let (dx, dy) =
            if self.small { small::gradients(self, d1, d2) } else { wide::gradients(self, d1, d2) };
        self.through(a as i32, dx, dy)
    }

    /// The plane of a value at the first vertex and two gradients.
    #[inline(always)]
    fn through(&self, first: i32, dx: Gradient, dy: Gradient) -> Plane<u32> {
        let [ox, oy] = self.to_centre;
        // A gradient is multiplied by up to 128 and divided by 256: as its whole steps of 256, and what is below them.
        let whole = dx.over_256.wrapping_mul(ox).wrapping_add(dy.over_256.wrapping_mul(oy));
        let below = (dx.low & 255) * ox + (dy.low & 255) * oy;
        let start = first.wrapping_add(whole).wrapping_add((below + 128) >> 8);
        Plane { start: start.cast_unsigned(), dx: dx.low.cast_unsigned(), dy: dy.low.cast_unsigned() }
    }
}

/// A gradient of up to 64 bits: its low 32 bits, and those of a 256th of it, rounded down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Gradient {
    low: i32,
    over_256: i32,
}

//! Plane equations from values at three vertices.
//!
//! Gradients come from one normalised reciprocal of the doubled area: `g = (d1 dy2 - d2 dy1) / area2`, the numerator
//! exact in 64 bits, the product with the reciprocal exact in 96, and one rounding to nearest. An error of the
//! reciprocal scales the plane about its first vertex, so it is harmless even for slivers.

use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS, SUBPIXELS};
use crate::math::recip;
use crate::snapped::Snapped;

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
    /// From the first vertex to the second and to the third, in 1/256 px.
    first: [i32; 2],
    second: [i32; 2],
    negative: bool,
    /// `1 / |area2| = reciprocal * 2^-(shift + 8)`.
    reciprocal: u32,
    shift: u32,
    /// The pixel that holds the first vertex.
    anchor: [i32; 2],
    to_centre: [i32; 2],
}

impl Gradients {
    /// Of a triangle in canonical order, with an area.
    #[inline]
    pub(crate) fn new([a, b, c]: [Snapped; 3], area2: i64) -> Self {
        let ((ax, ay), (bx, by), (cx, cy)) = (a.bits(), b.bits(), c.bits());
        let (reciprocal, shift) = recip::area(area2.unsigned_abs());
        // From the vertex to the centre of the pixel that holds it: -127 to 128.
        let to_centre = |coordinate: i32| HALF_PIXEL - (coordinate & (SUBPIXELS - 1));
        Self {
            first: [bx - ax, by - ay],
            second: [cx - ax, cy - ay],
            negative: area2 < 0,
            reciprocal,
            shift: (54 - shift).unsigned_abs(),
            anchor: [ax >> SUBPIXEL_BITS, ay >> SUBPIXEL_BITS],
            to_centre: [to_centre(ax), to_centre(ay)],
        }
    }

    /// The column and row of the pixel that planes start from: the one that holds the first vertex.
    #[inline]
    pub const fn anchor(&self) -> [i32; 2] {
        self.anchor
    }

    /// The plane through three values of up to 32 bits, in canonical order. Each part is right modulo 2^32.
    pub(crate) fn plane(&self, [a, b, c]: [i64; 3]) -> Plane<i64> {
        let (d1, d2) = (b - a, c - a);
        let [dx1, dy1] = self.first.map(i64::from);
        let [dx2, dy2] = self.second.map(i64::from);
        let dx = self.quotient(d1 * dy2 - d2 * dy1);
        let dy = self.quotient(d2 * dx1 - d1 * dx2);
        let [ox, oy] = self.to_centre.map(i64::from);
        // The low 40 bits of the sum are right however large the gradients are, and 32 of them are used.
        let offset = dx.wrapping_mul(ox).wrapping_add(dy.wrapping_mul(oy)).wrapping_add(1 << 7) >> 8;
        Plane { start: a.wrapping_add(offset), dx, dy }
    }

    /// `256 numerator / area2`, rounded to nearest.
    #[inline]
    fn quotient(&self, numerator: i64) -> i64 {
        let numerator = if self.negative { -numerator } else { numerator };
        let reciprocal = u64::from(self.reciprocal);
        // The product in 96 bits: two words and a half.
        let low = u64::from(numerator as u32) * reciprocal;
        let high = (numerator >> 32) * reciprocal as i64 + (low >> 32) as i64;
        let rest = u64::from(low as u32);
        // 0 < shift: an area has at most 40 bits, and at least one.
        let rounded = if self.shift > 32 {
            return (high + (1 << (self.shift - 33))) >> (self.shift - 32);
        } else {
            rest + (1 << (self.shift - 1))
        };
        high.wrapping_shl(32 - self.shift).wrapping_add((rounded >> self.shift) as i64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::Setup;

    #[test]
    fn quotients_are_rounded_exactly() {
        let mut state = 1_u64;
        let mut random = |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as i64 & ((1 << bits) - 1)
        };
        for round in 0..200_000 {
            let bits = 2 + round % 18;
            let points = [(); 3].map(|()| Snapped::from_bits(random(bits) as i32, random(bits) as i32));
            let Some((setup, _)) = Setup::new(points) else { continue };
            let gradients = setup.gradients();
            let numerator = random(31) << 21 >> random(5) ^ -random(1);
            let exact = i128::from(numerator) * 256;
            let area = i128::from(setup.area2());
            let got = i128::from(gradients.quotient(numerator));
            // Half a step for the rounding, 2^-30 of the value for the reciprocal.
            let error = (got * area - exact).abs();
            assert!(error <= area.abs() / 2 + (exact.abs() >> 30) + 1, "{points:?} {numerator}: {got}");
        }
    }
}

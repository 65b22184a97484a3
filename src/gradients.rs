//! Plane equations from values at three vertices.
//!
//! Gradients come from one normalised reciprocal of the doubled area: `g = (d1 dy2 - d2 dy1) / area2`, the numerator
//! exact in 64 bits, the product with the reciprocal exact in 96, and one rounding to nearest. An error of the
//! reciprocal scales the plane about its first vertex, so it is harmless even for slivers.

use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS, SUBPIXELS};
use crate::math::{product, recip};
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
    /// Half of the last place that is kept, in the product's two words or in the one below.
    half: u64,
    /// No two vertices are 32 px or more apart on an axis.
    small: bool,
    /// The pixel that holds the first vertex.
    anchor: [i32; 2],
    to_centre: [i32; 2],
}

impl Gradients {
    /// Of a triangle in canonical order, with an area.
    #[inline]
    pub(crate) fn new([a, b, c]: [Snapped; 3], area2: i64) -> Self {
        let ((ax, ay), (bx, by), (cx, cy)) = (a.bits(), b.bits(), c.bits());
        let (reciprocal, normalised) = recip::area(area2.unsigned_abs());
        let shift = (54 - normalised).unsigned_abs();
        // From the vertex to the centre of the pixel that holds it: -127 to 128.
        let to_centre = |coordinate: i32| HALF_PIXEL - (coordinate & (SUBPIXELS - 1));
        Self {
            first: [bx - ax, by - ay],
            second: [cx - ax, cy - ay],
            negative: area2 < 0,
            reciprocal,
            shift,
            half: 1 << (if shift > 32 { shift - 33 } else { shift - 1 }),
            small: [bx - ax, by - ay, cx - ax, cy - ay]
                .iter()
                .all(|d| d.unsigned_abs() < 32 << SUBPIXEL_BITS),
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
        let ([dx1, dy1], [dx2, dy2]) = (self.first, self.second);
        let determinant = if self.small { small_determinant } else { determinant };
        let dx = self.quotient(determinant([d1, d2], [dy2, dy1]));
        let dy = self.quotient(determinant([d2, d1], [dx1, dx2]));
        Plane { start: a.wrapping_add(self.offset(dx, dy).into()), dx, dy }
    }

    /// What the plane changes by from the vertex to the anchor's centre: the low 32 bits are right however large the
    /// gradients are.
    #[inline]
    fn offset(&self, dx: i64, dy: i64) -> i32 {
        let [ox, oy] = self.to_centre;
        let sum = |of: fn(i64) -> i32| (of(dx) * ox).wrapping_add(of(dy) * oy);
        // In pieces of 16 bits, so that products of 32 bits do.
        let low = sum(|g| g as i32 & 0xFFFF);
        let middle = sum(|g| g as i32 >> 16);
        let high = sum(|g| (g >> 32) as i32 & 0xFF);
        // The middle is taken as signed, which is one of the high ones less where its top bit is set.
        let borrowed = sum(|g| i32::from((g as i32) < 0));
        ((high + borrowed) << 24).wrapping_add(middle << 8).wrapping_add((low + (1 << 7)) >> 8)
    }

    /// The numerator over the area, to nearest: in pixels, not in their 256 steps.
    #[inline(never)]
    fn quotient(&self, numerator: i64) -> i64 {
        let negative = (numerator < 0) != self.negative;
        let numerator = numerator.unsigned_abs();
        // The product in 96 bits: two words and one below.
        let low = product::unsigned(numerator as u32, self.reciprocal);
        let mut high = product::with_short(self.reciprocal, (numerator >> 32) as u32) + (low >> 32);
        let mut rest = low as u32;
        if negative {
            // Halves are rounded up, whichever sign: minus one step of what is below them, rounded down.
            let (less, borrow) = rest.overflowing_sub(1);
            (rest, high) = (less, high.wrapping_sub(borrow.into()));
        }
        // 0 < shift: an area has at most 40 bits, and at least one.
        let quotient = if self.shift > 32 {
            let rounded = high.wrapping_add(self.half);
            // Word by word: a chip without 64-bit shifts calls for them.
            let (shift, words) = (self.shift - 32, [rounded as u32, (rounded >> 32) as u32]);
            let below = words[0] >> shift | words[1] << (32 - shift);
            i64::from(words[1].cast_signed() >> shift) << 32 | i64::from(below)
        } else {
            (high << (32 - self.shift))
                .wrapping_add((u64::from(rest) + self.half) >> self.shift)
                .cast_signed()
        };
        if negative { -quotient } else { quotient }
    }
}

/// `d1 along2 - d2 along1` for differences of two values of 32 bits.
#[inline(never)]
fn determinant([d1, d2]: [i64; 2], [along2, along1]: [i32; 2]) -> i64 {
    times(d1, along2) - times(d2, along1)
}

/// The same for places less than 32 px apart: in halves of the differences, each of which fits 32 bits.
#[inline(always)]
fn small_determinant([d1, d2]: [i64; 2], [along2, along1]: [i32; 2]) -> i64 {
    let half = |of: fn(i64) -> i32| of(d1) * along2 - of(d2) * along1;
    (i64::from(half(|d| (d >> 16) as i32)) << 16) + i64::from(half(|d| d as i32 & 0xFFFF))
}

/// A difference of two values of 32 bits, times a difference of two places.
#[inline]
fn times(difference: i64, along: i32) -> i64 {
    let size = product::unsigned(difference.unsigned_abs() as u32, along.unsigned_abs()).cast_signed();
    if (difference < 0) != (along < 0) { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::Setup;

    // Red when a half of a difference is taken with another sign, or `small` allows places that overflow 32 bits here.
    #[test]
    fn small_determinants_are_the_same() {
        let differences = [0, 1, -1, 0xFFFF, -0xFFFF, 0x1_0000, -0x1_0000, 0xFFFF_FFFF, -0xFFFF_FFFF];
        let places = [0, 1, -1, 255, -256, 8191, -8191];
        for (d1, d2) in differences.iter().flat_map(|&d1| differences.map(|d2| (d1, d2))) {
            for (along1, along2) in places.iter().flat_map(|&p| places.map(|q| (p, q))) {
                let exact = d1 * i64::from(along2) - d2 * i64::from(along1);
                assert_eq!(small_determinant([d1, d2], [along2, along1]), exact);
                assert_eq!(determinant([d1, d2], [along2, along1]), exact);
            }
        }
    }

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

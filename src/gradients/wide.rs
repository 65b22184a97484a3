//! Gradients of any triangle.

use super::{Axis, Gradient};
use crate::math::{product, recip};

/// One over the doubled area of any triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Area {
    /// `1 / |area2| = reciprocal * 2^-(shift + 8)`.
    pub(super) reciprocal: u32,
    /// Above 0: an area has at most 40 bits, and at least one.
    pub(super) shift: u32,
    /// Whether the area is.
    negative: bool,
}

impl Area {
    /// Of any number of steps but none.
    #[inline(never)]
    pub(super) fn new(area2: i64) -> Self {
        let (reciprocal, normalised) = recip::area(area2.unsigned_abs());
        Self { reciprocal, shift: (54 - normalised).unsigned_abs(), negative: area2 < 0 }
    }

    /// Of the plane through three values, along an axis.
    #[inline(never)]
    pub(super) fn gradient(&self, axis: &Axis, values: &[i32; 3]) -> Gradient {
        let &[a, b, c] = values;
        let gradient = self.quotient(times(a, b, axis.second) - times(a, c, axis.first));
        Gradient { low: gradient as i32, over_256: (gradient >> 8) as i32 }
    }

    /// The numerator over the area, to nearest: in pixels, not in their 256 steps.
    fn quotient(&self, numerator: i64) -> i64 {
        let &Self { reciprocal, shift, negative } = self;
        let negative = (numerator < 0) != negative;
        let numerator = numerator.unsigned_abs();
        // The product in 96 bits: two words and one below.
        let low = product::unsigned(numerator as u32, reciprocal);
        let mut high = product::unsigned(reciprocal, (numerator >> 32) as u32) + (low >> 32);
        let mut rest = low as u32;
        if negative {
            // Halves are rounded up, whichever sign: minus one step of what is below them, rounded down.
            let (less, borrow) = rest.overflowing_sub(1);
            (rest, high) = (less, high.wrapping_sub(borrow.into()));
        }
        // In halves, of which one is added; from words, as a shift of 64 bits may be a call.
        let (middle, top) = (high as u32, (high >> 32) as u32);
        let by = shift - 1;
        let [low, middle, top] = if by < 32 {
            [rest, middle, top]
        } else {
            [middle, top, (top.cast_signed() >> 31).cast_unsigned()]
        };
        let shifted = |low: u32, high: u32| low >> (by & 31) | high << 1 << (!by & 31);
        let halves = u64::from(shifted(middle, top)) << 32 | u64::from(shifted(low, middle));
        let quotient = halves.wrapping_add(1).cast_signed() >> 1;
        if negative { -quotient } else { quotient }
    }
}

/// The difference of two values, times a difference of two places.
#[inline(never)]
fn times(from: i32, to: i32, along: i32) -> i64 {
    let size = product::unsigned(from.abs_diff(to), along.unsigned_abs()).cast_signed();
    if (to < from) != (along < 0) { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::super::Area;
    use crate::setup::Setup;
    use crate::snapped::Snapped;

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
            let Area::Any(any) = setup.gradients().area else { continue };
            let numerator = random(31) << 21 >> random(5) ^ -random(1);
            let exact = i128::from(numerator) * 256;
            let area = i128::from(setup.area2().abs());
            let got = i128::from(any.quotient(numerator * setup.area2().signum()));
            // Half a step for the rounding, 2^-30 of the value for the reciprocal.
            let error = (got * area - exact).abs();
            assert!(error <= area.abs() / 2 + (exact.abs() >> 30) + 1, "{points:?} {numerator}: {got}");
        }
    }
}

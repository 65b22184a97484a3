//! Gradients of triangles of some pixels: less than 32 px high and wide.

use super::rough::Rough;
use super::{Axis, Gradient};
use crate::math::recip;

/// Bits of the doubled area, in steps of 2^-16 px^2.
pub(super) const AREA_BITS: u32 = 25;

/// One over the doubled area of a small triangle.
///
/// Products of 32 bits with 32 are put together from halves, as a Cortex-M0+ multiplies: digits of 16 bits with a sign, so
/// that sums of two products need no carry.
#[derive(Clone, Copy, Debug)]
pub(super) struct Area {
    /// `1 / area2 = (2^16 high + low) * 2^-(shift + 24)`: high is from -2^15 to 2^15, and low has 16 bits with a sign.
    high: i32,
    low: i32,
    /// 7 to 31: an area has at most 25 bits.
    shift: u32,
    /// `2^(shift - 1)`.
    half: u32,
}

impl Area {
    /// Of less than 2^25 steps, of either sign.
    #[inline]
    pub(super) fn new(area2: i32) -> Self {
        let (reciprocal, normalised) = recip::small_area(area2.unsigned_abs());
        let shift = (38 - normalised).unsigned_abs() & 31;
        // That of a power of two is 2^31, of which the halves are right with either sign as well.
        let sign = area2 >> 31;
        let low = (i32::from(reciprocal as i16) ^ sign) - sign;
        let high = (((reciprocal + 0x8000) >> 16).cast_signed() ^ sign) - sign;
        Self { high, low, shift, half: 1 << shift >> 1 }
    }

    /// Of the plane through three values, along an axis.
    ///
    /// The numerators are exact, and so is their product with the reciprocal, but for what is below its last 16 bits: that
    /// cannot change how it is rounded. A numerator is less than 2^32 times the height or the width: 2^45.
    #[inline(always)]
    pub(super) fn gradients(&self, [a, b, c]: [i32; 3]) -> impl Fn(&Axis) -> Gradient {
        // Of the halves of differences: each has 17 bits with a sign.
        let differences = |half: fn(i32) -> i32| (half(b) - half(a), half(c) - half(a));
        let (high, low) = (differences(|value| value >> 16), differences(|value| value & 0xFFFF));
        move |axis| {
            let numerator = |(d1, d2): (i32, i32)| d1 * axis.second - d2 * axis.first;
            self.quotient(numerator(high), numerator(low))
        }
    }

    /// Its leading bits, for values of few. Nothing where the doubled area is less than two square pixels.
    #[inline(always)]
    pub(super) fn rough(&self) -> Option<Rough> {
        // 1 / area2 = high 2^-(shift + 8).
        Rough::new(self.high, self.shift)
    }

    /// `2^16 high + low`, over the area.
    #[inline(always)]
    fn quotient(&self, high: i32, low: i32) -> Gradient {
        // 2^32 whole_high + 2^16 whole_low + part: 2^13, 2^15 and 2^15 at most.
        let (above, part) = digits(low);
        let (whole_high, whole_low) = digits(high + above);
        // The product with the reciprocal, without its last 16 bits: 2^32 above + 2^16 middle + below. All of it fits, as
        // digits are halves of what 16 bits hold: 2^31, 2^31 and 2^29.
        let below = part * self.high + ((part * self.low) >> 16) + whole_low * self.low;
        let middle = whole_high * self.low + whole_low * self.high + (below >> 16);
        let above = whole_high * self.high + (middle >> 16);
        let product = i64::from(above) << 32 | i64::from((middle << 16 | below & 0xFFFF).cast_unsigned());
        let rounded = product + i64::from(self.half);
        // Word by word: a chip without 64-bit shifts calls for them. What is masked is below 32 already.
        let (words_low, words_high, shift) = (rounded as u32, (rounded >> 32) as i32, self.shift & 31);
        let low = words_low >> shift | words_high.cast_unsigned() << 1 << (31 - shift);
        let above = words_high >> shift;
        Gradient { low: low.cast_signed(), over_256: (low >> 8 | above.cast_unsigned() << 24).cast_signed() }
    }
}

/// `2^16 high + low`, where low is from -2^15 to 2^15 - 1.
#[inline(always)]
fn digits(value: i32) -> (i32, i32) {
    ((value + 0x8000) >> 16, i32::from(value as i16))
}

#[cfg(test)]
mod tests {
    use super::super::Area;
    use crate::setup::Setup;
    use crate::snapped::Snapped;

    // Red when a half of a product is taken with another sign or place, or a triangle counts as small that overflows.
    #[test]
    fn gradients_are_rounded_to_nearest() {
        let mut state = 1_u64;
        let mut random = |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as i64 & ((1 << bits) - 1)
        };
        let mut tried = 0;
        for round in 0..200_000 {
            let bits = 3 + round % 11;
            let points = [(); 3].map(|()| Snapped::from_bits(random(bits) as i32, random(bits) as i32));
            let Some((setup, _)) = Setup::new(points) else { continue };
            let of = setup.gradients();
            let Area::Small(area) = of.area else { continue };
            tried += 1;
            let size = random(5) as u32;
            // The ends of the range are as far apart as values can be.
            let values = [(); 3].map(|()| match random(3) {
                0 => i32::MIN,
                1 => i32::MAX,
                _ => (random(31) << 1 | random(1)) as i32 >> size,
            });
            let [a, b, c] = values.map(i64::from);
            let (d1, d2) = (b - a, c - a);
            let area2 = i128::from(setup.area2().abs());
            for axis in &of.axes {
                let numerator = d1 * i64::from(axis.second) - d2 * i64::from(axis.first);
                let numerator = numerator * setup.area2().signum();
                let got = area.gradients(values)(axis);
                let exact = i128::from(numerator) * 256;
                // Of the quotient, 40 bits are known: the rest is that of the exact one.
                let known = i128::from(got.over_256) << 8 | i128::from(got.low & 255);
                let quotient = known + ((exact / area2 - known + (1 << 39)) >> 40 << 40);
                // Half a step for the rounding, 2^-30 of the value for the reciprocal.
                let error = (quotient * area2 - exact).abs();
                assert!(
                    error <= area2 / 2 + (exact.abs() >> 30) + 1,
                    "{points:?} {d1} {d2}: {got:?}, {numerator} / {area2}"
                );
                assert_eq!(got.low >> 8, got.over_256 << 8 >> 8, "{got:?}");
            }
        }
        assert!(tried > 100_000, "{tried}");
    }
}

//! Gradients of triangles of some pixels: less than 32 px high and wide.

use super::{Gradient, Gradients};

/// Bits of the doubled area, in steps of 2^-16 px^2.
pub(super) const AREA_BITS: u32 = 25;

/// Of the plane through 0 and two differences, each of two values of 32 bits.
///
/// Products of 32 bits with 32 are put together from halves, as a Cortex-M0+ multiplies. The numerators are exact, and
/// so is their product with the reciprocal, but for what is below its last 16 bits: that cannot change how it is rounded.
#[inline(always)]
pub(super) fn gradients(of: &Gradients, d1: i64, d2: i64) -> (Gradient, Gradient) {
    let ([dx1, dy1], [dx2, dy2]) = (of.first, of.second);
    // 17 bits and a sign; and 16 bits.
    let high = |d: i64| (d >> 16) as i32;
    let low = |d: i64| d as i32 & 0xFFFF;
    let (d1_high, d1_low, d2_high, d2_low) = (high(d1), low(d1), high(d2), low(d2));
    (
        quotient(of, d1_high * dy2 - d2_high * dy1, d1_low * dy2 - d2_low * dy1),
        quotient(of, d2_high * dx1 - d1_high * dx2, d2_low * dx1 - d1_low * dx2),
    )
}

/// `2^16 high + low`, over the area.
#[inline(always)]
fn quotient(of: &Gradients, high: i32, low: i32) -> Gradient {
    // 2^16 whole + part.
    let (whole, part) = (high + (low >> 16), low as u32 & 0xFFFF);
    let (whole_high, whole_low) = (whole >> 16, whole as u32 & 0xFFFF);
    let (high, low) = (of.reciprocal >> 16, of.reciprocal & 0xFFFF);
    let middle = i64::from(whole_high * low.cast_signed()) + i64::from(whole_low * high);
    let below = i64::from(whole_low * low) + i64::from(part * high) + i64::from((part * low) >> 16);
    // The product with the reciprocal, without its last 16 bits.
    let product = (i64::from(whole_high * high.cast_signed()) << 32) + (middle << 16) + below;
    // 7 to 31: an area has at most 25 bits.
    let shift = of.shift - 16;
    let rounded = product + i64::from(1_u32 << (shift - 1));
    // Word by word: a chip without 64-bit shifts calls for them.
    let (words_low, words_high) = (rounded as u32, (rounded >> 32) as i32);
    let low = words_low >> shift | words_high.cast_unsigned() << (32 - shift);
    let above = words_high >> shift;
    Gradient { low: low.cast_signed(), over_256: (low >> 8 | above.cast_unsigned() << 24).cast_signed() }
}

#[cfg(test)]
mod tests {
    use super::*;
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
            if !of.small {
                continue;
            }
            tried += 1;
            let size = random(5) as u32;
            let [d1, d2] = [(); 2].map(|()| ((random(31) << 1 | random(1)) >> size) * (1 - 2 * random(1)));
            let area = i128::from(setup.area2().abs());
            let numerators = [
                d1 * i64::from(of.second[1]) - d2 * i64::from(of.first[1]),
                d2 * i64::from(of.first[0]) - d1 * i64::from(of.second[0]),
            ];
            for (got, numerator) in <[_; 2]>::from(gradients(&of, d1, d2)).into_iter().zip(numerators) {
                let exact = i128::from(numerator) * 256;
                // Of the quotient, 40 bits are known: the rest is that of the exact one.
                let known = i128::from(got.over_256) << 8 | i128::from(got.low & 255);
                let quotient = known + ((exact / area - known + (1 << 39)) >> 40 << 40);
                // Half a step for the rounding, 2^-30 of the value for the reciprocal.
                let error = (quotient * area - exact).abs();
                assert!(
                    error <= area / 2 + (exact.abs() >> 30) + 1,
                    "{points:?} {d1} {d2}: {got:?}, {numerator} / {area}"
                );
                assert_eq!(got.low >> 8, got.over_256 << 8 >> 8, "{got:?}");
            }
        }
        assert!(tried > 100_000, "{tried}");
    }
}

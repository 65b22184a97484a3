//! Gradients of values of few bits, as colours are: one product each, of a numerator and 16 bits of a reciprocal.

use super::{Axis, Gradient};

/// One over the doubled area of a small triangle, which is two square pixels or more.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rough {
    /// `1 / area2 = reciprocal 2^-(shift + 32)`: from 2^14 to 2^15 of either sign, so it is right to 2^-15.
    reciprocal: i32,
    /// 0 to 7.
    shift: u32,
    /// `2^(shift - 1)`, rounded down.
    half: i32,
}

impl Rough {
    /// `1 / area2 = reciprocal 2^-(shift + 8)`. Nothing where the area is too small.
    #[inline(always)]
    pub(super) fn new(reciprocal: i32, shift: u32) -> Option<Self> {
        let shift = shift.checked_sub(24)? & 7;
        Some(Self { reciprocal, shift, half: 1 << shift >> 1 })
    }

    /// Of the plane through three values from 0 to 2^24, along an axis.
    ///
    /// Differences are rounded down to 2^8 steps; the numerator is exact then, and below 2^30. What the product is rounded down by
    /// is less than a step, as is what the gradient is rounded by: a step for both, as with no shift there is nothing to round.
    #[inline(always)]
    pub(super) fn gradients(&self, [a, b, c]: [i32; 3]) -> impl Fn(&Axis) -> Gradient {
        let &Self { reciprocal, shift, half } = self;
        let (d1, d2) = ((b - a) >> 8, (c - a) >> 8);
        move |axis| {
            let numerator = d1 * axis.second - d2 * axis.first;
            let product = (numerator >> 16) * reciprocal + (((numerator & 0xFFFF) * reciprocal) >> 16);
            let low = (product + half) >> shift;
            Gradient { low, over_256: low >> 8 }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Area;
    use crate::setup::Setup;
    use crate::snapped::Snapped;

    // Red when a half of the product is taken with another sign or place, or a triangle is taken that is too small.
    #[test]
    fn gradients_are_as_near_as_colours_need() {
        let mut state = 1_u64;
        let mut random = |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as i64 & ((1 << bits) - 1)
        };
        let mut tried = 0;
        for round in 0..200_000 {
            let bits = 7 + round % 7;
            let points = [(); 3].map(|()| Snapped::from_bits(random(bits) as i32, random(bits) as i32));
            let Some((setup, _)) = Setup::new(points) else { continue };
            let of = setup.gradients();
            let Area::Small(area) = of.area else { continue };
            let area2 = setup.area2();
            let Some(rough) = area.rough() else {
                assert!(area2.abs() < 2 << 16, "{points:?}");
                continue;
            };
            tried += 1;
            // The ends of the range are as far apart as values can be.
            let values = [(); 3].map(|()| match random(2) {
                0 => 0,
                1 => 1 << 24,
                _ => random(24) as i32,
            });
            let [a, b, c] = values.map(i64::from);
            for axis in &of.axes {
                let (second, first) = (i64::from(axis.second), i64::from(axis.first));
                let numerator = (b - a) * second - (c - a) * first;
                let got = rough.gradients(values)(axis);
                assert_eq!(got.over_256, got.low >> 8);
                // All over the area: a step, 2^8 steps of either difference, and 2^-15 of the gradient.
                let error = (i64::from(got.low) * area2 - numerator * 256).abs();
                let bound = area2.abs() + 256 * 256 * (second.abs() + first.abs()) + (numerator.abs() >> 7);
                assert!(error <= bound, "{points:?} {values:?}: {got:?}, {numerator} / {area2}");
            }
        }
        assert!(tried > 80_000, "{tried}");
    }
}

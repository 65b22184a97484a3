//! Points of flat drawings, from floats without float arithmetic.

#![cfg_attr(
    not(test),
    expect(clippy::disallowed_types, reason = "floats may enter here; only their bits are read")
)]

use crate::math::format::{Coord, SUBPIXEL_BITS};
use crate::snapped::Snapped;

/// A point of a flat drawing, in pixels: x to the right, y down; (0.5, 0.5) is the centre of the top left pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    at: Snapped,
    finite: bool,
}

impl Point {
    /// From fixed-point coordinates, exactly.
    pub const fn new(x: Coord, y: Coord) -> Self {
        Self { at: Snapped { x, y }, finite: true }
    }

    /// Where the point is, if it is anywhere.
    pub(crate) const fn snapped(&self) -> Option<Snapped> {
        if self.finite { Some(self.at) } else { None }
    }
}

/// A point from floats, rounded to the nearest 1/256 px, halves up: what is moved by whole pixels is
/// drawn the same.
///
/// Coordinates beyond ±8 388 608 px are held there. A point that is not finite is nowhere: what has it draws nothing.
///
/// ```
/// use topleft::{Coord, Point, point};
///
/// assert_eq!(point(20.0, -12.5), Point::new(Coord::lit("20"), Coord::lit("-12.5")));
/// assert_eq!(point(1e30, 0.001), Point::new(Coord::MAX, Coord::lit("0")));
/// ```
pub const fn point(x: f32, y: f32) -> Point {
    Point { at: Snapped::from_bits(steps(x), steps(y)), finite: x.is_finite() && y.is_finite() }
}

/// A float in steps of 1/256, by its bits: no soft-float routine is linked for it.
const fn steps(value: f32) -> i32 {
    let bits = value.to_bits();
    let exponent = (bits >> 23 & 0xFF) as i32;
    let mantissa = (bits & 0x7F_FFFF | 0x80_0000) as i64;
    // value = mantissa * 2^(exponent - 150), and a step is 2^-8.
    let shift = exponent - 150 + SUBPIXEL_BITS as i32;
    let negative = bits >> 31 == 1;
    let size = if shift > 31 {
        1 << 31
    } else if shift >= 0 {
        mantissa << shift
    } else if shift >= -25 {
        // Halves up: of a negative number, to the smaller size.
        (mantissa + (1 << (-shift - 1)) - negative as i64) >> -shift
    } else {
        0
    };
    let signed = if negative { -size } else { size };
    if signed > i32::MAX as i64 {
        i32::MAX
    } else if signed < i32::MIN as i64 {
        i32::MIN
    } else {
        signed as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_rounded_to_the_nearest_step() {
        let mut state = 7_u32;
        for _ in 0..1_000_000 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let value = f32::from_bits(state);
            if value.is_finite() {
                let exact =
                    (f64::from(value) * 256.0 + 0.5).floor().clamp(f64::from(i32::MIN), f64::from(i32::MAX));
                assert_eq!(steps(value), exact as i32, "{value}");
            }
        }
        assert_eq!(point(f32::NAN, 0.0).snapped(), None);
        assert_eq!(point(0.0, f32::INFINITY).snapped(), None);
    }
}

//! Vertices on the screen, snapped to 1/256 px: what coverage, facing and gradients are all computed from.

use crate::math::format::{Coord, HALF_PIXEL, SUBPIXEL_BITS};

/// A vertex on the screen, in steps of 1/256 px.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Snapped {
    /// To the right.
    pub x: Coord,
    /// Down.
    pub y: Coord,
}

impl Snapped {
    /// From steps of 1/256 px.
    #[inline]
    pub const fn from_bits(x: i32, y: i32) -> Self {
        Self { x: Coord::from_bits(x), y: Coord::from_bits(y) }
    }

    #[inline]
    pub(crate) const fn bits(self) -> (i32, i32) {
        (self.x.to_bits(), self.y.to_bits())
    }

    /// What canonical order compares: the row first.
    #[inline]
    pub(crate) const fn order(self) -> i64 {
        let (x, y) = self.bits();
        (y as i64) << 32 | (x ^ i32::MIN).cast_unsigned() as i64
    }
}

/// The first row or column whose pixel centres are at or beyond a coordinate.
#[inline]
pub(crate) const fn first_centre(coordinate: i32) -> i32 {
    (coordinate + (HALF_PIXEL - 1)) >> SUBPIXEL_BITS
}

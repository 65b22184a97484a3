//! The edges of all other triangles: quotient and remainder.

use core::num::NonZeroU32;

use super::Edge;
use super::short::{FRACTION_BITS, ShortEdge};
use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS, SUBPIXELS};
use crate::math::product;
use crate::snapped::{Snapped, first_centre};

/// An edge as quotient and remainder.
///
/// `column - remainder / height` is exact, `0 <= remainder < height`.
#[derive(Clone, Copy, Debug)]
pub(in crate::raster) struct Dda {
    column: i32,
    remainder: i32,
    /// Columns and remainder a row: `slope + slope_remainder / height`.
    slope: i32,
    slope_remainder: i32,
    height: i32,
}

impl Edge for Dda {
    const INSIDE: bool = false;

    /// The edge from its upper to its lower end, at `row`. Nothing where it is level: it crosses no row.
    #[inline(never)]
    fn new(upper: Snapped, lower: Snapped, row: i32) -> Self {
        let ((x, y), (lower_x, lower_y)) = (upper.bits(), lower.bits());
        // A level edge has no rows: any height does.
        let height = NonZeroU32::new((lower_y - y).unsigned_abs()).unwrap_or(NonZeroU32::MIN);
        let (slope, slope_remainder) = floor_divide(lower_x - x, height);
        let first = first_centre(y);
        // From the upper end down to the first row of centres: 0 to 255 steps.
        let down = (first << SUBPIXEL_BITS) + HALF_PIXEL - y;
        // In steps of 1/256 px, where the edge passes that row, from the centre of column 0: whole, then over height.
        let whole = x - HALF_PIXEL + down * slope;
        let (column, steps) = (whole >> SUBPIXEL_BITS, whole & (SUBPIXELS - 1));
        // 0 to 2 columns further, in 1/(256 height): rounded up to whole columns.
        let over = steps.unsigned_abs() * height.get() + down.unsigned_abs() * slope_remainder;
        let one = height.get() << SUBPIXEL_BITS;
        let up = u32::from(over > 0) + u32::from(over > one);
        let mut edge = Self {
            column: column + up as i32,
            // All steps are multiples of 256 in that unit: what is below them never counts.
            remainder: ((up * one - over) >> SUBPIXEL_BITS).cast_signed(),
            slope,
            slope_remainder: slope_remainder.cast_signed(),
            height: height.get().cast_signed(),
        };
        edge.skip(row - first, height);
        edge
    }

    /// One row down.
    #[inline(always)]
    fn step(&mut self) {
        let remainder = self.remainder - self.slope_remainder;
        // All ones where the remainder runs below zero: one column more then. Without a branch, which a small core
        // would take twice.
        let below = remainder >> 31;
        self.remainder = remainder + (self.height & below);
        self.column += self.slope - below;
    }

    #[inline(always)]
    fn column(&self) -> i32 {
        self.column
    }
}

/// A height of 2^20 has the short edge's fraction bits for a remainder: what is missing from the next column, less a step.
impl From<ShortEdge> for Dda {
    #[inline(always)]
    fn from(short: ShortEdge) -> Self {
        let (place, slope) = short.steps();
        let (one, whole) = (1 << FRACTION_BITS, |steps: i32| steps >> FRACTION_BITS);
        let below = one - 1;
        Self {
            column: whole(place),
            remainder: !place & below,
            slope: whole(slope),
            slope_remainder: slope & below,
            height: one,
        }
    }
}

impl Dda {
    /// `rows` further down at once, for a window that starts inside the triangle.
    #[inline]
    fn skip(&mut self, rows: i32, height: NonZeroU32) {
        if rows <= 0 {
            return;
        }
        self.column += rows * self.slope;
        // At most 4095 rows, each at least 256 steps of the height: the product stays below 2^32.
        let sum = rows.unsigned_abs() * self.slope_remainder.unsigned_abs();
        let remainder = self.remainder.unsigned_abs();
        if sum > remainder {
            let missing = sum - remainder;
            // As many columns more as bring it back to 0 or above.
            let (columns, rest) = product::divided(missing - 1, height);
            self.column += columns as i32 + 1;
            self.remainder = (height.get() - 1 - rest).cast_signed();
        } else {
            self.remainder = (remainder - sum).cast_signed();
        }
    }
}

/// Quotient rounded down, and the remainder from 0 up. Steep edges, the most common, need no division.
#[inline]
fn floor_divide(dx: i32, height: NonZeroU32) -> (i32, u32) {
    let size = dx.unsigned_abs();
    let (quotient, remainder) = if size < height.get() { (0, size) } else { product::divided(size, height) };
    if dx >= 0 {
        (quotient as i32, remainder)
    } else if remainder == 0 {
        (-(quotient as i32), 0)
    } else {
        (-(quotient as i32) - 1, height.get() - remainder)
    }
}

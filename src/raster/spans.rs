//! The span walk: two edges as integer DDAs.

use core::num::NonZeroU32;

use super::{Span, Traversal, Window};
use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS, SUBPIXELS};
use crate::setup::Setup;
use crate::snapped::{Snapped, first_centre};

/// Walks the rows of a triangle with an exact integer DDA on either side: no test and no rounding per pixel.
///
/// With the top-left rule both ends of a span are the same function of an edge, the first pixel centre at or right of
/// it, whichever side the triangle is on: so neighbours cannot disagree.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spans;

impl Traversal for Spans {
    fn walk<E>(setup: &Setup, window: &Window, mut draw: impl FnMut(Span) -> Result<(), E>) -> Result<(), E> {
        let [top, middle, bottom] = setup.points();
        let rows = setup.rows();
        let mut y = rows.start.max(window.rows.start);
        let end = rows.end.min(window.rows.end);
        if y >= end {
            return Ok(());
        }
        let turn = first_centre(middle.y.to_bits());
        let middle_is_right = setup.area2() > 0;
        let mut long = Edge::new(top, bottom, y);
        // The long edge faces the upper short edge first and then the lower one.
        for (from, to, stop) in [(top, middle, turn.min(end)), (middle, bottom, end)] {
            if y >= stop {
                continue;
            }
            let short = Edge::new(from, to, y);
            let (mut left, mut right) = if middle_is_right { (long, short) } else { (short, long) };
            while y < stop {
                let (start, end) =
                    (left.column.max(window.columns.start), right.column.min(window.columns.end));
                if start < end {
                    draw(Span { y, start, end })?;
                }
                left.step();
                right.step();
                y += 1;
            }
            long = if middle_is_right { left } else { right };
        }
        Ok(())
    }
}

/// An edge at the centres of one row: the first column whose centre is at or right of it.
///
/// `column - remainder / height` is exact, `0 <= remainder < height`.
#[derive(Clone, Copy, Debug)]
struct Edge {
    column: i32,
    remainder: i32,
    /// Columns and remainder a row: `slope + slope_remainder / height`.
    slope: i32,
    slope_remainder: i32,
    height: i32,
}

impl Edge {
    /// The edge from its upper to its lower end, at `row`. Nothing where it is level: it crosses no row.
    #[inline]
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
            let columns = (missing - 1) / height + 1;
            self.column += columns as i32;
            self.remainder = (columns * height.get() - missing).cast_signed();
        } else {
            self.remainder = (remainder - sum).cast_signed();
        }
    }
}

/// Quotient rounded down, and the remainder from 0 up. Steep edges, the most common, need no division.
#[inline]
fn floor_divide(dx: i32, height: NonZeroU32) -> (i32, u32) {
    let size = dx.unsigned_abs();
    let (quotient, remainder) =
        if size < height.get() { (0, size) } else { (size / height, size - size / height * height.get()) };
    if dx >= 0 {
        (quotient as i32, remainder)
    } else if remainder == 0 {
        (-(quotient as i32), 0)
    } else {
        (-(quotient as i32) - 1, height.get() - remainder)
    }
}

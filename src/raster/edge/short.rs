//! The edges of small triangles: one addition a row.

use core::ops::Range;

use super::Edge;
use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS};
use crate::math::recip;
use crate::setup::Setup;
use crate::snapped::{Snapped, first_centre};

/// An edge less than 32 px high and wide in fixed point, which is exact all the same.
///
/// With h the edge's height in steps of 1/256 px, it passes the rows of pixel centres at `(256 k + c) / (256 h)` columns
/// from a centre, for whole k, and with the same c from 0 to 255 in all rows. Moved to the right by
/// `(128 - c) / (256 h)`, or by -1/(2 h) where c is 0, it keeps at least 1/(2 h) from all centres, and passes left of
/// the same ones: h < 2^13, so that is more than 64 steps of 2^-20. All that is rounded is less: the slope by at most
/// 1.1 steps, and that up to 32 times; 0.3 for what is missing of its reciprocal, over the whole edge; 3 for the row
/// and for the move.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct ShortEdge {
    /// Where the edge passes, moved, from one column left of the centres of column 0.
    place: i32,
    slope: i32,
}

/// Kernels in assembly have this number as well.
pub(in crate::raster) const FRACTION_BITS: u32 = 20;
/// The slope of a lower edge may not fit.
const LOWEST: i32 = 4;
/// Columns that have room.
const COLUMNS: i32 = 2047;

impl ShortEdge {
    /// The reciprocals that slopes are found with, for a [`Kernel`](crate::stages::Kernel) that finds them: at i it is
    /// 2^22 / (64 + i) rounded to nearest, less 2^15.
    ///
    /// ```
    /// use topleft::stages::ShortEdge;
    ///
    /// // 2^22 / 96 is 43690.7.
    /// assert_eq!(ShortEdge::reciprocals()[32], 43691 - (1 << 15));
    /// ```
    #[must_use]
    #[inline(always)]
    pub fn reciprocals() -> &'static [u16; 65] {
        recip::short_table()
    }

    /// Whether a triangle's edges can be walked like this: it is small, and no column of it is outside of the window.
    #[inline]
    pub(in crate::raster) fn suits(setup: &Setup, columns: &Range<i32>) -> bool {
        let [a, b, c] = setup.points();
        let ((ax, ay), (bx, by), (cx, cy)) = (a.bits(), b.bits(), c.bits());
        let (left, right) = (columns.start << SUBPIXEL_BITS, columns.end << SUBPIXEL_BITS);
        // Sign bits: one test for all. Columns may be any, even from their end to their start: none of those has room.
        let beyond = |low: i32, high: i32| high.wrapping_sub(low);
        let inside = |x: i32| beyond(left, x) | beyond(x, right);
        let few = beyond(-COLUMNS, columns.start)
            | beyond(columns.start, columns.end)
            | beyond(columns.end, COLUMNS);
        let room = inside(ax) | inside(bx) | inside(cx) | few;
        // And one more: of most triangles, no edge is low.
        let low = beyond(ay + LOWEST, by) | beyond(by + LOWEST, cy);
        setup.is_small() && room >= 0 && (low >= 0 || (fits(ay, by) && fits(by, cy)))
    }
}

/// Whether an edge's slope fits: it is high enough, or crosses no row.
#[inline(never)]
fn fits(upper: i32, lower: i32) -> bool {
    lower - upper >= LOWEST || first_centre(upper) == first_centre(lower)
}

impl Edge for ShortEdge {
    const INSIDE: bool = true;

    /// Linked once: three of them in one function have too many values for a core of few registers.
    #[inline(never)]
    fn new(upper: Snapped, lower: Snapped, row: i32) -> Self {
        let ((x, y), (lower_x, lower_y)) = (upper.bits(), lower.bits());
        let (dx, height) = (lower_x - x, lower_y - y);
        // 2^(18 + shift) / height, up to 2^-13.4 of it too great.
        let (reciprocal, shift) = recip::short(height.cast_unsigned());
        let reciprocal = reciprocal.cast_signed();
        // dx 2^20 / height, and what is missing from it: the products wrap, and what is missing has 20 bits.
        let estimate = ((dx * reciprocal) << 2) >> shift;
        let missing = (dx << FRACTION_BITS).wrapping_sub(estimate.wrapping_mul(height));
        let slope = estimate.wrapping_add(((missing >> 6) * reciprocal) >> 12 >> shift);
        // From the upper end down to the row's centres: c is the same in all rows.
        let down = (row << SUBPIXEL_BITS) + HALF_PIXEL - y;
        let right = x - HALF_PIXEL;
        // 128 - c, and -128 where c is 0.
        let middle = 127 - (right.wrapping_mul(height).wrapping_add(down * dx).wrapping_sub(1) & 255);
        let place = ((right + 256) << (FRACTION_BITS - SUBPIXEL_BITS))
            .wrapping_add(down.wrapping_mul(slope >> SUBPIXEL_BITS))
            .wrapping_add((down * (slope & 255)) >> SUBPIXEL_BITS)
            .wrapping_add((middle * reciprocal) >> 6 >> shift);
        Self { place, slope }
    }

    #[inline(always)]
    fn column(&self) -> i32 {
        self.place >> FRACTION_BITS
    }

    #[inline(always)]
    fn step(&mut self) {
        self.place = self.place.wrapping_add(self.slope);
    }
}

impl ShortEdge {
    /// Where it is, and what is added from row to row, in steps of 2^-20 columns.
    #[inline(always)]
    pub(super) const fn steps(self) -> (i32, i32) {
        (self.place, self.slope)
    }
}

#[cfg(test)]
impl ShortEdge {
    /// Of the place and the slope, in bytes.
    pub(in crate::raster) const OFFSETS: [usize; 2] =
        [core::mem::offset_of!(Self, place), core::mem::offset_of!(Self, slope)];
}

#[cfg(test)]
mod tests {
    use super::super::Dda;
    use super::*;

    fn same(upper: Snapped, lower: Snapped) -> usize {
        let rows = first_centre(upper.y.to_bits())..first_centre(lower.y.to_bits());
        if rows.is_empty() || lower.y.to_bits() - upper.y.to_bits() < LOWEST {
            return 0;
        }
        let mut count = 0;
        // From every row that a window can start in.
        for top in rows.clone() {
            let (mut short, mut exact) = (ShortEdge::new(upper, lower, top), Dda::new(upper, lower, top));
            let mut converted = Dda::from(short);
            for row in top..rows.end {
                assert_eq!(short.column(), exact.column(), "{upper:?} {lower:?}, row {row} from {top}");
                assert_eq!(converted.column(), exact.column(), "{upper:?} {lower:?}, row {row} from {top}");
                short.step();
                exact.step();
                converted.step();
                count += 1;
            }
        }
        count
    }

    // Red when one is converted to a Dda without its fraction, or with that of its slope rounded; when an edge is not moved, when its slope lacks what is missing from the estimate, or has 18 fraction bits.
    #[test]
    fn short_edges_are_those_of_the_dda() {
        let mut state = 1_u64;
        let mut random = |below: i32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % below.unsigned_abs() as u64) as i32
        };
        let mut rows = 0;
        for round in 0..60_000 {
            let (x, y) = ((40 << 8) + random(1960 << 8), random(2000 << 8));
            // All lengths; the longest, whose margin is least; and edges that pass through centres of pixels.
            let (dx, dy) = match round % 4 {
                0 => (random(2 * 8191) - 8191, random(8192)),
                1 => (8191 - random(9), 8191 - random(200)),
                2 => (-8191 + random(9), 8191 - random(200)),
                _ => ((random(63) - 31) << 8, random(32) << 8),
            };
            let (x, y) = if round % 4 == 3 { (x | 255, y | 255) } else { (x, y) };
            let (x, y) = if round % 8 == 7 { (x - 127, y - 127) } else { (x, y) };
            rows += same(Snapped::from_bits(x, y), Snapped::from_bits(x + dx, y + dy));
        }
        assert!(rows > 5_000_000, "{rows}");
    }
}

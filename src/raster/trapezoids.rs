//! A triangle as two trapezoids: the rows that the span walk steps through.

use core::ops::Range;

use super::edge::{Dda, Edge, ShortEdge};
use super::{DrawSpan, Span};
use crate::setup::Setup;
use crate::snapped::first_centre;

/// A triangle as two trapezoids: the long edge faces the upper short edge first and then the lower one.
///
/// A [`Kernel`](crate::stages::Kernel) in assembly reads it where it lies; one in Rust has
/// [`Rows::spans`](crate::stages::Rows::spans). Its words, in order, as in C:
///
/// | bytes | what |
/// |---|---|
/// | 0, 4, 8 | `i32`: the first row, the first of the lower trapezoid, the one after the last |
/// | 12, 16 | `i32`: the left side in the first row, and its slope: what is added from row to row |
/// | 20, 24 | the same of the right side |
/// | 28, 32 | the same of the side that is replaced, in the first row of the lower trapezoid |
/// | 36 | `bool`, a byte: whether that is the right one |
///
/// A side is in steps of 2^-20 px: its whole part is the first column at or right of it. From the left side's column up to, and
/// without, the right side's the row is covered; where the left one is not less, it is empty.
#[derive(Debug)]
#[repr(C)]
pub struct Trapezoids<S> {
    /// The first row, the first of the lower trapezoid, and the one after the last.
    pub(super) top: i32,
    turn: i32,
    pub(super) bottom: i32,
    left: S,
    right: S,
    /// The lower short edge, and its side.
    lower: S,
    lower_is_right: bool,
}

impl<S: Edge> Trapezoids<S> {
    /// In some rows, of which there is one.
    #[inline]
    pub(super) fn new(setup: &Setup, Range { start: top, end: bottom }: Range<i32>) -> Self {
        let [a, b, c] = setup.points();
        let turn = first_centre(b.y.to_bits()).max(top).min(bottom);
        let long = S::new(a, c, top);
        let upper = if top < turn { S::new(a, b, top) } else { long };
        let lower = if turn < bottom { S::new(b, c, turn) } else { upper };
        // It is not 0: one word tells.
        let lower_is_right = setup.area2() >= 0;
        let (left, right) = if lower_is_right { (long, upper) } else { (upper, long) };
        Self { top, turn, bottom, left, right, lower, lower_is_right }
    }

    #[inline(never)]
    pub(super) fn rows<E>(&self, columns: &Range<i32>, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        let &Self { top: mut y, turn, bottom, mut left, mut right, lower, lower_is_right } = self;
        let mut stop = turn;
        loop {
            while y < stop {
                let (mut start, mut end) = (left.column(), right.column());
                if !S::INSIDE {
                    (start, end) = (start.max(columns.start), end.min(columns.end));
                }
                if start < end {
                    target.draw(Span { y, start, end })?;
                }
                left.step();
                right.step();
                y += 1;
            }
            if stop >= bottom {
                return Ok(());
            }
            *(if lower_is_right { &mut right } else { &mut left }) = lower;
            stop = bottom;
        }
    }
}

impl Trapezoids<Dda> {
    /// The same rows.
    #[inline(never)]
    pub(super) fn from_short(short: &Trapezoids<ShortEdge>) -> Self {
        let &Trapezoids { top, turn, bottom, left, right, lower, lower_is_right } = short;
        let (left, right, lower) = (left.into(), right.into(), lower.into());
        Self { top, turn, bottom, left, right, lower, lower_is_right }
    }
}

#[cfg(test)]
mod tests {
    use core::mem::{offset_of, size_of};

    use super::super::edge::FRACTION_BITS;
    use super::*;

    // Red when a field of either is moved, or an edge has other fraction bits: kernels in assembly have these numbers.
    #[test]
    fn assembly_finds_the_fields_where_they_were() {
        type Short = Trapezoids<ShortEdge>;
        let sides = [offset_of!(Short, left), offset_of!(Short, right), offset_of!(Short, lower)];
        assert_eq!([offset_of!(Short, top), offset_of!(Short, turn), offset_of!(Short, bottom)], [0, 4, 8]);
        assert_eq!((sides, offset_of!(Short, lower_is_right)), ([12, 20, 28], 36));
        assert_eq!((ShortEdge::OFFSETS, size_of::<ShortEdge>(), FRACTION_BITS), ([0, 4], 8, 20));
    }
}

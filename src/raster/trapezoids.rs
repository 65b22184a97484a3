//! A triangle as two trapezoids: the rows that the span walk steps through.

use core::ops::Range;

use super::edge::Edge;
use super::{DrawSpan, Span};
use crate::setup::Setup;
use crate::snapped::first_centre;

/// A triangle as two trapezoids: the long edge faces the upper short edge first and then the lower one.
///
/// A [`Kernel`](crate::stages::Kernel) in assembly finds its fields where they are: in this order, as in C.
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

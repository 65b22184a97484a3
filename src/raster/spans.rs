//! The span walk: two edges from row to row, without any test or rounding a pixel.

use core::ops::Range;

use super::edge::{Dda, Edge, ShortEdge};
use super::{DrawSpan, Span, Traversal, Window};
use crate::setup::Setup;
use crate::snapped::first_centre;

/// Walks the rows of a triangle with an exact integer edge on either side: no test and no rounding per pixel.
///
/// With the top-left rule both ends of a span are the same function of an edge, the first pixel centre at or right of
/// it, whichever side the triangle is on: so neighbours cannot disagree. Edges are integer DDAs, or one addition a row
/// where the triangle is small enough for that to be exact as well.
///
/// The cheapest for all but the smallest triangles: up to 4 px [`BySize`](super::BySize) is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spans;

impl Traversal for Spans {
    #[inline]
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        match Sides::new(setup, window) {
            Sides::None => Ok(()),
            Sides::Short(trapezoids) => trapezoids.rows(&window.columns, target),
            Sides::Long(trapezoids) => trapezoids.rows(&window.columns, target),
        }
    }
}

/// A triangle's edges. Whatever is drawn between them, this is linked once.
enum Sides {
    /// It crosses no row of the window.
    None,
    Short(Trapezoids<ShortEdge>),
    Long(Trapezoids<Dda>),
}

impl Sides {
    #[inline(never)]
    fn new(setup: &Setup, window: &Window) -> Self {
        let rows = setup.rows();
        let rows = rows.start.max(window.rows.start)..rows.end.min(window.rows.end);
        if rows.is_empty() {
            Self::None
        } else if ShortEdge::suits(setup, &window.columns) {
            Self::Short(Trapezoids::new(setup, rows))
        } else {
            Self::Long(Trapezoids::new(setup, rows))
        }
    }
}

/// A triangle as two trapezoids: the long edge faces the upper short edge first and then the lower one.
struct Trapezoids<S> {
    /// The first row, the first of the lower trapezoid, and the one after the last.
    top: i32,
    turn: i32,
    bottom: i32,
    left: S,
    right: S,
    /// The lower short edge, and its side.
    lower: S,
    lower_is_right: bool,
}

impl<S: Edge> Trapezoids<S> {
    /// In some rows, of which there is one.
    #[inline]
    fn new(setup: &Setup, Range { start: top, end: bottom }: Range<i32>) -> Self {
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
    fn rows<E>(self, columns: &Range<i32>, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        let Self { top: mut y, turn, bottom, mut left, mut right, lower, lower_is_right } = self;
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

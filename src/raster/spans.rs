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
#[derive(Clone, Copy, Debug, Default)]
pub struct Spans;

impl Traversal for Spans {
    #[inline]
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        if ShortEdge::suits(setup, &window.columns) {
            halves::<ShortEdge, E>(setup, window, target)
        } else {
            halves::<Dda, E>(setup, window, target)
        }
    }
}

/// The long edge faces the upper short edge first and then the lower one.
#[inline]
fn halves<S: Edge, E>(
    setup: &Setup,
    window: &Window,
    target: &mut impl DrawSpan<E>,
) -> Result<(), E> {
    let [top, middle, bottom] = setup.points();
    let rows = setup.rows();
    let mut y = rows.start.max(window.rows.start);
    let end = rows.end.min(window.rows.end);
    if y >= end {
        return Ok(());
    }
    let turn = first_centre(middle.y.to_bits()).min(end);
    let middle_is_right = setup.area2() > 0;
    let mut long = S::new(top, bottom, y);
    if y < turn {
        let short = S::new(top, middle, y);
        let (left, right) = if middle_is_right { (long, short) } else { (short, long) };
        let ends = rows_between(left, right, y..turn, &window.columns, target)?;
        long = if middle_is_right { ends.0 } else { ends.1 };
        y = turn;
    }
    if y < end {
        let short = S::new(middle, bottom, y);
        let (left, right) = if middle_is_right { (long, short) } else { (short, long) };
        rows_between(left, right, y..end, &window.columns, target)?;
    }
    Ok(())
}

/// The rows between two edges; where the edges are after them.
#[inline(never)]
fn rows_between<S: Edge, E>(
    mut left: S,
    mut right: S,
    rows: Range<i32>,
    columns: &Range<i32>,
    target: &mut impl DrawSpan<E>,
) -> Result<(S, S), E> {
    let Range { start: mut y, end: stop } = rows;
    while y < stop {
        let mut span = Span { y, start: left.column(), end: right.column() };
        if !S::INSIDE {
            (span.start, span.end) = (span.start.max(columns.start), span.end.min(columns.end));
        }
        if span.start < span.end {
            target.draw(span)?;
        }
        left.step();
        right.step();
        y += 1;
    }
    Ok((left, right))
}

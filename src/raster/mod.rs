//! Stage 5. Which pixels a triangle covers: one [`Span`] a row.
//!
//! Takes a [`Setup`] and a [`Window`]; gives spans from the top down. There are two walks with
//! one answer, exact for every triangle inside the guard rectangle:
//!
//! * [`Spans`] steps the left and the right edge from row to row: as an integer DDA, or, where a triangle is small enough
//!   for that to be exact as well, by one addition.
//! * [`BoxWalk`] tests the edge functions at every pixel of the bounding box.
//!
//! [`BySize`] takes the box for the smallest triangles and spans for all others.
//!
//! A pixel belongs to a triangle where its centre is inside, or on a top or left edge.

use core::ops::Range;

use crate::setup::Setup;

mod box_walk;
mod by_size;
mod edge;
mod kernel;
mod small_triangle;
mod spans;
mod trapezoids;

pub use box_walk::BoxWalk;
pub use by_size::BySize;
pub use edge::ShortEdge;
pub use kernel::{Kernel, Rows, Shade, Sides, Tested, TexelsOverW};
pub use small_triangle::{FoundSides, SmallTriangle};
pub use spans::{Spans, SpansBy};
pub use trapezoids::Trapezoids;

/// The covered pixels of one row: columns `start` up to, and without, `end`. Never empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// The row.
    pub y: i32,
    /// The first column.
    pub start: i32,
    /// The column after the last.
    pub end: i32,
}

/// The pixels that may be drawn: a rectangle of columns and rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Window {
    /// Columns, from 0 up.
    pub columns: Range<i32>,
    /// Rows, from 0 up.
    pub rows: Range<i32>,
}

/// How a triangle's pixels are found. A type parameter: only the walk that is used is linked.
pub trait Traversal {
    /// Hands each span of the triangle inside the window to `target`, from the top down, until it fails.
    ///
    /// # Errors
    /// What `target` returned.
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E>;

    /// The same with a function.
    ///
    /// ```
    /// use topleft::Spans;
    /// use topleft::stages::{Setup, Snapped, Span, Traversal, Window};
    ///
    /// let at = |x, y| Snapped::from_bits(x * 256, y * 256);
    /// let (setup, _) = Setup::new([at(0, 0), at(4, 0), at(0, 2)]).unwrap();
    /// let mut spans = Vec::new();
    /// let window = Window { columns: 0..8, rows: 0..8 };
    /// let Ok(()) = Spans::walk::<core::convert::Infallible>(&setup, &window, |span| Ok(spans.push(span)));
    /// assert_eq!(spans, [Span { y: 0, start: 0, end: 3 }, Span { y: 1, start: 0, end: 1 }]);
    /// ```
    ///
    /// # Errors
    /// What `draw` returned.
    #[inline]
    fn walk<E>(setup: &Setup, window: &Window, mut draw: impl FnMut(Span) -> Result<(), E>) -> Result<(), E> {
        Self::spans(setup, window, &mut draw)
    }
}

/// What is done with each span: any function of one, or the stages that follow.
pub trait DrawSpan<E> {
    /// Draws it.
    ///
    /// # Errors
    /// Where it could not be drawn: no other follows.
    fn draw(&mut self, span: Span) -> Result<(), E>;

    /// Whether [`rows`](Self::rows) may ever draw any: where it may not, no kernel is linked or asked.
    #[inline(always)]
    fn has_kernels(&self) -> bool
    where
        Self: Sized,
    {
        false
    }

    /// Has all rows of a triangle drawn by a kernel: whether it knew how to. If not, nothing was drawn: the spans follow.
    #[inline(always)]
    fn rows<K: Kernel>(&mut self, sides: Sides<'_>) -> bool
    where
        Self: Sized,
    {
        let _ = sides;
        false
    }
}

impl<E, F: FnMut(Span) -> Result<(), E>> DrawSpan<E> for F {
    #[inline]
    fn draw(&mut self, span: Span) -> Result<(), E> {
        self(span)
    }
}

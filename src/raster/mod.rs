//! Stage 5. Which pixels a triangle covers: one [`Span`] a row.
//!
//! Takes a [`Setup`] and a [`Window`]; gives spans from the top down. There are two walks with
//! one answer, exact for every triangle inside the guard rectangle:
//!
//! * [`Spans`] steps the left and the right edge from row to row as an integer DDA: quotient and remainder.
//! * [`BoxWalk`] tests the edge functions at every pixel of the bounding box.
//!
//! A pixel belongs to a triangle where its centre is inside, or on a top or left edge.

use core::ops::Range;

use crate::setup::Setup;

mod box_walk;
mod edge;
mod spans;

pub use box_walk::BoxWalk;
pub use spans::Spans;

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
    /// Hands each span of the triangle inside the window to `draw`, from the top down, until it fails.
    ///
    /// # Errors
    /// What `draw` returned.
    fn walk<E>(setup: &Setup, window: &Window, draw: impl DrawSpan<E>) -> Result<(), E>;
}

/// What is done with each span: any function of one, or the stages that follow.
pub trait DrawSpan<E> {
    /// Draws it.
    ///
    /// # Errors
    /// Where it could not be drawn: no other follows.
    fn draw(&mut self, span: Span) -> Result<(), E>;
}

impl<E, F: FnMut(Span) -> Result<(), E>> DrawSpan<E> for F {
    #[inline]
    fn draw(&mut self, span: Span) -> Result<(), E> {
        self(span)
    }
}

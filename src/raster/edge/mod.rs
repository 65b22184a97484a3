//! Edges from row to row.

use crate::snapped::Snapped;

mod dda;
mod short;

pub(super) use dda::Dda;
#[cfg(test)]
pub(super) use short::FRACTION_BITS;
pub use short::ShortEdge;

/// An edge at the centres of one row.
pub trait Edge: Copy {
    /// Whether no column is ever outside of the window.
    const INSIDE: bool;

    /// The edge from its upper to its lower end, at `row`: one of those that it crosses.
    fn new(upper: Snapped, lower: Snapped, row: i32) -> Self;

    /// The first column whose centre is at or right of the edge.
    fn column(&self) -> i32;

    /// One row down.
    fn step(&mut self);
}

//! A small triangle whose sides a chip's own code may find.

use core::marker::PhantomData;
use core::ops::Range;

use super::edge::ShortEdge;
use super::trapezoids::Trapezoids;
use crate::setup::Setup;

/// The lifetime stands for one triangle: neither a longer nor a shorter one will do for it.
type Only<'t> = PhantomData<fn(&'t ()) -> &'t ()>;

/// A small triangle, and rows of it, on the way to its sides.
///
/// What a [`Kernel`](crate::stages::Kernel) may rely on: of the rows there is at least one, and the triangle crosses them all. Its
/// vertices are less than 32 px apart on both axes, and from column -2047 to 2047; an edge that crosses a row is at least
/// 4/256 px high.
#[derive(Debug)]
pub struct SmallTriangle<'t> {
    setup: &'t Setup,
    rows: Range<i32>,
    only: Only<'t>,
}

/// The sides of a [`SmallTriangle`]: of the one with this lifetime, and no other. In memory it is [`Trapezoids`].
///
/// So a kernel draws between the sides of the triangle that it was asked for, if it has no `unsafe` blocks:
///
/// ```compile_fail
/// use topleft::stages::{FoundSides, SmallTriangle};
///
/// fn of_another<'a: 'b, 'b>(other: SmallTriangle<'a>, _: SmallTriangle<'b>) -> FoundSides<'b> {
///     other.sides()
/// }
/// ```
#[derive(Debug)]
#[repr(transparent)]
pub struct FoundSides<'t> {
    trapezoids: Trapezoids<ShortEdge>,
    only: Only<'t>,
}

impl<'t> SmallTriangle<'t> {
    #[inline(always)]
    pub(super) const fn new(setup: &'t Setup, rows: Range<i32>) -> Self {
        Self { setup, rows, only: PhantomData }
    }

    /// The triangle.
    #[inline(always)]
    pub const fn setup(&self) -> &'t Setup {
        self.setup
    }

    /// The rows.
    #[inline(always)]
    pub const fn rows(&self) -> &Range<i32> {
        &self.rows
    }

    /// Its sides, as the library finds them.
    #[must_use]
    #[inline(never)]
    pub fn sides(self) -> FoundSides<'t> {
        FoundSides { trapezoids: Trapezoids::new(self.setup, self.rows), only: PhantomData }
    }
}

impl FoundSides<'_> {
    #[inline(always)]
    pub(super) const fn trapezoids(&self) -> &Trapezoids<ShortEdge> {
        &self.trapezoids
    }
}

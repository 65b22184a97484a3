//! Stages 6 and 7. The pixels of a span on their way to the target: depth decides which of them are shaded.

use crate::depth::Depth;
use crate::varying::Varying;

/// Some pixels of a row, ready to be shaded: their colours, and what lies there already.
#[expect(missing_debug_implementations, reason = "its cells are of any kind")]
pub struct Run<'r, P, D: Depth> {
    pub(crate) colours: &'r mut [P],
    pub(crate) depths: D::Plane<'r>,
    /// At the first pixel, and the step to the next.
    pub(crate) depth: D::Varying,
    pub(crate) step: D::Varying,
}

/// A pixel of a run.
#[expect(missing_debug_implementations, reason = "its cell is of any kind")]
pub struct Place<'r, P, D: Depth> {
    colour: &'r mut P,
    cell: D::Cell<'r>,
    depth: D::Varying,
}

impl<'r, P, D: Depth> Run<'r, P, D> {
    /// How many there are.
    #[inline]
    pub fn len(&self) -> usize {
        self.colours.len()
    }

    /// Whether there is none.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.colours.is_empty()
    }

    /// The pixels, from left to right.
    #[inline(always)]
    pub fn pixels(self) -> impl Iterator<Item = Place<'r, P, D>> {
        let Self { colours, depths, mut depth, step } = self;
        colours.iter_mut().zip(D::cells(depths)).map(move |(colour, cell)| {
            let place = Place { colour, cell, depth };
            depth = depth.plus(step);
            place
        })
    }
}

impl<P, D: Depth> Place<'_, P, D> {
    /// Gives the pixel a colour where the triangle is nearer than what it shows.
    #[inline(always)]
    pub fn shade(self, colour: impl FnOnce() -> P) {
        if D::cover(self.cell, self.depth) {
            *self.colour = colour();
        }
    }
}

//! Stage 6. Which pixels of a span are visible, before any of them is shaded.
//!
//! Each way to decide it has a file: [`NoDepth`] does not, [`Painter`] has decided before, and [`Depth16`] and
//! [`DepthFloat`] keep the nearest depth of each pixel in a [`buffer`].

use crate::attributes::Words;
use crate::gradients::Plane;
use crate::raster::Tested;
use crate::varying::Varying;

mod buffer;
mod depth16;
mod float;
mod none;
mod painter;

pub use depth16::Depth16;
pub use float::DepthFloat;
pub use none::NoDepth;
pub(crate) use painter::Nearness;
pub use painter::Painter;

/// What hides what. A type parameter: a list without depth has no buffer, no cycle and no code for it.
pub trait Depth {
    /// What a vertex carries for it.
    type Vertex: Words;
    /// What changes over a triangle.
    type Varying: Varying;
    /// The cells of a strip.
    type Plane<'p>;
    /// One of them.
    type Cell<'p>;
    /// Some of them.
    #[doc(hidden)]
    type Cells<'p>: Iterator<Item = Self::Cell<'p>>;

    /// Whether nothing hides anything.
    #[doc(hidden)]
    const ALWAYS_VISIBLE: bool = false;

    /// From `1 - z / w`, in 32 fraction bits.
    #[doc(hidden)]
    fn vertex(nearness: impl FnOnce() -> u32) -> Self::Vertex;

    #[doc(hidden)]
    fn varying(vertex: Self::Vertex) -> Self::Varying;

    #[doc(hidden)]
    fn reborrow<'p>(plane: &'p mut Self::Plane<'_>) -> Self::Plane<'p>;

    #[doc(hidden)]
    fn clear(plane: &mut Self::Plane<'_>);

    /// The colours and the cells of a span.
    #[doc(hidden)]
    fn span<'p, P>(
        colours: &'p mut [P],
        plane: &'p mut Self::Plane<'_>,
        first: usize,
        length: usize,
    ) -> Option<(&'p mut [P], Self::Plane<'p>)>;

    /// Whether there are kernels for it.
    #[doc(hidden)]
    const KERNELS: bool = false;

    /// Some cells for a kernel, and how they are tested with a triangle's plane, if there are kernels for that.
    #[doc(hidden)]
    #[inline(always)]
    fn for_kernel(cells: Self::Plane<'_>, plane: Plane<Self::Varying>) -> Option<(&mut [u16], Tested)> {
        let _ = (cells, plane);
        None
    }

    #[doc(hidden)]
    fn cells(plane: Self::Plane<'_>) -> Self::Cells<'_>;

    /// Calls `visible` with each run of the colours whose cells `start`, and `step` more from one to the next, is nearer
    /// than, and how far from the first it starts.
    #[doc(hidden)]
    fn runs<P>(
        colours: &mut [P],
        plane: Self::Plane<'_>,
        start: Self::Varying,
        step: Self::Varying,
        visible: impl FnMut(usize, &mut [P]),
    );

    /// Whether `depth` is nearer than the cell, which is that far away from now on.
    #[doc(hidden)]
    fn cover(cell: Self::Cell<'_>, depth: Self::Varying) -> bool;
}

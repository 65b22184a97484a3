//! Stage 6. Which pixels of a span are visible, before any of them is shaded.
//!
//! A depth code is a `u16`: 0 is cleared and beyond the far plane, and greater is nearer. It is
//! `4 + 65528 (1 - z / w)`, linear on the screen, from 4 at the far plane to 65 532 at the near one: the margin of 4
//! codes is more than interpolation is ever off by, so the wrapping plane never crosses an end of the range.

use core::ops::Range;

use crate::attributes::Words;
use crate::math::format::DepthCode;
use crate::varying::Varying;

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

    /// From `1 - z / w`, in 32 fraction bits.
    #[doc(hidden)]
    fn vertex(nearness: impl FnOnce() -> u32) -> Self::Vertex;

    #[doc(hidden)]
    fn varying(vertex: Self::Vertex) -> Self::Varying;

    #[doc(hidden)]
    fn reborrow<'p>(plane: &'p mut Self::Plane<'_>) -> Self::Plane<'p>;

    #[doc(hidden)]
    fn clear(plane: &mut Self::Plane<'_>);

    #[doc(hidden)]
    fn span<'p>(plane: &'p mut Self::Plane<'_>, span: Range<usize>) -> Option<Self::Plane<'p>>;

    #[doc(hidden)]
    fn cells(plane: Self::Plane<'_>) -> Self::Cells<'_>;

    /// Whether `depth` is nearer than the cell, which is that far away from now on.
    #[doc(hidden)]
    fn cover(cell: Self::Cell<'_>, depth: Self::Varying) -> bool;
}

/// No depth: what is drawn later hides what was drawn before.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoDepth;

/// A 16-bit depth buffer: the nearer pixel hides the other, and the earlier of two that are equal.
#[derive(Clone, Copy, Debug, Default)]
pub struct Depth16;

impl Depth for NoDepth {
    type Vertex = ();
    type Varying = ();
    type Plane<'p> = ();
    type Cell<'p> = ();
    type Cells<'p> = core::iter::Repeat<()>;

    #[inline]
    fn vertex(_: impl FnOnce() -> u32) {}

    #[inline]
    fn varying((): ()) {}

    #[inline]
    fn reborrow((): &mut ()) {}

    fn clear((): &mut ()) {}

    #[inline(always)]
    fn span((): &mut (), _: Range<usize>) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn cells((): Self::Plane<'_>) -> Self::Cells<'_> {
        core::iter::repeat(())
    }

    #[inline(always)]
    fn cover((): (), (): ()) -> bool {
        true
    }
}

/// Bits of a 1 at the near plane that the margins take away: `2^32 - 2^19` is 65 528 codes.
const MARGIN_BITS: u32 = 13;
/// The code of the far plane.
const FAR: u32 = 4 << 16;

impl Depth for Depth16 {
    type Vertex = DepthVertex;
    type Varying = DepthCode;
    type Plane<'p> = &'p mut [u16];
    type Cell<'p> = &'p mut u16;
    type Cells<'p> = core::slice::IterMut<'p, u16>;

    #[inline]
    fn vertex(nearness: impl FnOnce() -> u32) -> DepthVertex {
        let near = nearness();
        DepthVertex(DepthCode::from_bits(near - (near >> MARGIN_BITS) + FAR))
    }

    #[inline]
    fn varying(vertex: DepthVertex) -> DepthCode {
        vertex.0
    }

    #[inline]
    fn reborrow<'p>(plane: &'p mut &mut [u16]) -> &'p mut [u16] {
        plane
    }

    fn clear(plane: &mut &mut [u16]) {
        plane.fill(0);
    }

    #[inline(always)]
    fn span<'p>(plane: &'p mut &mut [u16], span: Range<usize>) -> Option<&'p mut [u16]> {
        plane.get_mut(span)
    }

    #[inline(always)]
    fn cells(plane: Self::Plane<'_>) -> Self::Cells<'_> {
        plane.iter_mut()
    }

    #[inline(always)]
    fn cover(cell: &mut u16, depth: DepthCode) -> bool {
        let code = (depth.to_bits() >> 16) as u16;
        let nearer = code > *cell;
        if nearer {
            *cell = code;
        }
        nearer
    }
}

/// A vertex's depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthVertex(DepthCode);

impl Words for DepthVertex {
    const WORDS: usize = 1;

    fn store(self, put: &mut impl FnMut(u32)) {
        put(self.0.to_bits());
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        words.next().map(|word| Self(DepthCode::from_bits(word)))
    }
}

//! What all depth buffers of 16 bits have in common: their cells, and the loops over them.
//!
//! `1 - z / w` is interpolated in 32 fraction bits, between margins that keep the wrapping plane from crossing an end of its
//! range. At each pixel a [`Code`] makes 16 bits of it: 0 is cleared, and greater is nearer.

use super::Depth;
use crate::attributes::Words;
use crate::fill::fill;
use crate::gradients::Plane;
use crate::math::format::DepthCode;
use crate::raster::Tested;

/// How 32 bits of depth become 16.
pub trait Code {
    /// The far plane is at 2 to this, and the near plane as far from 2^32.
    const MARGIN_BITS: u32;

    /// The code of a depth, below 2^16: it never falls where depths grow, and is not 0 where there is something.
    fn of(depth: u32) -> u32;

    /// Whether there are kernels for these codes.
    const KERNELS: bool = false;

    /// How a kernel tests cells with a plane, if there are kernels for these codes.
    #[inline(always)]
    fn tested(plane: Plane<DepthCode>) -> Option<Tested> {
        let _ = plane;
        None
    }
}

impl<C: Code> Depth for C {
    type Vertex = DepthVertex;
    type Varying = DepthCode;
    type Plane<'p> = &'p mut [u16];
    type Cell<'p> = &'p mut u16;
    type Cells<'p> = core::slice::IterMut<'p, u16>;
    const KERNELS: bool = C::KERNELS;

    #[inline]
    fn vertex(nearness: impl FnOnce() -> u32) -> DepthVertex {
        let near = nearness();
        DepthVertex(DepthCode::from_bits(near - (near >> (31 - C::MARGIN_BITS)) + (1 << C::MARGIN_BITS)))
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
        fill(plane, 0);
    }

    #[inline(always)]
    fn span<'p, P>(
        colours: &'p mut [P],
        plane: &'p mut &mut [u16],
        first: usize,
        length: usize,
    ) -> Option<(&'p mut [P], &'p mut [u16])> {
        // Said here of both, so that a small core compares the end twice and nothing else.
        let end = first.checked_add(length)?;
        if end > colours.len() || end > plane.len() {
            return None;
        }
        Some((colours.get_mut(first..end)?, plane.get_mut(first..end)?))
    }

    #[inline(always)]
    fn for_kernel(cells: Self::Plane<'_>, plane: Plane<DepthCode>) -> Option<(&mut [u16], Tested)> {
        Some((cells, C::tested(plane)?))
    }

    #[inline(always)]
    fn cells(plane: Self::Plane<'_>) -> Self::Cells<'_> {
        plane.iter_mut()
    }

    #[inline(always)]
    fn runs<P>(
        colours: &mut [P],
        mut cells: Self::Plane<'_>,
        start: DepthCode,
        step: DepthCode,
        mut visible: impl FnMut(usize, &mut [P]),
    ) {
        let (mut skipped, mut depth, step) = (0, start.to_bits(), step.to_bits());
        // Visible first: most spans are visible to their end.
        loop {
            let nearer = cells.len() - cover::<C>(cells, depth, step);
            if nearer != 0
                && let Some(shown) = colours.get_mut(skipped..skipped + nearer)
            {
                visible(skipped, shown);
            }
            let Some(rest) = cells.get_mut(nearer..).filter(|rest| !rest.is_empty()) else { return };
            depth = depth.wrapping_add(step.wrapping_mul(nearer as u32));
            let hidden = rest.len() - hidden::<C>(rest, depth, step);
            let Some(rest) = rest.get_mut(hidden..).filter(|rest| !rest.is_empty()) else { return };
            depth = depth.wrapping_add(step.wrapping_mul(hidden as u32));
            skipped += nearer + hidden;
            cells = rest;
        }
    }

    #[inline(always)]
    fn cover(cell: &mut u16, depth: DepthCode) -> bool {
        let code = C::of(depth.to_bits());
        let nearer = code > u32::from(*cell);
        if nearer {
            *cell = code as u16;
        }
        nearer
    }
}

/// How many cells are left after those from the first on that are as near as the plane, or nearer.
#[inline(never)]
fn hidden<C: Code>(mut cells: &[u16], mut depth: u32, step: u32) -> usize {
    while let [cell, rest @ ..] = cells {
        core::hint::black_box(());
        if C::of(depth) > u32::from(*cell) {
            break;
        }
        depth = depth.wrapping_add(step);
        cells = rest;
    }
    cells.len()
}

/// Writes the plane into the cells that it is nearer than, up to the first that it is not; how many are left.
#[inline(never)]
fn cover<C: Code>(mut cells: &mut [u16], mut depth: u32, step: u32) -> usize {
    loop {
        // Keeps the loop as it is: unrolled, it needs more registers than a small core has.
        core::hint::black_box(());
        match cells {
            [cell, rest @ ..] => {
                if !C::cover(cell, DepthCode::from_bits(depth)) {
                    return rest.len() + 1;
                }
                depth = depth.wrapping_add(step);
                cells = rest;
            }
            [] => return 0,
        }
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

//! A 16-bit depth, linear on the screen.
//!
//! A code is a `u16`: 0 is cleared and beyond the far plane, and greater is nearer. It is
//! `4 + 65528 (1 - z / w)`, linear on the screen, from 4 at the far plane to 65 532 at the near one: the margin of 4
//! codes is more than interpolation is ever off by, so the wrapping plane never crosses an end of the range.

use core::ops::Range;

use super::Depth;
use crate::attributes::Words;
use crate::math::format::DepthCode;

/// A 16-bit depth buffer: the nearer pixel hides the other, and the earlier of two that are equal.
#[derive(Clone, Copy, Debug, Default)]
pub struct Depth16;

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
    fn runs(
        mut cells: Self::Plane<'_>,
        _: usize,
        start: DepthCode,
        step: DepthCode,
        mut visible: impl FnMut(Range<usize>),
    ) {
        let (mut at, mut code, step) = (0, start.to_bits(), step.to_bits());
        // Visible first: most spans are visible to their end.
        loop {
            let nearer = cover(cells, code, step);
            if nearer != 0 {
                visible(at..at + nearer);
            }
            let Some(rest) = cells.get_mut(nearer..).filter(|rest| !rest.is_empty()) else { return };
            code = code.wrapping_add(step.wrapping_mul(nearer as u32));
            let hidden = hidden(rest, code, step);
            let Some(rest) = rest.get_mut(hidden..).filter(|rest| !rest.is_empty()) else { return };
            code = code.wrapping_add(step.wrapping_mul(hidden as u32));
            at += nearer + hidden;
            cells = rest;
        }
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

/// How many cells from the first on are as near as the plane, or nearer.
#[inline(never)]
fn hidden(cells: &[u16], mut code: u32, step: u32) -> usize {
    let mut count = 0;
    for &cell in cells {
        core::hint::black_box(());
        if (code >> 16) as u16 > cell {
            break;
        }
        code = code.wrapping_add(step);
        count += 1;
    }
    count
}

/// Writes the plane into the cells that it is nearer than, up to the first that it is not; how many they were.
#[inline(never)]
fn cover(cells: &mut [u16], mut code: u32, step: u32) -> usize {
    let mut count = 0;
    for cell in cells {
        // Keeps the loop as it is: unrolled, it needs more registers than a small core has.
        core::hint::black_box(());
        if !Depth16::cover(cell, DepthCode::from_bits(code)) {
            break;
        }
        code = code.wrapping_add(step);
        count += 1;
    }
    count
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

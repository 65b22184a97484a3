//! A 16-bit depth, linear on the screen.
//!
//! A code is `4 + 65528 (1 - z / w)`, from 4 at the far plane to 65 532 at the near one: the margin of 4 codes is more than
//! interpolation is ever off by.

use super::buffer::Code;
use crate::gradients::Plane;
use crate::math::format::DepthCode;
use crate::raster::Tested;

/// A 16-bit depth buffer: the nearer pixel hides the other, and the earlier of two that are equal.
#[derive(Clone, Copy, Debug, Default)]
pub struct Depth16;

impl Code for Depth16 {
    // 4 codes.
    const MARGIN_BITS: u32 = 18;
    const KERNELS: bool = true;

    #[inline(always)]
    fn of(depth: u32) -> u32 {
        depth >> 16
    }

    #[inline(always)]
    fn tested(plane: Plane<DepthCode>) -> Option<Tested> {
        Some(Tested::Depth16(plane))
    }
}

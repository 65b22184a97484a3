//! A reciprocal a pixel by division, for chips that divide.

use core::marker::PhantomData;
use core::num::NonZeroU32;

use super::super::over_w::{OverW, TexelBox};
use super::per_pixel::reciprocals;
use super::{Correction, Sampler};
use crate::math::format::Attribute;
use crate::transform::PerVertexInverse;

/// Who divides. The quotient is defined to the bit, so a chip's divider changes what is drawn only where it is wrong.
///
/// ```
/// use core::num::NonZeroU32;
/// use topleft::{Divide, Divided, Texture, Textured};
///
/// #[derive(Clone, Copy, Debug)]
/// enum OfTheChip {}
///
/// impl Divide for OfTheChip {
///     fn divide(numerator: u32, denominator: NonZeroU32) -> u32 {
///         numerator / denominator // or by two registers of the RP2040, which take 8 cycles
///     }
/// }
///
/// let textured = Textured::new(&Texture::WHITE, Divided::<OfTheChip>::new());
/// ```
pub trait Divide: Copy {
    /// `numerator / denominator`, rounded down.
    fn divide(numerator: u32, denominator: NonZeroU32) -> u32;
}

/// The division of the language: one instruction on a Cortex-M4, some 200 cycles of a Cortex-M0+.
#[derive(Clone, Copy, Debug)]
pub enum Portable {}

impl Divide for Portable {
    #[inline(always)]
    fn divide(numerator: u32, denominator: NonZeroU32) -> u32 {
        numerator / denominator
    }
}

/// A reciprocal a pixel, by one division of 32 bits by 17. The same on every chip.
///
/// As [`PerPixel`](super::PerPixel), with a reciprocal that is off by -2^-15 to 2^-16: a texel by at most `U (2^-15 + 2^-16)`, and by
/// what interpolating 1/w adds.
#[derive(Clone, Copy, Debug)]
pub struct Divided<D = Portable>(PhantomData<D>);

impl<D> Divided<D> {
    /// By the divider that the type names.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<D> Default for Divided<D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: Divide> Correction for Divided<D> {
    type Varying = OverW;
    type Triangle = TexelBox;
    const PERSPECTIVE: bool = true;

    fn words(self) -> [u32; 2] {
        [0; 2]
    }

    #[inline]
    fn from_words(_: [u32; 2]) -> Self {
        Self::new()
    }

    #[inline]
    fn triangle(
        self,
        texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        _: [u8; 2],
    ) -> (TexelBox, [OverW; 3]) {
        TexelBox::of(texels, inverses)
    }

    #[inline(always)]
    fn walk<T>(
        self,
        triangle: &TexelBox,
        start: OverW,
        step: &OverW,
        run: &mut [T],
        sampler: &mut impl Sampler<T>,
    ) {
        // (2^32 - 1) / (2^16 + x / 2^16), the denominator from 2^16 up to 2^17: never 0, and 2^16 at most.
        let reciprocal =
            |x: u32| D::divide(u32::MAX, NonZeroU32::new(x >> 16 | 1 << 16).unwrap_or(NonZeroU32::MIN));
        reciprocals(triangle, start, step, run, reciprocal, sampler);
    }
}

//! No correction, and the loop that steps texels from pixel to pixel.

use super::{Correction, Sampler};
use crate::gradients::Plane;
use crate::math::format::Attribute;
use crate::raster::Shade;
use crate::texture::Texture;
use crate::transform::PerVertexInverse;

/// No correction: texels are linear on the screen.
///
/// Off by up to `U (sqrt(r) - 1) / (sqrt(r) + 1)` texels on a triangle that spans U texels, with r its largest w over
/// its least: nothing at r = 1, a third of the texture at r = 4. The cheapest, and right for what is small, far or flat.
#[derive(Clone, Copy, Debug, Default)]
pub struct Affine;

impl Correction for Affine {
    type Varying = [Attribute; 2];
    type Triangle = ();
    const PERSPECTIVE: bool = false;
    const KERNELS: bool = true;

    fn words(self) -> [u32; 2] {
        [0; 2]
    }

    #[inline]
    fn from_words(_: [u32; 2]) -> Self {
        Self
    }

    #[inline]
    fn triangle(
        self,
        texels: [[Attribute; 2]; 3],
        _: [PerVertexInverse; 3],
        _: [u8; 2],
    ) -> ((), [[Attribute; 2]; 3]) {
        ((), texels)
    }

    #[inline(always)]
    fn walk<T>(
        self,
        (): &(),
        start: [Attribute; 2],
        step: &[Attribute; 2],
        run: &mut [T],
        sampler: &mut impl Sampler<T>,
    ) {
        sampler.steps(run, start.map(Attribute::to_bits), step.map(Attribute::to_bits));
    }

    #[inline(always)]
    fn for_kernel<'a>(
        self,
        texture: Texture<'a>,
        (): &(),
        texels: Plane<[Attribute; 2]>,
    ) -> Option<Shade<'a>> {
        Some(Shade::Affine(texture, texels))
    }
}

//! From what is linear on the screen to texels: perspective correction, as exact as the caller asks for.
//!
//! Each method has a file. [`Affine`] steps texels; [`PerPixel`] and [`Divided`] take a reciprocal a pixel;
//! [`Subspans`] takes one every few pixels and steps between; [`Within`] picks the cheapest of these that keeps an
//! error. They share two loops: the one that steps (`affine.rs`), and the one that divides (`per_pixel.rs`).

use super::sampler::Sampler;
use crate::gradients::Plane;
use crate::math::format::Attribute;
use crate::raster::Shade;
use crate::texture::Texture;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

mod affine;
mod divided;
mod per_pixel;
mod subspans;
mod within;

pub use affine::Affine;
pub use divided::{Divide, Divided, Portable};
pub use per_pixel::PerPixel;
pub use subspans::Subspans;
pub use within::Within;

/// How texture coordinates follow the screen: [`Affine`], [`Subspans`], [`PerPixel`], [`Divided`] or [`Within`].
pub trait Correction: Copy {
    /// What changes from pixel to pixel.
    type Varying: Varying;
    /// What all pixels of a triangle share.
    type Triangle: Copy;
    /// Whether a vertex carries 1/w.
    const PERSPECTIVE: bool;

    /// This method in two words, as a list keeps it.
    fn words(self) -> [u32; 2];

    /// The method that was kept.
    fn from_words(words: [u32; 2]) -> Self;

    /// What is linear on the screen for three vertices with these texel coordinates, in a texture whose width and
    /// height are these powers of two.
    fn triangle(
        self,
        texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        sizes_log2: [u8; 2],
    ) -> (Self::Triangle, [Self::Varying; 3]);

    /// Whether [`is_affine`](Self::is_affine) is ever true: it is not asked otherwise.
    const FINDS_AFFINE: bool = false;

    /// Whether it is soon seen that [`Affine`] is as near as the caller allowed. A list asks once, and never
    /// [chooses](Self::choose) for such a triangle.
    #[inline(always)]
    fn is_affine(self, texels: [[Attribute; 2]; 3], inverses: [PerVertexInverse; 3]) -> bool {
        let _ = (texels, inverses);
        false
    }

    /// Has a triangle drawn: by this method, or by a cheaper one that is as near as the caller allowed.
    #[inline(always)]
    fn choose<D: DrawTexels>(
        self,
        texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        sizes_log2: [u8; 2],
        onto: D,
    ) -> D::Output {
        let (triangle, varyings) = self.triangle(texels, inverses, sizes_log2);
        onto.draw(self, triangle, varyings)
    }

    /// Hands each pixel of a run to `sampler`, from the first to the last, with the column and row of its texel, before
    /// wrapping or clamping.
    fn walk<T>(
        self,
        triangle: &Self::Triangle,
        start: Self::Varying,
        step: &Self::Varying,
        run: &mut [T],
        sampler: &mut impl Sampler<T>,
    );

    /// Whether [`for_kernel`](Self::for_kernel) may ever give something.
    const KERNELS: bool = false;

    /// How a [`Kernel`](crate::stages::Kernel) finds the texels of a triangle, from column 0 of its first row on: nothing where
    /// it may not, or the method has more to it than kernels know.
    #[inline(always)]
    fn for_kernel<'a>(
        self,
        texture: Texture<'a>,
        triangle: &Self::Triangle,
        varying: Plane<Self::Varying>,
    ) -> Option<Shade<'a>> {
        let _ = (texture, triangle, varying);
        None
    }
}

/// What a method hands a triangle to, once it is chosen.
pub trait DrawTexels {
    /// What comes of it.
    type Output;

    /// Draws the triangle: what its pixels share, and the varyings at its vertices.
    fn draw<C: Correction>(self, method: C, triangle: C::Triangle, varyings: [C::Varying; 3])
    -> Self::Output;
}

//! From what is linear on the screen to texels: perspective correction, as exact as the caller asks for.

use crate::math::format::{Attribute, Inverse};
use crate::math::recip;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// How texture coordinates follow the screen: [`Affine`] or [`PerPixel`]. All draw through the same loop.
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

    /// What is linear on the screen for three vertices with these texel coordinates.
    fn triangle(
        self,
        texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
    ) -> (Self::Triangle, [Self::Varying; 3]);

    /// Hands each pixel of a run to `each`, with the column and row of its texel, before wrapping or clamping.
    fn walk<T>(
        self,
        triangle: &Self::Triangle,
        start: Self::Varying,
        step: &Self::Varying,
        pixels: impl Iterator<Item = T>,
        each: impl FnMut(T, i32, i32),
    );
}

/// No correction: texels are linear on the screen.
///
/// Off by up to `U (sqrt(r) - 1) / (sqrt(r) + 1)` texels on a triangle that spans U texels, with r its largest w over
/// its least: nothing at r = 1, a third of the texture at r = 4. The cheapest, and right for what is small, far or flat.
#[derive(Clone, Copy, Debug, Default)]
pub struct Affine;

/// A reciprocal a pixel, by table and interpolation. The same on every chip.
///
/// With U the power of two of texels that holds the triangle's span, a texel is off by at most `U (2^-14 + 2^-15)`, and
/// by what interpolating 1/w adds: below `U 2^-15` up to a ratio of w of 64 within 500 pixels of the triangle's first
/// vertex.
#[derive(Clone, Copy, Debug, Default)]
pub struct PerPixel;

impl Correction for Affine {
    type Varying = [Attribute; 2];
    type Triangle = ();
    const PERSPECTIVE: bool = false;

    fn words(self) -> [u32; 2] {
        [0; 2]
    }

    #[inline]
    fn from_words(_: [u32; 2]) -> Self {
        Self
    }

    #[inline]
    fn triangle(self, texels: [[Attribute; 2]; 3], _: [PerVertexInverse; 3]) -> ((), [[Attribute; 2]; 3]) {
        ((), texels)
    }

    #[inline(always)]
    fn walk<T>(
        self,
        (): &(),
        start: [Attribute; 2],
        step: &[Attribute; 2],
        pixels: impl Iterator<Item = T>,
        mut each: impl FnMut(T, i32, i32),
    ) {
        let mut texel = start;
        for pixel in pixels {
            let [u, v] = texel;
            each(pixel, u.to_bits() >> 16, v.to_bits() >> 16);
            texel = texel.plus(*step);
        }
    }
}

/// A triangle's corner of the texture: its least texel, and the power of two of texels that it spans.
#[derive(Clone, Copy, Debug)]
pub struct TexelBox {
    least: [i32; 2],
    /// 0 to 16.
    span_log2: u32,
}

impl Correction for PerPixel {
    /// 1/w, u/w and v/w, with u and v from 0 to 1 in the triangle's texel box.
    type Varying = [Inverse; 3];
    type Triangle = TexelBox;
    const PERSPECTIVE: bool = true;

    fn words(self) -> [u32; 2] {
        [0; 2]
    }

    #[inline]
    fn from_words(_: [u32; 2]) -> Self {
        Self
    }

    fn triangle(
        self,
        texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
    ) -> (TexelBox, [[Inverse; 3]; 3]) {
        let [a, b, c] = texels.map(|texel| texel.map(Attribute::to_bits));
        let ends = |[a, b, c]: [i32; 3]| (a.min(b).min(c) >> 16, a.max(b).max(c));
        let ((least_u, most_u), (least_v, most_v)) = (ends([a[0], b[0], c[0]]), ends([a[1], b[1], c[1]]));
        // From the whole texel at or below the least, in 16 fraction bits: it does not wrap.
        let above = |value: i32, least: i32| value.wrapping_sub(least << 16).cast_unsigned();
        let span = above(most_u, least_u).max(above(most_v, least_v));
        let span_log2 = (32 - span.saturating_sub(1).leading_zeros()).saturating_sub(16);
        let [qa, qb, qc] = PerVertexInverse::aligned(inverses);
        let vertex = |[u, v]: [i32; 2], q: i32| {
            let over_w = |value: i32, least: i32| {
                // A part of the box, at most 1, in 31 fraction bits, of q.
                let part = (u64::from(above(value, least)) << 15) >> span_log2;
                Inverse::from_bits(((part * u64::from(q.unsigned_abs())) >> 31) as i32)
            };
            [Inverse::from_bits(q), over_w(u, least_u), over_w(v, least_v)]
        };
        (TexelBox { least: [least_u, least_v], span_log2 }, [vertex(a, qa), vertex(b, qb), vertex(c, qc)])
    }

    #[inline(always)]
    fn walk<T>(
        self,
        triangle: &TexelBox,
        start: [Inverse; 3],
        step: &[Inverse; 3],
        pixels: impl Iterator<Item = T>,
        mut each: impl FnMut(T, i32, i32),
    ) {
        let [least_u, least_v] = triangle.least;
        let down = 31 - triangle.span_log2;
        let mut over_w = start;
        let mut inverse = recip::Pixel::new();
        for pixel in pixels {
            let [q, u, v] = over_w;
            let reciprocal = inverse.of(q.to_bits().max(1).unsigned_abs());
            let shift = inverse.shift;
            // u / q in 31 fraction bits, from 17 of u and the reciprocal's 16. Interpolation may run some steps below
            // 0, or above q, for which the top bit is left free: q has a leading zero, as it is signed.
            let part = |c: Inverse| {
                (c.to_bits().max(0).unsigned_abs() << (shift - 1) >> 15).wrapping_mul(reciprocal) >> down
            };
            each(pixel, least_u.wrapping_add(part(u) as i32), least_v.wrapping_add(part(v) as i32));
            over_w = over_w.plus(*step);
        }
    }
}

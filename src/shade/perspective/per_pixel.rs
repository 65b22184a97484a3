//! A reciprocal a pixel, and the loop that takes it.

use super::super::over_w::{OverW, TexelBox};
use super::super::sampler::Octave;
use super::{Correction, Sampler};
use crate::gradients::Plane;
use crate::math::format::Attribute;
use crate::math::recip;
use crate::raster::Shade;
use crate::texture::Texture;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// A reciprocal a pixel, by table and interpolation. The same on every chip.
///
/// With U the power of two of texels that holds the triangle's span, a texel is off by at most `U (2^-14 + 2^-16)`, and
/// by what interpolating 1/w adds: below `U 2^-15` up to a ratio of w of 64 within 500 pixels of the triangle's first
/// vertex.
#[derive(Clone, Copy, Debug, Default)]
pub struct PerPixel;

impl Correction for PerPixel {
    type Varying = OverW;
    type Triangle = TexelBox;
    const PERSPECTIVE: bool = true;
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
        reciprocals(triangle, start, step, run, recip::pixels(), sampler);
    }

    #[inline(always)]
    fn for_kernel<'a>(
        self,
        texture: Texture<'a>,
        triangle: &TexelBox,
        varying: Plane<OverW>,
    ) -> Option<Shade<'a>> {
        Some(Shade::Perspective(texture, triangle.in_octaves(varying)?))
    }
}

/// Divides by 1/w at each pixel: `reciprocal` is `2^16 / (1 + x 2^-32)`.
///
/// What a pixel shows depends on its own 1/w, u/w and v/w alone. Most triangles lie in one octave of 1/w.
#[inline(always)]
pub(super) fn reciprocals<T>(
    texel_box: &TexelBox,
    start: OverW,
    step: &OverW,
    run: &mut [T],
    reciprocal: impl Fn(u32) -> u32,
    sampler: &mut impl Sampler<T>,
) {
    if texel_box.octave {
        sampler.octave(run, &Octave { texel_box, start: &start, step }, &reciprocal);
    } else {
        octaves(texel_box, start, step, run, reciprocal, sampler);
    }
}

/// Divides at each pixel of a run of more than one octave. The shift that normalises 1/w is sought once for as many pixels
/// as share it: between two that do, all do, as 1/w is linear.
#[inline(never)]
fn octaves<T>(
    texel_box: &TexelBox,
    start: OverW,
    step: &OverW,
    mut run: &mut [T],
    reciprocal: impl Fn(u32) -> u32,
    sampler: &mut impl Sampler<T>,
) {
    let (mut at, mut shift) = (start, 1);
    loop {
        let mut pixels = run.len();
        while pixels > 1 && !alike(at, at.plus(step.times(pixels as i32 - 1))) {
            pixels /= 2;
        }
        let Some((now, later)) = run.split_at_mut_checked(pixels) else { return };
        // Alone, a pixel may lie outside of its range.
        let from = if pixels == 1 { at.clamped() } else { at };
        shift = recip::normalising(from.q.cast_unsigned(), shift);
        let octave = Octave { texel_box, start: &from.up(shift - 1), step: &step.up(shift - 1) };
        sampler.octave(now, &octave, &reciprocal);
        if later.is_empty() {
            return;
        }
        (run, at) = (later, at.plus(step.times(pixels as i32)));
    }
}

/// Whether two ends of a run are in range and have their 1/w in the same octave.
#[inline(always)]
fn alike(first: OverW, last: OverW) -> bool {
    let ([u, v], [last_u, last_v]) = (first.texel, last.texel);
    let in_range = (first.q | last.q | u | v | last_u | last_v) >= 0;
    in_range && first.q != 0 && first.q ^ last.q <= first.q & last.q
}

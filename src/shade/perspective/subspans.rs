//! Texels that are exact every few pixels, and linear between.

use super::super::over_w::{Exact, OverW, TexelBox};
use super::{Correction, Sampler};
use crate::math::format::Attribute;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// A reciprocal every few pixels, and linear steps between.
///
/// A run, which is the visible part of a span, is cut into subspans of this many pixels from its first pixel on. The last
/// ends on the run's last pixel: none reaches beyond the triangle. So the bytes are the same in strips of any height, by any
/// traversal and in any order of vertices; what hides a part of the span, and a strip narrower than the camera's target,
/// ends runs elsewhere and moves texels within the error below. Both ends of a subspan are as exact as
/// [`PerPixel`](super::PerPixel), the pixels between off by up to `d (sqrt(r) - 1) / (sqrt(r) + 1)` texels more, with d the
/// texels from end to end and r the ratio of w there: about `N^2 / 4 |u'| |q'| / q` for N pixels, u texels and q = 1/w. A
/// subspan that runs over 2^15 texels or more shows any.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Subspans {
    /// Of 4 pixels.
    Of4,
    /// Of 8 pixels.
    Of8,
    /// Of 16 pixels.
    #[default]
    Of16,
    /// Of 32 pixels.
    Of32,
}

impl Subspans {
    /// All lengths, from the shortest.
    pub const ALL: [Self; 4] = [Self::Of4, Self::Of8, Self::Of16, Self::Of32];

    /// Pixels from one exact texel to the next.
    pub const fn pixels(self) -> u32 {
        1 << self.log2()
    }

    const fn log2(self) -> u32 {
        match self {
            Self::Of4 => 2,
            Self::Of8 => 3,
            Self::Of16 => 4,
            Self::Of32 => 5,
        }
    }
}

impl Correction for Subspans {
    type Varying = OverW;
    type Triangle = TexelBox;
    const PERSPECTIVE: bool = true;

    fn words(self) -> [u32; 2] {
        [self.log2(), 0]
    }

    #[inline]
    fn from_words([log2, _]: [u32; 2]) -> Self {
        match log2 {
            2 => Self::Of4,
            3 => Self::Of8,
            4 => Self::Of16,
            _ => Self::Of32,
        }
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
        let steps = run.len().saturating_sub(1) as i32;
        let first = triangle.texel(&start, 1);
        let last = triangle.texel(&start.plus(step.times(steps)), first.shift);
        subspans(triangle, self.log2(), (start, step), [&first, &last], run, sampler);
    }
}

/// Shows a run by subspans of a power of two of pixels, from what is linear and the exact texels at both ends.
#[inline(always)]
pub(super) fn subspans<T>(
    texel_box: &TexelBox,
    log2: u32,
    (mut at, step): (OverW, &OverW),
    [first, last]: [&Exact; 2],
    mut run: &mut [T],
    sampler: &mut impl Sampler<T>,
) {
    let (mut from, mut shift) = (first.texel, first.shift);
    // All but the last, which has a step more: from an exact texel to another.
    while run.len() > (1 << log2) + 1 {
        let Some((now, later)) = run.split_at_mut_checked(1 << log2) else { return };
        at = at.plus(step.times(1 << log2));
        let to = texel_box.texel(&at, shift);
        sampler.subspan(now, from, differences(from, to.texel).map(|difference| difference >> log2));
        (run, from, shift) = (later, to.texel, to.shift);
    }
    let quotient = Quotient::by(run.len().saturating_sub(1));
    sampler.subspan(run, from, quotient.of_each(differences(from, last.texel)));
}

/// From one texel to another.
#[inline(always)]
pub(super) fn differences([u, v]: [i32; 2], [to_u, to_v]: [i32; 2]) -> [i32; 2] {
    [to_u.wrapping_sub(u), to_v.wrapping_sub(v)]
}

/// One over the steps of a subspan: 16 bits, rounded to nearest, and the shift that follows the product's 16.
#[derive(Clone, Copy)]
struct Quotient {
    reciprocal: u16,
    shift: u16,
}

/// Of 1 to 32 steps. One itself is 2^-16 too low; of none, nothing is stepped.
static QUOTIENTS: [Quotient; 33] = {
    let mut quotients = [Quotient { reciprocal: u16::MAX, shift: 0 }; 33];
    let mut steps = 2;
    while steps < quotients.len() {
        let log2 = (steps - 1).ilog2();
        quotients[steps] =
            Quotient { reciprocal: ((1 << (17 + log2)) / steps).div_ceil(2) as u16, shift: log2 as u16 };
        steps += 1;
    }
    quotients
};

impl Quotient {
    #[inline(always)]
    fn by(steps: usize) -> Self {
        QUOTIENTS.get(steps).copied().unwrap_or(Self { reciprocal: 0, shift: 0 })
    }

    /// Differences over the steps: each rounded down, and off by 2^-16 of itself.
    #[inline(always)]
    fn of_each(self, differences: [i32; 2]) -> [i32; 2] {
        let reciprocal = i32::from(self.reciprocal);
        differences.map(|difference| {
            let low = ((difference & 0xFFFF).cast_unsigned() * u32::from(self.reciprocal)) >> 16;
            ((difference >> 16) * reciprocal + low.cast_signed()) >> self.shift
        })
    }
}

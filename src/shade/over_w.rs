//! Texels over w: what is linear on the screen where w is not.

use crate::attributes::Words;
use crate::gradients::{Gradients, Plane};
use crate::math::format::Attribute;
use crate::math::{product, recip};
use crate::raster::TexelsOverW;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// 1/w, u/w and v/w in 31 fraction bits, with u and v from 0 to 1 in the triangle's [`TexelBox`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OverW {
    pub(super) q: i32,
    pub(super) texel: [i32; 2],
}

impl OverW {
    /// As it may be used: interpolation runs some steps below 0.
    #[inline(always)]
    pub(super) fn clamped(self) -> Self {
        let [u, v] = self.texel;
        Self { q: self.q.max(1), texel: [u.max(0), v.max(0)] }
    }

    /// All of it up by this many bits.
    #[inline(always)]
    pub(super) fn up(self, shift: u32) -> Self {
        Self { q: self.q << shift, texel: self.texel.map(|over_w| over_w << shift) }
    }
}

/// More than interpolation is ever off by: the 8191 columns and 4095 rows of the largest guard rectangle round by 6144
/// steps.
const MARGIN: i32 = 1 << 13;

/// The greatest 1/w of a vertex, lest interpolation should run over 2^31. It is off by 2^-18 of itself where w is a power of
/// two, and nowhere else.
const GREATEST: i32 = i32::MAX - MARGIN + 1;

/// The least 1/w of the upper octave that interpolation keeps in it, and of the one below.
const LEAST_OF_OCTAVE: i32 = (1 << 30) + MARGIN;
const LEAST_OF_TWO: i32 = (1 << 29) + MARGIN;

impl Words for OverW {
    const WORDS: usize = 3;

    #[inline]
    fn store(self, put: &mut impl FnMut(u32)) {
        let Self { q, texel: [u, v] } = self;
        put(q.cast_unsigned());
        put(u.cast_unsigned());
        put(v.cast_unsigned());
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        let mut next = || words.next().map(u32::cast_signed);
        Some(Self { q: next()?, texel: [next()?, next()?] })
    }
}

impl Varying for OverW {
    #[inline]
    fn plane(gradients: &Gradients, [a, b, c]: [Self; 3]) -> Plane<Self> {
        let scalar = |[a, b, c]: [i32; 3]| {
            let Plane { start, dx, dy } = gradients.plane(a, b, c);
            [start, dx, dy]
        };
        let ([au, av], [bu, bv], [cu, cv]) = (a.texel, b.texel, c.texel);
        let (q, u, v) = (scalar([a.q, b.q, c.q]), scalar([au, bu, cu]), scalar([av, bv, cv]));
        let ([q, dx_q, dy_q], [u, dx_u, dy_u], [v, dx_v, dy_v]) = (q, u, v);
        Plane {
            start: Self { q, texel: [u, v] },
            dx: Self { q: dx_q, texel: [dx_u, dx_v] },
            dy: Self { q: dy_q, texel: [dy_u, dy_v] },
        }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let ([u, v], [du, dv]) = (self.texel, other.texel);
        Self { q: self.q.wrapping_add(other.q), texel: [u.wrapping_add(du), v.wrapping_add(dv)] }
    }

    #[inline(always)]
    fn times(self, steps: i32) -> Self {
        let [u, v] = self.texel;
        Self { q: self.q.wrapping_mul(steps), texel: [u.wrapping_mul(steps), v.wrapping_mul(steps)] }
    }
}

/// Three vertices' 1/w in one power of two.
#[inline]
pub(super) fn aligned(inverses: [PerVertexInverse; 3]) -> [i32; 3] {
    PerVertexInverse::aligned(inverses).map(|q| q.min(GREATEST))
}

/// From the whole texel at or below the least, in 16 fraction bits: it does not wrap.
#[inline]
fn above(value: i32, least: i32) -> u32 {
    value.wrapping_sub(least << 16).cast_unsigned()
}

/// A triangle's corner of the texture: its least texel, and the power of two of texels that it spans.
#[derive(Clone, Copy, Debug)]
pub struct TexelBox {
    /// Whole texels.
    pub(super) least: [i32; 2],
    /// 0 to 16.
    pub(super) span_log2: u32,
    /// Whether at all pixels 1/w is in [2^30, 2^31), and u/w and v/w are in [0, 2^31).
    pub(super) octave: bool,
    /// Whether at all pixels 1/w is in [2^29, 2^31).
    pub(super) two_octaves: bool,
}

impl TexelBox {
    /// The box of three texels.
    #[inline]
    pub(super) fn new(texels: [[Attribute; 2]; 3]) -> Self {
        let [a, b, c] = texels.map(|texel| texel.map(Attribute::to_bits));
        let ends = |[a, b, c]: [i32; 3]| (a.min(b).min(c) >> 16, a.max(b).max(c));
        let ((least_u, most_u), (least_v, most_v)) = (ends([a[0], b[0], c[0]]), ends([a[1], b[1], c[1]]));
        let span = above(most_u, least_u).max(above(most_v, least_v));
        let most = span.saturating_sub(1);
        // Sought from those of 16 texels, where counting zeros is a call.
        let zeros = if product::NARROW { recip::normalising(most, 12) } else { most.leading_zeros() };
        let span_log2 = 16_u32.saturating_sub(zeros);
        Self { least: [least_u, least_v], span_log2, octave: false, two_octaves: false }
    }

    /// Where in the box three texels are: 0 to 1 in 31 fraction bits.
    #[inline]
    pub(super) fn parts(&self, texels: [[Attribute; 2]; 3]) -> [[u32; 2]; 3] {
        let Self { least: [least_u, least_v], span_log2, .. } = *self;
        let part = |value: Attribute, least: i32| {
            let above = above(value.to_bits(), least);
            if span_log2 > 15 { above >> 1 } else { above << (15 - span_log2) }
        };
        let parts = |[u, v]: [Attribute; 2]| [part(u, least_u), part(v, least_v)];
        let [a, b, c] = texels;
        [parts(a), parts(b), parts(c)]
    }

    /// The box, and three texels over w, by where in the box they are, and 1/w in 31 fraction bits.
    ///
    /// In one octave u/w and v/w are kept as far above 0 as interpolation may be off. That is 2^-17 of 1/w at most, and
    /// with what a reciprocal is too high by, 2^-14 and half a step of 2^-16, a texel is not further off than before: where
    /// the chord is 2^-14, 1/w is least, and half a step of its reciprocal 2^-17.
    #[inline]
    pub(super) fn over_w(self, [a, b, c]: [[u32; 2]; 3], [qa, qb, qc]: [i32; 3]) -> (Self, [OverW; 3]) {
        let least = qa.min(qb).min(qc);
        let (octave, two_octaves) = (least >= LEAST_OF_OCTAVE, least >= LEAST_OF_TWO);
        let least = if octave { MARGIN } else { 0 };
        let vertex = |[u, v]: [u32; 2], q: i32| {
            let over_w = |part: u32| ((product::unsigned(part, q.unsigned_abs()) >> 31) as i32).max(least);
            OverW { q, texel: [over_w(u), over_w(v)] }
        };
        (Self { octave, two_octaves, ..self }, [vertex(a, qa), vertex(b, qb), vertex(c, qc)])
    }

    /// Three vertices' 1/w in one power of two, the box, and all of it over w.
    pub(super) fn of(texels: [[Attribute; 2]; 3], inverses: [PerVertexInverse; 3]) -> (Self, [OverW; 3]) {
        let texel_box = Self::new(texels);
        texel_box.over_w(texel_box.parts(texels), aligned(inverses))
    }

    /// What a kernel divides, where the triangle is in one or two octaves.
    #[inline(always)]
    pub(super) fn in_octaves(&self, plane: Plane<OverW>) -> Option<TexelsOverW> {
        let Self { least, span_log2, octave, two_octaves } = *self;
        let words = |OverW { q, texel: [u, v] }| [q, u, v];
        let over_w = Plane { start: words(plane.start), dx: words(plane.dx), dy: words(plane.dy) };
        if two_octaves { Some(TexelsOverW { over_w, least, span_log2, one_octave: octave }) } else { None }
    }

    /// The texel at a pixel. The shift that normalises 1/w is sought from `shift`: 1 or more.
    #[inline(never)]
    pub(super) fn texel(&self, at: &OverW, shift: u32) -> Exact {
        let OverW { q, texel: [u, v] } = at.clamped();
        let q = q.cast_unsigned();
        let shift = recip::normalising(q, shift);
        let reciprocal = recip::pixel(q << shift << 1);
        let texel = |c: i32, least: i32| {
            let part = recip::quotient(c.cast_unsigned() << (shift - 1), reciprocal);
            let part = if self.span_log2 > 15 { part << 1 } else { part >> (15 - self.span_log2) };
            part.wrapping_add(least.cast_unsigned() << 16).cast_signed()
        };
        let [least_u, least_v] = self.least;
        Exact { texel: [texel(u, least_u), texel(v, least_v)], q, shift, reciprocal }
    }
}

/// A pixel's texel in 16 fraction bits, and what it was divided by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exact {
    pub(super) texel: [i32; 2],
    /// 1/w, 1 at least, and the shift that normalises it to 32 bits.
    pub(super) q: u32,
    pub(super) shift: u32,
    /// `2^47 / (q << shift)`.
    pub(super) reciprocal: u32,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::Setup;
    use crate::snapped::Snapped;

    // Red with no margin, of 1/w or of u/w and v/w.
    #[test]
    fn a_triangle_of_one_octave_keeps_to_it() {
        let mut state = 1_u64;
        let mut below = |end: i32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) as i32).rem_euclid(end)
        };
        let mut checked = 0;
        for _ in 0..10_000 {
            // An edge through centres of pixels where both texels are least and 1/w is, and a third vertex anywhere.
            let (dx, dy, steps) = (below(8) - 4, below(8) - 4, 1 + below(500));
            let at = |[x, y]: [i32; 2]| Snapped::from_bits(x * 256 + 128, y * 256 + 128);
            let corners = [[0, 0], [dx * steps, dy * steps], [below(4000) - 2000, below(4000) - 2000]];
            let Some((setup, order)) = Setup::new(corners.map(at)) else { continue };
            let span = Attribute::from_bits(1 + below(64 << 16));
            let texels = [[Attribute::ZERO; 2], [Attribute::ZERO; 2], [span, span]];
            let inverses =
                [LEAST_OF_OCTAVE, LEAST_OF_OCTAVE, LEAST_OF_OCTAVE + below(GREATEST - LEAST_OF_OCTAVE)];
            let texel_box = TexelBox::new(texels);
            let (texel_box, over_w) = texel_box.over_w(texel_box.parts(texels), inverses);
            assert!(texel_box.octave && texel_box.two_octaves);
            let plane = OverW::plane(&setup.gradients(), order.map(|vertex| over_w[vertex]));
            let [x, y] = setup.anchor();
            for step in 0..=steps {
                let OverW { q, texel: [u, v] } = plane.at(dx * step - x, dy * step - y);
                assert!(q >= 1 << 30 && u >= 0 && v >= 0, "{corners:?} {span} {inverses:?}: {q:#x} {u} {v}");
                checked += 1;
            }
        }
        assert!(checked > 1_000_000, "{checked}");
        let inverses = [LEAST_OF_OCTAVE - 1, GREATEST, GREATEST];
        let texels = [[Attribute::ZERO; 2]; 3];
        let texel_box = TexelBox::new(texels);
        let (two, _) = texel_box.over_w(texel_box.parts(texels), inverses);
        let inverses = [LEAST_OF_TWO - 1, GREATEST, GREATEST];
        let (more, _) = texel_box.over_w(texel_box.parts(texels), inverses);
        assert!(!two.octave && two.two_octaves && !more.octave && !more.two_octaves);
    }
}

//! The cheapest method that keeps an error.

use super::super::over_w::{Exact, OverW, TexelBox, aligned};
use super::per_pixel::reciprocals;
use super::subspans::{differences, subspans};
use super::{Affine, Correction, DrawTexels, PerPixel, Sampler};
use crate::gradients::Plane;
use crate::math::format::Attribute;
use crate::math::{product, recip};
use crate::raster::Shade;
use crate::texture::Texture;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// The cheapest of affine, subspans and a reciprocal a pixel that shows no texel further off than the caller allows.
///
/// Affine is chosen triangle by triangle, once a frame where that is soon seen, and such triangles are drawn by the code of
/// [`Affine`]; the length of subspans, and whether they do, run by run (a run is the visible part of a span).
///
/// A texel is off by at most this, up to a ratio of w of 64 and within 500 pixels of the triangle's first vertex; and by
/// what interpolating adds where a triangle is affine, `(n + m + 2) 2^-17` texels at n columns and m rows from there. What
/// [`PerPixel`](super::PerPixel) cannot keep is drawn as it draws: an error below `U 2^-13`, with U the power of two of
/// texels that holds the triangle's. Zero or less asks for that everywhere; as many texels as a triangle spans, for no
/// correction.
///
/// # Where a triangle may be affine
///
/// With q = 1/w and the weights l of its vertices, a pixel's texel is `sum(l q u) / sum(l q)`, and affine shows `sum(l u)`. The
/// difference is `sum over edges (l_i l_j A_ij) / sum(l q)`, with `A_ij = (q_i - q_j) (u_i - u_j)`. It is worst on an edge:
/// along an edge with A <= 0 the numerator, less any multiple of the denominator, is convex, so its greatest is on another
/// edge; and where no A is, q and u grow alike and all of both lies between two vertices, whose edge is worst. There it is
/// `A / (sqrt(q_i) + sqrt(q_j))^2`, at most A over the greater q and three times the lesser: over `3 q_min + q_mid`, of
/// the least and the middle one of the triangle's. So affine texels are too low by at most P, the greatest A over
/// that, and too high by at most N, the least. Moved by `(P - N) / 2` they are off by `(P + N) / 2`, half of it
/// where the edges agree. They are moved only where that keeps them off the next copy of the texture, and where it is needed.
///
/// # How long subspans may be
///
/// Along a run of n steps `u'' = -2 C q' / q^3`, and C is the same everywhere: `|C| = d q_1 q_2 / n` for d texels from end to
/// end. A subspan of N steps is off by at most `N^2 / 8 |u''|`, so by `(N / n)^2 d |q_1 - q_2| q_max / (4 q_min^2)`.
/// Runs of 32 pixels or less have a reciprocal a pixel: to start subspans costs as much.
///
/// ```
/// use topleft::{Attribute, Texture, Textured, Within};
///
/// let quarter = Textured::new(&Texture::WHITE, Within::default());
/// let half = Textured::new(&Texture::WHITE, Within::texels(Attribute::lit("0.5")));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Within {
    /// In 16 fraction bits.
    error: u32,
    /// Two thirds of what is left of it for triangles that are affine, rounded down to 9 bits or less, and in the last 5 bits the
    /// shift that rounds it, 2 or more.
    sure: u32,
}

impl Within {
    /// An error of at most so many texels: from 0 to 32 768, in steps of 2^-16. Less than 0 is 0.
    pub const fn texels(error: Attribute) -> Self {
        let bits = error.to_bits();
        Self::steps(if bits < 0 { 0 } else { bits.cast_unsigned() })
    }

    /// So many steps of 2^-16.
    const fn steps(error: u32) -> Self {
        let left = Self { error, sure: 0 }.left();
        let part = left / 3 * 2;
        let bits = 23_u32.saturating_sub(part.leading_zeros());
        let shift = if bits > 2 { bits } else { 2 };
        Self { error, sure: part >> shift << 5 | shift }
    }

    /// What is left of it for triangles that are affine: moving texels rounds to 2^-16, and by a reciprocal that is right to
    /// 2^-13. As much as 2^14 texels stand for all that is more.
    const fn left(self) -> u32 {
        let left = self.error.saturating_sub((self.error >> 12) + 2);
        if left < 1 << 30 { left } else { (1 << 30) - 1 }
    }
}

/// A quarter of a texel.
impl Default for Within {
    fn default() -> Self {
        Self::steps(1 << 14)
    }
}

/// What all pixels of a triangle share that may not be affine.
#[derive(Clone, Copy, Debug)]
pub struct Bent {
    texel_box: TexelBox,
    /// Texels that the middle of a subspan may be off by, in 16 fraction bits.
    between: u32,
}

impl Correction for Within {
    type Varying = OverW;
    type Triangle = Bent;
    const PERSPECTIVE: bool = true;
    const KERNELS: bool = true;
    const FINDS_AFFINE: bool = true;

    fn words(self) -> [u32; 2] {
        [self.error, self.sure]
    }

    #[inline]
    fn from_words([error, sure]: [u32; 2]) -> Self {
        Self { error, sure }
    }

    /// By `U d <= e (3 q_min + q_mid)`, with U the greatest difference of texels and d that of 1/w, which most small triangles
    /// meet by far: from few bits, so that products fit 32, and without a branch. Three numbers' differences sum up to twice
    /// the greatest; and with s the sum of 1/w, `q_min >= (s - 2 d) / 3`, so `3 q_min + q_mid >= (4 s - 5 d) / 3`.
    /// And where 1/w is one, whatever is allowed.
    #[inline(always)]
    fn is_affine(self, texels: [[Attribute; 2]; 3], inverses: [PerVertexInverse; 3]) -> bool {
        let twice = |a: i32, b: i32, c: i32| {
            let apart = |a: i32, b: i32| a.wrapping_sub(b).unsigned_abs();
            apart(a, b).wrapping_add(apart(b, c)).wrapping_add(apart(c, a)) + 2
        };
        // Rounded down by less than a step, each; and so is 1/w, in 15 fraction bits. Written out: compiled for size, arrays are
        // gone through in a loop.
        let shift = self.sure & 31;
        let part = |texel: Attribute| texel.to_bits() >> shift;
        let [[au, av], [bu, bv], [cu, cv]] = texels;
        let (u, v) = (twice(part(au), part(bu), part(cu)), twice(part(av), part(bv), part(cv)));
        let extent = u.max(v);
        let Some([qa, qb, qc]) = PerVertexInverse::of_one_power(inverses) else { return false };
        if (qa ^ qb) | (qa ^ qc) == 0 {
            return true;
        }
        let (qa, qb, qc) = (qa >> 16, qb >> 16, qc >> 16);
        let difference = twice(qa.cast_signed(), qb.cast_signed(), qc.cast_signed());
        let edge = (8 * (qa + qb + qc)).wrapping_sub(5 * difference);
        (extent >> 18) | (difference >> 14) == 0 && extent * difference <= (self.sure >> 5) * edge
    }

    #[inline]
    fn triangle(
        self,
        texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        _: [u8; 2],
    ) -> (Bent, [OverW; 3]) {
        let texel_box = TexelBox::new(texels);
        self.bent(texel_box, texel_box.parts(texels), aligned(inverses))
    }

    #[inline]
    fn choose<D: DrawTexels>(
        self,
        mut texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        sizes_log2: [u8; 2],
        onto: D,
    ) -> D::Output {
        let Some((triangle, varyings)) = self.unless_affine(&mut texels, inverses, sizes_log2) else {
            return onto.draw(Affine, (), texels);
        };
        let Bent { texel_box, between } = triangle;
        // What subspans cannot keep, runs need not be asked.
        if between == 0 {
            onto.draw(PerPixel, texel_box, varyings)
        } else {
            onto.draw(self, triangle, varyings)
        }
    }

    #[inline(always)]
    fn walk<T>(
        self,
        triangle: &Bent,
        start: OverW,
        step: &OverW,
        run: &mut [T],
        sampler: &mut impl Sampler<T>,
    ) {
        let Bent { texel_box, between } = triangle;
        let long = run.len() >= WORTH_SUBSPANS;
        if !(long && by_subspans(texel_box, *between, &start, step, run, sampler)) {
            reciprocals(texel_box, start, step, run, recip::pixels(), sampler);
        }
    }

    /// Kernels draw small triangles only, and none of these has a run that subspans are worth.
    #[inline(always)]
    fn for_kernel<'a>(
        self,
        texture: Texture<'a>,
        triangle: &Bent,
        varying: Plane<OverW>,
    ) -> Option<Shade<'a>> {
        let texels = triangle.texel_box.in_octaves(varying)?;
        Some(Shade::Perspective(texture, texels))
    }
}

/// Pixels of a run from which on subspans are worth to be chosen and started: some 600 cycles on a Cortex-M0+, and 34 a pixel. One
/// more than small triangles have, whose pixels a chip's own kernel divides in little more than that.
const WORTH_SUBSPANS: usize = 33;

/// A run of [`WORTH_SUBSPANS`] pixels or more, whose middle may be off by `between`: whether it could be shown by subspans.
#[inline(never)]
fn by_subspans<T>(
    texel_box: &TexelBox,
    between: u32,
    start: &OverW,
    step: &OverW,
    run: &mut [T],
    sampler: &mut impl Sampler<T>,
) -> bool {
    let steps = run.len().saturating_sub(1);
    let first = texel_box.texel(start, 1);
    let last = texel_box.texel(&start.plus(step.times(steps as i32)), first.shift);
    let Some(log2) = length(texel_box, between, steps as u32, &first, &last) else { return false };
    subspans(texel_box, log2, (*start, step), [&first, &last], run, sampler);
    true
}

impl Within {
    /// What a triangle is drawn by that may not be affine. Nothing where it may: its texels are moved as far as that takes.
    #[inline(never)]
    fn unless_affine(
        self,
        texels: &mut [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        sizes_log2: [u8; 2],
    ) -> Option<(Bent, [OverW; 3])> {
        let (texel_box, q) = (TexelBox::new(*texels), aligned(inverses));
        let bend = self.bend(&texel_box, q)?;
        let parts = bend.not_affine(&texel_box, texels, q, sizes_log2)?;
        Some(self.bent(texel_box, parts, q))
    }

    #[inline]
    fn bent(self, texel_box: TexelBox, parts: [[u32; 2]; 3], q: [i32; 3]) -> (Bent, [OverW; 3]) {
        let (texel_box, over_w) = texel_box.over_w(parts, q);
        (Bent { texel_box, between: self.between(&texel_box) }, over_w)
    }

    /// How much perspective may bend the texels of a triangle. Nothing where it does not, or whatever it does is allowed.
    #[inline(always)]
    fn bend(self, texel_box: &TexelBox, q: [i32; 3]) -> Option<Bend> {
        let span_log2 = texel_box.span_log2;
        if self.error >> span_log2 >= 1 << 16 || (q[0] == q[1] && q[1] == q[2]) {
            return None;
        }
        // All in 15 fraction bits: 1/w, and parts of the box.
        let [qa, qb, qc] = q.map(|q| q >> 16);
        let (least, most) = (qa.min(qb).min(qc), qa.max(qb).max(qc));
        // Three times the least and the middle one: what is least of an edge's greater and three times its lesser.
        let edge = (2 * least + qa + qb + qc - most).cast_unsigned();
        // 8 e / U, of 1/w.
        let eighth = self.left() << 2 >> (span_log2 & 31);
        Some(Bend { allowed: (eighth.min((1 << 15) - 1) * edge) >> 2, edge, span_log2 })
    }

    /// What is left for the middle of subspans: an error of the ends of U 2^-13, which includes interpolating; 2^-16 of U
    /// for the step, which is rounded down as well: by 2^-16 for each of 32 pixels.
    #[inline]
    fn between(self, texel_box: &TexelBox) -> u32 {
        let span_log2 = texel_box.span_log2;
        if span_log2 > 15 { 0 } else { self.error.saturating_sub((9 << span_log2) + 32) }
    }
}

/// How much perspective may bend the texels of an affine triangle.
struct Bend {
    /// Twice the error in parts of the box, times `edge`: in 30 fraction bits.
    allowed: u32,
    /// Of no edge is `(sqrt(q_i) + sqrt(q_j))^2` less: in 15 fraction bits.
    edge: u32,
    span_log2: u32,
}

/// What differences of numbers of 15 fraction bits that were rounded down make of a product of two: twice, rounded up.
const ROUNDING: u32 = 3 << 16;

impl Bend {
    /// Where in the box the texels of a triangle are that may not be affine. Nothing where it may: its texels are moved as
    /// far as that takes.
    #[inline(never)]
    fn not_affine(
        &self,
        texel_box: &TexelBox,
        texels: &mut [[Attribute; 2]; 3],
        q: [i32; 3],
        sizes_log2: [u8; 2],
    ) -> Option<[[u32; 2]; 3]> {
        let [qa, qb, qc] = q.map(|q| q >> 16);
        let parts = texel_box.parts(*texels);
        let [a, b, c] = parts.map(|part| part.map(|part| (part >> 16).cast_signed()));
        let ([au, av], [bu, bv], [cu, cv]) = (a, b, c);
        let edges = |a: i32, b: i32, c: i32| [(qa - qb) * (a - b), (qb - qc) * (b - c), (qc - qa) * (c - a)];
        let (u, v) = (edges(au, bu, cu), edges(av, bv, cv));
        // Most others.
        if self.bears_all([u, v]) {
            return None;
        }
        let ends = |[d, e, f]: [i32; 3]| [d.max(e).max(f).max(0), d.min(e).min(f).min(0)];
        let [a, b, c] = texels.map(|texel| texel.map(Attribute::to_bits));
        let [width, height] = sizes_log2;
        let Some(u) = self.moved([a[0], b[0], c[0]], ends(u), width) else { return Some(parts) };
        let Some(v) = self.moved([a[1], b[1], c[1]], ends(v), height) else { return Some(parts) };
        let ([au, bu, cu], [av, bv, cv]) = (u, v);
        *texels = [[au, av], [bu, bv], [cu, cv]].map(|texel| texel.map(Attribute::from_bits));
        None
    }

    /// Whether texels may stay where they are, if no edge is bent by more.
    #[inline(always)]
    fn bears(&self, edge: u32) -> bool {
        2 * edge + ROUNDING <= self.allowed
    }

    /// The same of all edges on both axes: by sign bits, as each is less than 2^30 either way.
    #[inline(always)]
    fn bears_all(&self, axes: [[i32; 3]; 2]) -> bool {
        let most = (self.allowed.cast_signed() - ROUNDING.cast_signed()) >> 1;
        let beyond = |edge: i32| (most - edge) | (most + edge);
        let any = |[d, e, f]: [i32; 3]| beyond(d) | beyond(e) | beyond(f);
        let [u, v] = axes;
        any(u) | any(v) >= 0
    }

    /// The texels of three vertices on an axis, moved as far as it needs, if that is enough; `most` and `least` are the ends
    /// of what perspective makes of its edges.
    #[inline(always)]
    fn moved(&self, texels: [i32; 3], [most, least]: [i32; 2], size_log2: u8) -> Option<[i32; 3]> {
        let (above, below) = (most.unsigned_abs(), least.unsigned_abs());
        if self.bears(above.max(below)) {
            return Some(texels);
        }
        if above + below + ROUNDING > self.allowed {
            return None;
        }
        let sum = most + least;
        // In 16 fraction bits: (most + least) 2^span / edge, which is not 0, as there is something allowed.
        let shift = recip::normalising(self.edge, 16);
        let reciprocal = recip::pixel(self.edge.max(1) << shift << 1);
        let size =
            (product::unsigned(sum.unsigned_abs(), reciprocal) >> (47 - self.span_log2 - shift)) as i32;
        let by = if sum < 0 { -size } else { size };
        let [a, b, c] = texels;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c).wrapping_sub(1));
        let copy = |texel: i32| texel >> size_log2 >> 16;
        let stays = copy(low.wrapping_add(by)) == copy(low) && copy(high.wrapping_add(by)) == copy(high);
        if stays { Some(texels.map(|texel| texel.wrapping_add(by))) } else { None }
    }
}

/// The power of two of pixels of the subspans of a run of `steps`, whose middle may be off by `between`; nothing where they
/// would be shorter than 8: four pixels one by one cost less than a subspan of them.
#[inline(never)]
fn length(texel_box: &TexelBox, between: u32, steps: u32, first: &Exact, last: &Exact) -> Option<u32> {
    let error = quadruple_error(texel_box, first, last)?;
    let allowed = between.min((1 << 18) - 1) >> 2;
    if error <= allowed {
        return Some(5);
    }
    let square = steps.min(1 << 15) * steps.min(1 << 15);
    let suits = |log2: u32| error <= allowed * (square >> (2 * log2)).min((1 << 16) - 1);
    if !suits(3) {
        None
    } else if suits(5) {
        Some(5)
    } else {
        Some(if suits(4) { 4 } else { 3 })
    }
}

/// Four times the error of a whole run that is linear from one end to the other: in 12 fraction bits, rounded up. Nothing
/// for 2^10 texels and more, or a ratio of w of about 16 and more.
#[inline(always)]
fn quadruple_error(texel_box: &TexelBox, first: &Exact, last: &Exact) -> Option<u32> {
    let [u, v] = differences(first.texel, last.texel).map(i32::unsigned_abs);
    // Each end is off by U 2^-13. Rounded up to 6 fraction bits.
    let texels = (u.max(v) >> 10) + (1 << texel_box.span_log2 >> 6) + 2;
    let (lesser, greater) = if last.q < first.q { (last, first) } else { (first, last) };
    let (difference, octaves) = (greater.q - lesser.q, lesser.shift - greater.shift);
    if texels >> 16 != 0 || octaves > 3 {
        return None;
    }
    if difference < lesser.q {
        // The ratio of w less 1, at most 1: the reciprocal is at most 2^-16 too low. In 16 fraction bits, rounded up.
        let over = (((difference << (lesser.shift - 1) >> 15) * lesser.reciprocal) >> 15) + 3;
        let bend = over + (((over >> 1) * (over >> 1)) >> 14) + 4;
        Some(((texels * ((bend >> 2) + 1)) >> 8) + 1)
    } else {
        // At most 15, and in 8 fraction bits: of 14 bits and more, what is rounded down and the reciprocal make it less than
        // 2^-12 of itself too low.
        let over = ((difference << greater.shift >> 16) * lesser.reciprocal) >> (15 - octaves);
        let over = ((over + (over >> 12)) >> 8) + 1;
        let bend = over + ((over * over) >> 8) + 1;
        Some(((texels * bend) >> 2) + 1)
    }
}

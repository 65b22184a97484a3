//! Shows texels in pixels: from a texture that repeats or ends, as they are or under light.

use super::over_w::{OverW, TexelBox};
use crate::math::format::Attribute;
use crate::math::recip;
use crate::pixel::Pixel;
use crate::texture::{Texture, Wrap};
use crate::varying::Varying;

/// Shows the texels of columns and rows in pixels: what a [`Correction`](super::Correction) hands runs to.
pub trait Sampler<T> {
    /// Shows a texel, before wrapping or clamping. A run's pixels come from the first to the last.
    fn show(&mut self, pixel: &mut T, column: i32, row: i32);

    /// Shows texels that step from pixel to pixel, with 16 fraction bits.
    #[doc(hidden)]
    #[inline(always)]
    fn steps(&mut self, run: &mut [T], start: [i32; 2], step: [i32; 2]) {
        steps(run, start, step, |pixel, column, row| self.show(pixel, column, row));
    }

    /// The same as a function of its own, for short runs.
    #[doc(hidden)]
    #[inline(never)]
    fn subspan(&mut self, run: &mut [T], start: [i32; 2], step: [i32; 2]) {
        self.steps(run, start, step);
    }

    /// Shows texels over w, divided by `reciprocal` of 1/w.
    #[doc(hidden)]
    #[inline(never)]
    fn octave(&mut self, run: &mut [T], octave: &Octave<'_>, reciprocal: &impl Fn(u32) -> u32) {
        let [least_u, least_v] = octave.texel_box.least;
        octave.divided(run, reciprocal, |pixel, u, v| {
            self.show(pixel, least_u.wrapping_add(u), least_v.wrapping_add(v));
        });
    }
}

impl<T, F: FnMut(&mut T, i32, i32)> Sampler<T> for F {
    #[inline(always)]
    fn show(&mut self, pixel: &mut T, column: i32, row: i32) {
        self(pixel, column, row);
    }
}

/// Pixels whose 1/w is in [2^30, 2^31), and whose u/w and v/w are in [0, 2^31).
#[derive(Clone, Copy, Debug)]
pub struct Octave<'o> {
    pub(super) texel_box: &'o TexelBox,
    pub(super) start: &'o OverW,
    pub(super) step: &'o OverW,
}

impl Octave<'_> {
    /// Divides from pixel to pixel: columns and rows from the box's least on.
    #[inline(always)]
    fn divided<T>(
        &self,
        run: &mut [T],
        reciprocal: impl Fn(u32) -> u32,
        mut show: impl FnMut(&mut T, i32, i32),
    ) {
        let (OverW { q, texel: [u, v] }, OverW { q: dq, texel: [du, dv] }) = (*self.start, *self.step);
        // What follows the leading one.
        let (mut q, dq) = (q.cast_unsigned() << 2, dq.cast_unsigned() << 2);
        let (mut u, mut v, du, dv) =
            (u.cast_unsigned(), v.cast_unsigned(), du.cast_unsigned(), dv.cast_unsigned());
        let down = 31 - self.texel_box.span_log2;
        for pixel in run {
            // As below.
            core::hint::black_box(());
            let reciprocal = reciprocal(q);
            let part = |c: u32| (recip::quotient(c, reciprocal) >> (down & 31)).cast_signed();
            show(pixel, part(u), part(v));
            q = q.wrapping_add(dq);
            u = u.wrapping_add(du);
            v = v.wrapping_add(dv);
        }
    }
}

/// Steps from pixel to pixel.
#[inline(always)]
fn steps<T>(
    run: &mut [T],
    [mut u, mut v]: [i32; 2],
    [du, dv]: [i32; 2],
    mut show: impl FnMut(&mut T, i32, i32),
) {
    for pixel in run {
        // Keeps the loop as it is: unrolled, it needs twice the registers of a small core, and is slower.
        core::hint::black_box(());
        show(pixel, u >> 16, v >> 16);
        u = u.wrapping_add(du);
        v = v.wrapping_add(dv);
    }
}

/// What becomes of a texel.
pub(super) trait Paint<P> {
    fn paint(&mut self, pixel: &mut P, texel: u16);
}

/// As it is.
pub(super) struct Plain;

impl<P: Pixel> Paint<P> for Plain {
    #[inline(always)]
    fn paint(&mut self, pixel: &mut P, texel: u16) {
        *pixel = P::from_texel(texel);
    }
}

/// Under light in 64 steps, with a half for rounding, and what it changes from pixel to pixel.
pub(super) struct Lit(pub(super) Attribute, pub(super) Attribute);

impl<P: Pixel> Paint<P> for Lit {
    #[inline(always)]
    fn paint(&mut self, pixel: &mut P, texel: u16) {
        let Self(light, step) = *self;
        // Interpolation may leave the range by less than the half that rounds.
        let steps = (light.to_bits() >> 16).unsigned_abs().min(64);
        *pixel = P::lit_texel(texel, steps);
        self.0 = light.plus(step);
    }
}

/// A texture, with what becomes of its texels. What lies beyond its edges is decided once a run.
pub(super) struct Painted<'t, D> {
    pub(super) texture: &'t Texture<'t>,
    pub(super) paint: D,
}

impl<P, D: Paint<P>> Sampler<P> for Painted<'_, D> {
    #[inline(always)]
    fn show(&mut self, pixel: &mut P, column: i32, row: i32) {
        self.paint.paint(pixel, self.texture.texel(column, row));
    }

    #[inline(always)]
    fn steps(&mut self, run: &mut [P], start: [i32; 2], step: [i32; 2]) {
        let Self { texture, paint } = self;
        match texture.wrap() {
            Wrap::Repeat => {
                let Some(repeated) = Repeated::new(texture, [0; 2]) else { return };
                steps(run, start, step, |pixel, u, v| paint.paint(pixel, repeated.texel(u, v & 0xFFFF)));
            }
            Wrap::Clamp => steps(run, start, step, |pixel, u, v| paint.paint(pixel, texture.clamped(u, v))),
        }
    }

    #[inline(never)]
    fn octave(&mut self, run: &mut [P], octave: &Octave<'_>, reciprocal: &impl Fn(u32) -> u32) {
        let Self { texture, paint } = self;
        match texture.wrap() {
            Wrap::Repeat => {
                let Some(repeated) = Repeated::new(texture, octave.texel_box.least) else { return };
                octave.divided(run, reciprocal, |pixel, u, v| paint.paint(pixel, repeated.texel(u, v)));
            }
            Wrap::Clamp => {
                let [least_u, least_v] = octave.texel_box.least;
                octave.divided(run, reciprocal, |pixel, u, v| {
                    paint.paint(pixel, texture.clamped(least_u.wrapping_add(u), least_v.wrapping_add(v)));
                });
            }
        }
    }
}

/// A texture that repeats.
struct Repeated<'t> {
    texels: &'t [u16],
    /// 32 less the power of two that the width is: 0 for one column, which is 0 then.
    above: u32,
    /// Where columns and rows begin, as `texel` puts them together.
    corner: i32,
}

impl<'t> Repeated<'t> {
    /// Of a texture, which has at least one texel: said here, it need not be asked for each. Columns and rows count from
    /// the texel in these.
    #[inline(always)]
    fn new(texture: &Texture<'t>, [column, row]: [i32; 2]) -> Option<Self> {
        let ([width_log2, _], texels) = (texture.sizes_log2(), texture.texels());
        let above = u32::from(width_log2).wrapping_neg() & 31;
        // Heights divide 2^16.
        let corner = (column << above).wrapping_add(row & 0xFFFF);
        if texels.is_empty() { None } else { Some(Self { texels, above, corner }) }
    }

    /// The texel in a column and a row, the row from 0 to 2^16: what is left of the column stands above the rows, 22 bits
    /// or more, and is turned below them. So both are moved by one addition.
    #[inline(always)]
    fn texel(&self, column: i32, row: i32) -> u16 {
        let both = (column << self.above | row).wrapping_add(self.corner);
        let index = both.cast_unsigned().rotate_right(self.above);
        // The mask is one less than the length, a power of two: no test of the index is left.
        let index = index as usize & self.texels.len().wrapping_sub(1);
        self.texels.get(index).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a column reaches a row, the other way round, or the corner is left out.
    #[test]
    fn a_repeated_texel_is_the_textures_own() {
        let texels: [u16; 1 << 14] = core::array::from_fn(|i| i as u16);
        for (width_log2, height_log2) in [(0, 0), (0, 10), (10, 0), (1, 3), (4, 10), (10, 4)] {
            let texture =
                Texture::new(1 << width_log2, 1 << height_log2, &texels[..1 << (width_log2 + height_log2)]);
            let texture = texture.unwrap();
            // Of one column, it is 0.
            let columns =
                if width_log2 == 0 { &[0][..] } else { &[-32_768, -1_025, -1, 0, 1, 1_023, 1_024, 32_767] };
            for &column in columns {
                for row in [0, 1, 2, 1_023, 1_024, 32_767, 65_535, 65_536] {
                    let repeated = Repeated::new(&texture, [0; 2]).unwrap();
                    assert_eq!(repeated.texel(column, row), texture.repeated(column, row), "{column} {row}");
                    for corner in [-32_768, -1, 1, 1_023, 32_767] {
                        let repeated =
                            Repeated::new(&texture, [if width_log2 == 0 { 0 } else { corner }, corner]);
                        let expected = texture.repeated(column + corner, row + corner);
                        assert_eq!(
                            repeated.unwrap().texel(column, row),
                            expected,
                            "{corner}: {column} {row}"
                        );
                    }
                }
            }
        }
    }
}

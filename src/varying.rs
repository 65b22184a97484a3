//! What changes over a triangle, from set-up to shading.
//!
//! [`Varying`] is what set-up makes of three vertices: plane equations, stepped over the screen by wrapping additions.
//! It is implemented for `()`, scalars, arrays and pairs, so that flat, Gouraud and textured triangles are one loop.

use crate::attributes::Words;
use crate::gradients::{Gradients, Plane};
use crate::math::format::{Attribute, DepthCode, Inverse};

/// A value that is linear on the screen, as the difference from pixel to pixel or as the value at one.
///
/// All arithmetic wraps: sums of rounded gradients are right modulo 2^32, and at a pixel of the triangle the true value
/// fits, so it is right there, however steep the plane is.
///
/// It can be stored as [`Words`], so that a list need not find a plane again in the next strip.
pub trait Varying: Words {
    /// Whether it is nothing at all: its plane needs no gradients then.
    const NOTHING: bool = false;

    /// The plane through three values, one a vertex.
    fn plane(gradients: &Gradients, at_vertices: [Self; 3]) -> Plane<Self>;

    /// The sum, wrapping.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// `steps` times this, wrapping.
    #[must_use]
    fn times(self, steps: i32) -> Self;
}

impl<V: Varying> Words for Plane<V> {
    const WORDS: usize = 3 * V::WORDS;

    #[inline]
    fn store(self, put: &mut impl FnMut(u32)) {
        let Self { start, dx, dy } = self;
        [start, dx, dy].store(put);
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        let [start, dx, dy] = Words::load(words)?;
        Some(Self { start, dx, dy })
    }
}

impl<V: Varying> Plane<V> {
    /// The value `columns` to the right of the anchor and `rows` below it.
    #[inline]
    pub fn at(&self, columns: i32, rows: i32) -> V {
        self.start.plus(self.dx.times(columns)).plus(self.dy.times(rows))
    }

    /// The same plane, with another row of the anchor's column for a start.
    #[inline(always)]
    pub(crate) fn starting_in_row(self, rows: i32) -> Self {
        let Self { start, dx, dy } = self;
        Self { start: start.plus(dy.times(rows)), dx, dy }
    }
}

impl Varying for () {
    const NOTHING: bool = true;

    #[inline]
    fn plane(_: &Gradients, _: [Self; 3]) -> Plane<Self> {
        Plane { start: (), dx: (), dy: () }
    }

    #[inline]
    fn plus(self, (): Self) -> Self {}

    #[inline]
    fn times(self, _: i32) -> Self {}
}

/// Scalars of 32 bits, signed or not, differ only in what their least is: planes are of signed ones.
macro_rules! scalar {
    ($($format:ty: $least:expr),*) => {$(
        impl Varying for $format {
            #[inline]
            fn plane(gradients: &Gradients, [a, b, c]: [Self; 3]) -> Plane<Self> {
                // As far above the least of an `i32` as above its own.
                let signed = |value: Self| value.to_bits() as i32 ^ $least;
                let Plane { start, dx, dy } = gradients.plane(signed(a), signed(b), signed(c));
                let [start, dx, dy] = [start ^ $least, dx, dy].map(|value| Self::from_bits(value as _));
                Plane { start, dx, dy }
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                Self::from_bits(self.to_bits().wrapping_add(other.to_bits()))
            }

            #[inline(always)]
            fn times(self, steps: i32) -> Self {
                Self::from_bits(self.to_bits().wrapping_mul(steps as _))
            }
        }
    )*};
}

scalar!(Attribute: 0, DepthCode: i32::MIN, Inverse: 0);

macro_rules! array {
    ($($n:literal: $($p:ident $q:ident $r:ident),*;)*) => {$(
        // Written out: a loop over three elements stays a loop where code is compiled for size.
        impl<V: Varying> Varying for [V; $n] {
            #[inline]
            fn plane(gradients: &Gradients, [a, b, c]: [Self; 3]) -> Plane<Self> {
                let ([$($p),*], [$($q),*], [$($r),*]) = (a, b, c);
                $(let $p = V::plane(gradients, [$p, $q, $r]);)*
                Plane { start: [$($p.start),*], dx: [$($p.dx),*], dy: [$($p.dy),*] }
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                let ([$($p),*], [$($q),*]) = (self, other);
                [$($p.plus($q)),*]
            }

            #[inline(always)]
            fn times(self, steps: i32) -> Self {
                let [$($p),*] = self;
                [$($p.times(steps)),*]
            }
        }
    )*};
}

array! {
    2: a d g, b e h;
    3: a d g, b e h, c f i;
}

impl<V: Varying, W: Varying> Varying for (V, W) {
    const NOTHING: bool = V::NOTHING && W::NOTHING;

    #[inline]
    fn plane(gradients: &Gradients, at_vertices: [Self; 3]) -> Plane<Self> {
        let first = V::plane(gradients, at_vertices.map(|pair| pair.0));
        let second = W::plane(gradients, at_vertices.map(|pair| pair.1));
        Plane { start: (first.start, second.start), dx: (first.dx, second.dx), dy: (first.dy, second.dy) }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        (self.0.plus(other.0), self.1.plus(other.1))
    }

    #[inline(always)]
    fn times(self, steps: i32) -> Self {
        (self.0.times(steps), self.1.times(steps))
    }
}

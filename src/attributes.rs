//! What vertices carry, from the mesh to set-up.
//!
//! [`Attributes`] are a few [`Words`] of a list, mixed where an edge is clipped.

use crate::math::format::{Attribute, DepthCode, Inverse};
use crate::math::product;

/// How far a clipped vertex lies from the inner end of its edge: 0 to 1 in 30 fraction bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction(pub(crate) i32);

impl Fraction {
    /// `from` at 0 and `to` at 1, rounded to nearest.
    #[inline(never)]
    pub fn mix(self, from: i32, to: i32) -> i32 {
        let product = product::signed(to, self.0) - product::signed(from, self.0);
        from.wrapping_add(((product + (1 << 29)) >> 30) as i32)
    }
}

/// What a list stores as a fixed number of words.
pub trait Words: Copy {
    /// How many words.
    const WORDS: usize;

    /// Hands each word to `put`.
    fn store(self, put: &mut impl FnMut(u32));

    /// Takes as many words as `store` gave; nothing if they run out.
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self>;
}

/// What a vertex of a list carries for its shader.
pub trait Attributes: Words {
    /// The attributes at `at` of the way from `self` to `to`.
    #[must_use]
    fn mix(self, to: Self, at: Fraction) -> Self;
}

/// What a vertex carries for its shader, in words whatever it is: so that clipping is linked once, not for each shader.
pub(crate) type Carried = [u32; MAX_WORDS];

/// Words that a shader's vertex can carry.
const MAX_WORDS: usize = 4;

/// In words. More than four do not compile.
#[inline]
pub(crate) fn carried<A: Words>(attributes: A) -> Carried {
    const { assert!(A::WORDS <= MAX_WORDS, "a vertex carries at most four words for its shader") };
    let mut carried = [0; MAX_WORDS];
    let mut words = carried.iter_mut();
    attributes.store(&mut |word| {
        if let Some(place) = words.next() {
            *place = word;
        }
    });
    carried
}

/// What a vertex between two others carries.
#[inline]
pub(crate) fn mixed<A: Attributes>(from: &Carried, to: &Carried, at: Fraction) -> Carried {
    let load = |words: &Carried| A::load(&mut words.iter().copied());
    match (load(from), load(to)) {
        (Some(from), Some(to)) => carried(from.mix(to, at)),
        _ => *from,
    }
}

impl Words for () {
    const WORDS: usize = 0;

    fn store(self, _: &mut impl FnMut(u32)) {}

    fn load(_: &mut impl Iterator<Item = u32>) -> Option<Self> {
        Some(())
    }
}

impl Attributes for () {
    fn mix(self, (): Self, _: Fraction) -> Self {}
}

/// Scalars of 32 bits, signed or not.
macro_rules! scalar {
    ($($format:ty),*) => {$(
        impl Words for $format {
            const WORDS: usize = 1;

            #[inline]
            fn store(self, put: &mut impl FnMut(u32)) {
                put(self.to_bits() as u32);
            }

            #[inline]
            fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
                words.next().map(|word| Self::from_bits(word as _))
            }
        }
    )*};
}

scalar!(Attribute, DepthCode, Inverse);

impl Attributes for Attribute {
    fn mix(self, to: Self, at: Fraction) -> Self {
        Self::from_bits(at.mix(self.to_bits(), to.to_bits()))
    }
}

/// Red, green and blue, 8 bits each, in one word.
impl Words for [u8; 3] {
    const WORDS: usize = 1;

    fn store(self, put: &mut impl FnMut(u32)) {
        let [r, g, b] = self;
        put(u32::from_le_bytes([r, g, b, 0]));
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        words.next().map(|word| {
            let [r, g, b, _] = word.to_le_bytes();
            [r, g, b]
        })
    }
}

impl Attributes for [u8; 3] {
    fn mix(self, [r, g, b]: Self, at: Fraction) -> Self {
        let [from_r, from_g, from_b] = self;
        [(from_r, r), (from_g, g), (from_b, b)].map(|(from, to)| at.mix(i32::from(from), i32::from(to)) as u8)
    }
}

macro_rules! array {
    ($($n:literal: $($word:ident),*;)*) => {$(
        // Written out: a loop over three elements stays a loop where code is compiled for size.
        impl<A: Words> Words for [A; $n] {
            const WORDS: usize = $n * A::WORDS;

            #[inline]
            fn store(self, put: &mut impl FnMut(u32)) {
                let [$($word),*] = self;
                $($word.store(put);)*
            }

            #[inline]
            fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
                $(let $word = A::load(words)?;)*
                Some([$($word),*])
            }
        }
    )*};
}

array! {
    2: a, b;
    3: a, b, c;
}

impl<A: Attributes> Attributes for [A; 2] {
    fn mix(self, [u, v]: Self, at: Fraction) -> Self {
        let [from_u, from_v] = self;
        [from_u.mix(u, at), from_v.mix(v, at)]
    }
}

impl<A: Words, B: Words> Words for (A, B) {
    const WORDS: usize = A::WORDS + B::WORDS;

    #[inline]
    fn store(self, put: &mut impl FnMut(u32)) {
        self.0.store(put);
        self.1.store(put);
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        Some((A::load(words)?, B::load(words)?))
    }
}

impl<A: Attributes, B: Attributes> Attributes for (A, B) {
    fn mix(self, to: Self, at: Fraction) -> Self {
        (self.0.mix(to.0, at), self.1.mix(to.1, at))
    }
}

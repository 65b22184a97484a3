//! A colour between three others: what is interpolated.

use crate::attributes::Words;
use crate::gradients::{Gradients, Plane};
use crate::math::format::Attribute;
use crate::varying::Varying;

/// Red, green and blue in steps of the pixel's channels, 0 to 255, and a half for rounding.
///
/// An eye sees no part of a step: so planes of a small triangle of one square pixel or more are right to 2^-8 of a step and 2^-15 of
/// what its vertices differ by, `n + m + 1` steps of 2^-16 from rounding at n columns and m rows from the anchor. All others are
/// as near as of any [`Attribute`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Channels(pub(super) [Attribute; 3]);

impl Words for Channels {
    const WORDS: usize = 3;

    #[inline]
    fn store(self, put: &mut impl FnMut(u32)) {
        let Self(channels) = self;
        channels.store(put);
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        Words::load(words).map(Self)
    }
}

impl Varying for Channels {
    #[inline]
    fn plane(gradients: &Gradients, at_vertices: [Self; 3]) -> Plane<Self> {
        let [a, b, c] = at_vertices;
        let bits = |Self([r, g, b]): Self| [r.to_bits(), g.to_bits(), b.to_bits()];
        let Plane { start, dx, dy } = gradients.channels(&[bits(a), bits(b), bits(c)]);
        let channels = |[r, g, b]: [i32; 3]| {
            let channel = Attribute::from_bits;
            Self([channel(r), channel(g), channel(b)])
        };
        Plane { start: channels(start), dx: channels(dx), dy: channels(dy) }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(self.0.plus(other.0))
    }

    #[inline(always)]
    fn times(self, steps: i32) -> Self {
        Self(self.0.times(steps))
    }
}

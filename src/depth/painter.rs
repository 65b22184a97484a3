//! Painter's order: what is drawn later hides what was drawn before, from far to near.
//!
//! A vertex carries one word of depth, and no pixel anything: the triangles of a list are put in order once a frame, by
//! [`DrawList::sort`](crate::DrawList::sort).

use super::{Depth, NoDepth};
use crate::attributes::Words;
use crate::gradients::Plane;
use crate::raster::Tested;

/// Painter's order: a list that is sorted from far to near before it is rendered.
///
/// Nothing is kept for a pixel, and nothing is compared there. What is hidden is painted over, so each pixel is shaded as
/// often as it is covered; and triangles that lie through each other, or in a ring, have no order that is right.
/// [`Hiding::cheapest`](crate::Hiding::cheapest) tells where every pixel is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Painter;

impl Depth for Painter {
    const ALWAYS_VISIBLE: bool = true;
    const KERNELS: bool = true;
    type Vertex = Nearness;
    type Varying = ();
    type Plane<'p> = ();
    type Cell<'p> = ();
    type Cells<'p> = core::iter::Repeat<()>;

    #[inline]
    fn vertex(nearness: impl FnOnce() -> u32) -> Nearness {
        Nearness::new(nearness())
    }

    #[inline]
    fn varying(_: Nearness) {}

    #[inline]
    fn reborrow((): &mut ()) {}

    fn clear((): &mut ()) {}

    #[inline(always)]
    fn span<'p, P>(
        colours: &'p mut [P],
        plane: &'p mut (),
        first: usize,
        length: usize,
    ) -> Option<(&'p mut [P], ())> {
        NoDepth::span(colours, plane, first, length)
    }

    #[inline(always)]
    fn for_kernel(_: Self::Plane<'_>, _: Plane<()>) -> Option<(&mut [u16], Tested)> {
        Some((&mut [], Tested::Never))
    }

    #[inline(always)]
    fn cells((): Self::Plane<'_>) -> Self::Cells<'_> {
        NoDepth::cells(())
    }

    #[inline(always)]
    fn runs<P>(colours: &mut [P], (): (), (): (), (): (), visible: impl FnMut(usize, &mut [P])) {
        NoDepth::runs(colours, (), (), (), visible);
    }

    #[inline(always)]
    fn cover((): (), (): ()) -> bool {
        true
    }
}

/// A vertex's depth: `1 - z / w` as a float of 4 bits of exponent and 26 of mantissa, so greater is nearer.
///
/// Near the far plane a small step of 1 - z / w is a large one of distance: as a float, it tells apart what is 2^-11 of
/// its distance apart wherever it is, down to 2^-14 of the near plane's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nearness(u32);

/// Octaves below the near plane's: the last one goes down to 0.
const OCTAVES: u32 = 14;
/// Bits below an octave's leading one.
const MANTISSA_BITS: u32 = 26;

impl Nearness {
    /// Of `1 - z / w` in 32 fraction bits.
    #[inline]
    pub(crate) fn new(nearness: u32) -> Self {
        let down = nearness.leading_zeros().min(OCTAVES);
        // The leading one counts as the first step of the next octave.
        Self(((OCTAVES - down) << MANTISSA_BITS) + (nearness << down >> (31 - MANTISSA_BITS)))
    }

    /// Sorts a triangle: the mean of its vertices' depths, of which three fit a word. It lies between their keys.
    #[inline]
    pub(crate) fn key([Self(a), Self(b), Self(c)]: [Self; 3]) -> u16 {
        ((a + b + c) >> 16) as u16
    }
}

impl Words for Nearness {
    const WORDS: usize = 1;

    fn store(self, put: &mut impl FnMut(u32)) {
        put(self.0);
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        words.next().map(Self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Depths of every size, in order: each power of two, and what lies about it and between.
    fn depths() -> impl Iterator<Item = u32> {
        (0..32).flat_map(|bit| {
            let one = 1_u32 << bit;
            let part = move |part: u32| ((u64::from(one) * u64::from(part)) >> 10) as u32;
            [one - 1, one].into_iter().chain((1..1024).map(move |k| one + part(k)))
        })
    }

    // Red when an octave starts where the one before does not end, or the last one has a leading one.
    #[test]
    fn nearer_is_greater_and_three_fit_a_key() {
        let mut before = (0, Nearness(0));
        for depth in depths().chain([u32::MAX]) {
            let code = Nearness::new(depth);
            assert!(depth <= before.0 || code.0 >= before.1.0, "{depth:#x}");
            // One octave's step at most, and not more than the depth itself moved.
            assert!(code.0 - before.1.0 <= (depth.abs_diff(before.0)).saturating_mul(1 << 9), "{depth:#x}");
            before = (depth, code);
        }
        assert_eq!(Nearness::new(0).0, 0);
        assert!(Nearness::new(u32::MAX).0 < 1 << 30);
        assert_eq!(Nearness::key([Nearness::new(u32::MAX); 3]), 0xBFFF);
    }

    // Red when a key has less than 11 bits of an octave, or as many of the whole range as a linear one.
    #[test]
    fn keys_tell_apart_a_2048th_of_a_depth_down_to_2_to_the_minus_14() {
        for depth in depths().filter(|depth| (1 << 18..u32::MAX - (1 << 22)).contains(depth)) {
            let [further, nearer] =
                [depth, depth + (depth >> 11) + 1].map(|depth| Nearness::key([Nearness::new(depth); 3]));
            assert!(further < nearer, "{depth:#x}");
        }
    }
}

//! Nothing hides anything.

use super::Depth;
use crate::gradients::Plane;
use crate::raster::Tested;

/// No depth: what is drawn later hides what was drawn before.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoDepth;

impl Depth for NoDepth {
    const ALWAYS_VISIBLE: bool = true;
    const KERNELS: bool = true;
    type Vertex = ();
    type Varying = ();
    type Plane<'p> = ();
    type Cell<'p> = ();
    type Cells<'p> = core::iter::Repeat<()>;

    #[inline]
    fn vertex(_: impl FnOnce() -> u32) {}

    #[inline]
    fn varying((): ()) {}

    #[inline]
    fn reborrow((): &mut ()) {}

    fn clear((): &mut ()) {}

    #[inline(always)]
    fn span<'p, P>(
        colours: &'p mut [P],
        (): &'p mut (),
        first: usize,
        length: usize,
    ) -> Option<(&'p mut [P], ())> {
        Some((colours.get_mut(first..)?.get_mut(..length)?, ()))
    }

    #[inline(always)]
    fn for_kernel(_: Self::Plane<'_>, _: Plane<()>) -> Option<(&mut [u16], Tested)> {
        Some((&mut [], Tested::Never))
    }

    #[inline(always)]
    fn cells((): Self::Plane<'_>) -> Self::Cells<'_> {
        core::iter::repeat(())
    }

    #[inline(always)]
    fn runs<P>(colours: &mut [P], (): (), (): (), (): (), mut visible: impl FnMut(usize, &mut [P])) {
        visible(0, colours);
    }

    #[inline(always)]
    fn cover((): (), (): ()) -> bool {
        true
    }
}

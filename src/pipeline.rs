//! The stages in order: from set-up to the target for one triangle, and the vertex stages before them for a whole mesh.
//!
//! ```text
//! mesh --Face--> transform --Position--> clip --ClipVertex--> setup --Setup--> raster --Span--> depth, shade --Run--> target
//! ```

use core::marker::PhantomData;

use crate::attributes::Words;
use crate::depth::Depth;
use crate::gradients::{Gradients, Plane};
use crate::raster::{DrawSpan, Kernel, Shade, Sides, Span, Traversal, Window};
use crate::retained::Retained;
use crate::run::Run;
use crate::setup::Setup;
use crate::shade::{DrawTriangle, PixelShader};
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// What three vertices carry beside their positions, in canonical order, and the colour of their face.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertices<Z, A> {
    pub(crate) depths: [Z; 3],
    pub(crate) inverses: [PerVertexInverse; 3],
    pub(crate) attributes: [A; 3],
    pub(crate) colour: [u8; 3],
}

/// Where spans end: the cells of a strip, or a display.
pub(crate) trait Surface<P, D: Depth> {
    type Error;

    /// Whether `rows` may ever draw any.
    const KERNELS: bool = false;

    /// Draws a span.
    fn span<'a, S: PixelShader<'a, P>>(
        &mut self,
        span: Span,
        depth: &Plane<D::Varying>,
        shading: &Shading<'a, P, S>,
    ) -> Result<(), Self::Error>;

    /// Has rows drawn by a kernel: whether it knew how to.
    #[inline(always)]
    fn rows<'a, K: Kernel, S: PixelShader<'a, P>>(
        &mut self,
        sides: Sides<'_>,
        depth: &Plane<D::Varying>,
        shading: &Shading<'a, P, S>,
    ) -> bool {
        let _ = (sides, depth, shading);
        false
    }
}

/// How the pixels of a triangle get their colours.
pub(crate) struct Shading<'a, P, S: PixelShader<'a, P>> {
    shader: S,
    triangle: S::Triangle,
    varying: Plane<S::Varying>,
}

impl<'a, P, S: PixelShader<'a, P>> Shading<'a, P, S> {
    /// The one colour of all of them, if there is but one.
    #[inline]
    pub(crate) fn solid(&self) -> Option<P> {
        self.shader.solid(&self.triangle)
    }

    /// Where a kernel gets colours for some cells from, from column 0 of a row on.
    #[inline(always)]
    pub(crate) fn for_kernel<'c>(
        &self,
        row: i32,
        colours: &'c mut [P],
    ) -> Option<(&'c mut [u16], Shade<'a>)> {
        let Self { shader, triangle, varying } = self;
        shader.for_kernel(triangle, varying.starting_in_row(row), colours)
    }

    /// Colours a run that starts in a column of a row.
    #[inline(always)]
    pub(crate) fn shade<D: Depth>(&self, column: i32, row: i32, run: Run<'_, P, D>) {
        let Self { shader, triangle, varying } = self;
        shader.shade(triangle, varying.at(column, row), &varying.dx, run);
    }
}

/// Draws a triangle of three vertices in canonical order, or the part of it that is in a window: what is `retained` of it
/// is known from parts before.
#[inline]
pub(crate) fn draw<'a, P, S, T, D, Target, R>(
    setup: &Setup,
    shader: S,
    vertices: Vertices<D::Varying, S::Vertex>,
    window: &Window,
    target: Target,
    retained: R,
) -> Result<(), Target::Error>
where
    P: Copy,
    S: PixelShader<'a, P>,
    T: Traversal,
    D: Depth,
    Target: Surface<P, D>,
    R: Retain,
{
    let Vertices { depths, inverses, attributes, colour } = vertices;
    let onto = Onto::<T, D, Target, R> { setup, depths, window, target, retained, traversal: PhantomData };
    shader.choose(colour, attributes, inverses, onto)
}

/// What is known of a triangle whose parts are drawn one by one.
pub(crate) trait Retain {
    /// Its planes, if another part was drawn before.
    fn take<W: Words>(&mut self) -> Option<W>;

    /// Its planes, for parts that may follow.
    fn put<W: Words>(&mut self, planes: impl FnOnce() -> W);
}

/// It is drawn as a whole.
impl Retain for () {
    #[inline(always)]
    fn take<W: Words>(&mut self) -> Option<W> {
        None
    }

    #[inline(always)]
    fn put<W: Words>(&mut self, _: impl FnOnce() -> W) {}
}

/// Its first row, and the one after its last.
impl Retain for (&mut Retained<'_>, [u16; 2]) {
    #[inline(always)]
    fn take<W: Words>(&mut self) -> Option<W> {
        let (retained, [first, _]) = self;
        retained.take(i32::from(*first))
    }

    #[inline(always)]
    fn put<W: Words>(&mut self, planes: impl FnOnce() -> W) {
        let (retained, [_, end]) = self;
        retained.put(i32::from(*end), planes);
    }
}

/// Where a triangle is drawn, whichever shader it is that draws it.
struct Onto<'t, T, D: Depth, Target, R> {
    setup: &'t Setup,
    depths: [D::Varying; 3],
    window: &'t Window,
    target: Target,
    /// Its planes, where they are known from a part before.
    retained: R,
    traversal: PhantomData<T>,
}

impl<'a, P: Copy, T: Traversal, D: Depth, Target: Surface<P, D>, R: Retain> DrawTriangle<'a, P>
    for Onto<'_, T, D, Target, R>
{
    type Output = Result<(), Target::Error>;

    #[inline(always)]
    fn draw<S: PixelShader<'a, P>>(
        self,
        shader: S,
        triangle: S::Triangle,
        varyings: [S::Varying; 3],
    ) -> Self::Output {
        let Self { setup, depths, window, target, mut retained, traversal: _ } = self;
        let find = |gradients: &Gradients| {
            let depth = <D::Varying as Varying>::plane(gradients, depths);
            (depth, <S::Varying as Varying>::plane(gradients, varyings))
        };
        // In their place, whether they are taken or found: a small core has no registers for both.
        let Some((depth, varying)) = Words::load(&mut core::iter::repeat(0)) else { return Ok(()) };
        let shading = Shading { shader, triangle, varying };
        let mut spanned = Spanned::<P, S, D, Target> { target, depth, shading };
        let nothing = const { <D::Varying as Varying>::NOTHING && <S::Varying as Varying>::NOTHING };
        if !nothing {
            // Planes start at the frame's corner: they are the same in all parts.
            if let Some(planes) = retained.take() {
                (spanned.depth, spanned.shading.varying) = planes;
            } else {
                (spanned.depth, spanned.shading.varying) = find(&setup.gradients_from(0, 0));
            }
            retained.put(|| (spanned.depth, spanned.shading.varying));
        }
        T::spans(setup, window, &mut spanned)
    }
}

/// All that the spans of a triangle need.
struct Spanned<'a, P, S: PixelShader<'a, P>, D: Depth, Target> {
    target: Target,
    depth: Plane<D::Varying>,
    shading: Shading<'a, P, S>,
}

impl<'a, P, S, D, Target> DrawSpan<Target::Error> for Spanned<'a, P, S, D, Target>
where
    P: Copy,
    S: PixelShader<'a, P>,
    D: Depth,
    Target: Surface<P, D>,
{
    #[inline(always)]
    fn has_kernels(&self) -> bool {
        Target::KERNELS && S::KERNELS
    }

    #[inline(always)]
    fn draw(&mut self, span: Span) -> Result<(), Target::Error> {
        let Self { target, depth, shading } = self;
        target.span(span, depth, shading)
    }

    #[inline(always)]
    fn rows<K: Kernel>(&mut self, sides: Sides<'_>) -> bool {
        let Self { target, depth, shading } = self;
        target.rows::<K, S>(sides, depth, shading)
    }
}

//! The stages in order: from set-up to the target for one triangle, and the vertex stages before them for a whole mesh.
//!
//! ```text
//! mesh --Face--> transform --Position--> clip --ClipVertex--> setup --Setup--> raster --Span--> depth, shade --Run--> target
//! ```

use core::marker::PhantomData;

use crate::depth::Depth;
use crate::gradients::{Gradients, Plane};
use crate::raster::{DrawSpan, Span, Traversal, Window};
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

    /// Draws a span.
    fn span<'a, S: PixelShader<'a, P>>(
        &mut self,
        span: Span,
        depth: &Plane<D::Varying>,
        shading: &Shading<'a, P, S>,
    ) -> Result<(), Self::Error>;
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

    /// Colours a run that starts in a column of a row.
    #[inline(always)]
    pub(crate) fn shade<D: Depth>(&self, column: i32, row: i32, run: Run<'_, P, D>) {
        let Self { shader, triangle, varying } = self;
        shader.shade(triangle, varying.at(column, row), &varying.dx, run);
    }
}

/// Draws a triangle of three vertices in canonical order.
#[inline]
pub(crate) fn draw<'a, P, S, T, D, Target>(
    setup: &Setup,
    shader: S,
    vertices: Vertices<D::Varying, S::Vertex>,
    window: &Window,
    target: Target,
) -> Result<(), Target::Error>
where
    P: Copy,
    S: PixelShader<'a, P>,
    T: Traversal,
    D: Depth,
    Target: Surface<P, D>,
{
    let Vertices { depths, inverses, attributes, colour } = vertices;
    let onto = Onto::<T, D, Target> { setup, depths, window, target, traversal: PhantomData };
    shader.choose(colour, attributes, inverses, onto)
}

/// Where a triangle is drawn, whichever shader it is that draws it.
struct Onto<'t, T, D: Depth, Target> {
    setup: &'t Setup,
    depths: [D::Varying; 3],
    window: &'t Window,
    target: Target,
    traversal: PhantomData<T>,
}

impl<'a, P: Copy, T: Traversal, D: Depth, Target: Surface<P, D>> DrawTriangle<'a, P>
    for Onto<'_, T, D, Target>
{
    type Output = Result<(), Target::Error>;

    #[inline(always)]
    fn draw<S: PixelShader<'a, P>>(
        self,
        shader: S,
        triangle: S::Triangle,
        varyings: [S::Varying; 3],
    ) -> Self::Output {
        let Self { setup, depths, window, target, traversal: _ } = self;
        let nothing = const { <D::Varying as Varying>::NOTHING && <S::Varying as Varying>::NOTHING };
        let gradients = if nothing { Gradients::NONE } else { setup.gradients_from(0, 0) };
        let depth = <D::Varying as Varying>::plane(&gradients, depths);
        let varying = <S::Varying as Varying>::plane(&gradients, varyings);
        let shading = Shading { shader, triangle, varying };
        T::spans(setup, window, &mut Spanned::<P, S, D, Target> { target, depth, shading })
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
    fn draw(&mut self, span: Span) -> Result<(), Target::Error> {
        let Self { target, depth, shading } = self;
        target.span(span, depth, shading)
    }
}

//! The stages in order: from set-up to the target for one triangle, and the vertex stages before them for a whole mesh.
//!
//! ```text
//! mesh --Face--> transform --Position--> clip --ClipVertex--> setup --Setup--> raster --Span--> depth, shade --Run--> target
//! ```

use crate::depth::Depth;
use crate::gradients::{Gradients, Plane};
use crate::raster::{DrawSpan, Span, Traversal, Window};
use crate::run::Run;
use crate::setup::Setup;
use crate::shade::PixelShader;
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

/// Where spans end: a strip or a display.
pub(crate) trait Surface<P, D: Depth> {
    type Error;

    /// The pixels that may be drawn.
    fn window(&self) -> &Window;

    /// Draws a span.
    fn span(
        &mut self,
        span: Span,
        depth: &Plane<D::Varying>,
        shading: &impl Shading<Pixel = P>,
    ) -> Result<(), Self::Error>;
}

/// How the pixels of a triangle get their colours.
pub(crate) trait Shading {
    type Pixel;

    /// The one colour of all of them, if there is but one.
    fn solid(&self) -> Option<Self::Pixel>;

    /// Colours a run that starts in a column of a row.
    fn shade<D: Depth>(&self, column: i32, row: i32, run: Run<'_, Self::Pixel, D>);
}

/// By a shader, pixel by pixel.
struct Shaded<'a, P, S: PixelShader<'a, P>> {
    shader: S,
    triangle: S::Triangle,
    varying: Plane<S::Varying>,
}

impl<'a, P, S: PixelShader<'a, P>> Shading for Shaded<'a, P, S> {
    type Pixel = P;

    #[inline(always)]
    fn solid(&self) -> Option<P> {
        None
    }

    #[inline(always)]
    fn shade<D: Depth>(&self, column: i32, row: i32, run: Run<'_, P, D>) {
        let Self { shader, triangle, varying } = self;
        shader.shade(triangle, varying.at(column, row), &varying.dx, run);
    }
}

/// In one colour, whichever shader found it.
struct Solid<P>(P);

impl<P: Copy> Shading for Solid<P> {
    type Pixel = P;

    #[inline(always)]
    fn solid(&self) -> Option<P> {
        Some(self.0)
    }

    #[inline(always)]
    fn shade<D: Depth>(&self, _: i32, _: i32, run: Run<'_, P, D>) {
        run.fill(self.0);
    }
}

/// Draws a triangle of three vertices in canonical order.
#[inline]
pub(crate) fn draw<'a, P, S, T, D, Target>(
    setup: &Setup,
    shader: S,
    vertices: Vertices<D::Varying, S::Vertex>,
    target: &mut Target,
) -> Result<(), Target::Error>
where
    P: Copy,
    S: PixelShader<'a, P>,
    T: Traversal,
    D: Depth,
    Target: Surface<P, D>,
{
    let Vertices { depths, inverses, attributes, colour } = vertices;
    let [x, y] = setup.anchor();
    if let Some(colour) = shader.solid(colour, &attributes) {
        let nothing = const { <D::Varying as Varying>::NOTHING };
        let gradients = if nothing { Gradients::NONE } else { setup.gradients() };
        let depth = <D::Varying as Varying>::plane(&gradients, depths).moved_from(x, y);
        let (window, shading) = (target.window().clone(), Solid(colour));
        return T::spans(setup, &window, &mut Painter::<D, _, _> { target, depth, shading });
    }
    let (triangle, varyings) = shader.triangle(colour, attributes, inverses);
    let nothing = const { <D::Varying as Varying>::NOTHING && <S::Varying as Varying>::NOTHING };
    let gradients = if nothing { Gradients::NONE } else { setup.gradients() };
    let depth = <D::Varying as Varying>::plane(&gradients, depths).moved_from(x, y);
    let varying = <S::Varying as Varying>::plane(&gradients, varyings).moved_from(x, y);
    let (window, shading) = (target.window().clone(), Shaded { shader, triangle, varying });
    T::spans(setup, &window, &mut Painter::<D, _, _> { target, depth, shading })
}

/// All that the spans of a triangle need.
struct Painter<'t, D: Depth, Target, C> {
    target: &'t mut Target,
    depth: Plane<D::Varying>,
    shading: C,
}

impl<D, Target, C> DrawSpan<Target::Error> for Painter<'_, D, Target, C>
where
    D: Depth,
    Target: Surface<C::Pixel, D>,
    C: Shading,
{
    #[inline(always)]
    fn draw(&mut self, span: Span) -> Result<(), Target::Error> {
        let Self { target, depth, shading } = self;
        target.span(span, depth, shading)
    }
}

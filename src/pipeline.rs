//! The stages in order: from set-up to the target for one triangle, and the vertex stages before them for a whole mesh.
//!
//! ```text
//! mesh --Face--> transform --Position--> clip --ClipVertex--> setup --Setup--> raster --Span--> depth --Run--> shade --> target
//! ```

use crate::gradients::Plane;
use crate::raster::{Span, Traversal, Window};
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

/// A run of pixels in one row, ready to be shaded: what a [`Surface`] hands to the shader, and back to the target.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shading<'t, S, T, V> {
    pub(crate) shader: &'t S,
    pub(crate) triangle: &'t T,
    /// At the first pixel of the span, and the step to the next.
    pub(crate) start: V,
    pub(crate) step: &'t V,
}

/// Where spans end: the depth, shade and target stages of a strip or of a display.
pub(crate) trait Surface<P, Z> {
    type Error;

    /// The pixels that may be drawn.
    fn window(&self) -> &Window;

    /// Draws the visible runs of a span.
    fn span<'a, S: PixelShader<'a, P>>(
        &mut self,
        span: Span,
        depth: (Z, Z),
        shading: Shading<'_, S, S::Triangle, S::Varying>,
    ) -> Result<(), Self::Error>;
}

/// Draws a triangle of three vertices in canonical order.
#[inline]
pub(crate) fn draw<'a, P, S, T, Z, Target>(
    setup: &Setup,
    shader: S,
    vertices: Vertices<Z, S::Vertex>,
    mut target: Target,
) -> Result<(), Target::Error>
where
    S: PixelShader<'a, P>,
    T: Traversal,
    Z: Varying,
    Target: Surface<P, Z>,
{
    let (triangle, varyings) = shader.triangle(vertices.colour, vertices.attributes, vertices.inverses);
    // Planes of nothing need no gradients, and no reciprocal.
    let gradients = setup.gradients();
    let depth: Plane<Z> = Z::plane(&gradients, vertices.depths);
    let varying: Plane<S::Varying> = Varying::plane(&gradients, varyings);
    let [x, y] = setup.anchor();
    let (depth, varying) = (depth.from_anchor(x, y), varying.from_anchor(x, y));
    let window = target.window().clone();
    // All of it moves into what is called for each row, so that nothing is further than one pointer away.
    T::walk(setup, &window, move |span| {
        let start = varying.at(span.start, span.y);
        let shading = Shading { shader: &shader, triangle: &triangle, start, step: &varying.dx };
        target.span(span, (depth.at(span.start, span.y), depth.dx), shading)
    })
}

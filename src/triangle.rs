//! Single triangles, drawn straight to a display: no camera, no list, no buffer, no depth.

use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use heapless::Vec;

use crate::attributes::{Carried, Words, carried, mixed};
use crate::clip::{ClipVertex, MOST_CORNERS, Mix, Outcode, Polygon, add, clip, least};
use crate::depth::NoDepth;
use crate::math::format::{Attribute, SUBPIXELS};
use crate::pipeline::{self, Vertices};
use crate::pixel::Pixel;
use crate::point::Point;
use crate::raster::{DrawSpan, Spans, Traversal, Window};
use crate::setup::{Setup, area2, canonical};
use crate::shade::{Affine, FlatPixel, GouraudPixel, PixelShader, Textured};
use crate::snapped::Snapped;
use crate::target::Display;
use crate::texture::Texture;
use crate::transform::{PerVertexInverse, Position, Projection};
use crate::viewport::Viewport;

/// A triangle of pixels: flat, shaded from corner to corner, or textured. Either way round is drawn.
///
/// It is an embedded-graphics [`Drawable`]: each row is one `fill_contiguous`, or one `fill_solid` where it is flat, and
/// what lies outside of the target is never sent. Triangles that share corners share no pixel and leave no gap. The
/// points count from the top left of the target's bounding box; a target of more than 2^23 pixels, 8190 columns or 4094
/// rows is drawn to as far as that.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::Rgb888;
/// use embedded_graphics::prelude::*;
/// use topleft::{ShadedTriangle, point};
///
/// let mut display = MockDisplay::<Rgb888>::new();
/// let [a, b, c, d] = [point(0.0, 0.0), point(4.0, 0.0), point(4.0, 4.0), point(0.0, 4.0)];
/// ShadedTriangle::flat([a, b, d], Rgb888::RED).draw(&mut display)?;
/// ShadedTriangle::flat([b, c, d], Rgb888::BLUE).draw(&mut display)?; // no pixel twice: the mock would panic
/// display.assert_pattern(&[
///     "RRRB",
///     "RRBB",
///     "RBBB",
///     "BBBB",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ShadedTriangle<'a, C> {
    points: [Point; 3],
    shade: Shade<'a, C>,
}

#[derive(Clone, Copy, Debug)]
enum Shade<'a, C> {
    Flat(C),
    Gouraud([C; 3]),
    Textured([[Attribute; 2]; 3], Texture<'a>),
}

impl<'a, C: Pixel> ShadedTriangle<'a, C> {
    /// A colour at each corner, interpolated between them.
    pub const fn new(points: [Point; 3], colours: [C; 3]) -> Self {
        // Written out: an array of six bytes is copied by a call.
        let [a, b, c] = colours;
        Self { points, shade: Shade::Gouraud([a, b, c]) }
    }

    /// One colour.
    pub const fn flat(points: [Point; 3], colour: C) -> Self {
        Self { points, shade: Shade::Flat(colour) }
    }

    /// A texture, with the texels that stand at the corners: two of these turn, scale and shear an image.
    pub const fn textured(points: [Point; 3], texels: [[Attribute; 2]; 3], texture: &Texture<'a>) -> Self {
        Self { points, shade: Shade::Textured(texels, *texture) }
    }
}

impl<C: Pixel + RgbColor> Drawable for ShadedTriangle<'_, C>
where
    Rgb888: From<C>,
{
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let [Some(a), Some(b), Some(c)] = self.points.map(|point| point.snapped()) else { return Ok(()) };
        let points = [a, b, c];
        match &self.shade {
            Shade::Flat(colour) => draw(FlatPixel, points, [(); 3], channels(*colour), target),
            Shade::Gouraud(colours) => draw(GouraudPixel, points, colours.map(channels), [0; 3], target),
            Shade::Textured(texels, texture) => {
                draw(Textured::new(texture, Affine), points, *texels, [0; 3], target)
            }
        }
    }
}

/// Red, green and blue, 8 bits each.
fn channels<C>(colour: C) -> [u8; 3]
where
    Rgb888: From<C>,
{
    let colour = Rgb888::from(colour);
    [colour.r(), colour.g(), colour.b()]
}

/// Draws a triangle by a shader.
fn draw<'a, C: Pixel + RgbColor, S: PixelShader<'a, C>, D: DrawTarget<Color = C>>(
    shader: S,
    points: [Snapped; 3],
    attributes: [S::Vertex; 3],
    colour: [u8; 3],
    target: &mut D,
) -> Result<(), D::Error> {
    let bounds = target.bounding_box();
    let mut display = Display { origin: bounds.top_left, target };
    let mut result = Ok(());
    fan(bounds.size, points, attributes.map(carried), &mixed::<S::Vertex>, &mut |setup, window, corners| {
        let [Some(a), Some(b), Some(c)] = corners.map(|words| S::Vertex::load(&mut words.iter().copied()))
        else {
            return true;
        };
        let vertices =
            Vertices { depths: [(); 3], inverses: [PerVertexInverse::ONE; 3], attributes: [a, b, c], colour };
        result = pipeline::draw::<_, S, SharedSpans, NoDepth, _, _>(
            setup,
            shader,
            vertices,
            window,
            display.lend(),
            (),
        );
        result.is_ok()
    });
    result
}

/// The span walk, linked once, not for each shader: one more call a row is little beside what a display takes.
struct SharedSpans;

impl Traversal for SharedSpans {
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        fn walk<E>(setup: &Setup, window: &Window, target: &mut dyn DrawSpan<E>) -> Result<(), E> {
            Spans::walk(setup, window, |span| target.draw(span))
        }
        walk(setup, window, target)
    }
}

/// Clips a triangle for a target of some size, as clip vertices with a w of one, and calls `draw` with each of the fan that
/// is left, until it says that this was the last. Whatever the shader is, this is linked once.
#[inline(never)]
fn fan(
    size: Size,
    points: [Snapped; 3],
    carried: [Carried; 3],
    mix: Mix<'_>,
    draw: &mut dyn FnMut(&Setup, &Window, [&Carried; 3]) -> bool,
) {
    let viewport = Viewport::largest(size);
    let window = Window { columns: 0..viewport.width(), rows: 0..viewport.height() };
    let projection = &Projection::of_pixels(viewport);
    let mut places = [Polygon::new(), Polygon::new()];
    let [triangle, _] = &mut places;
    let (mut all, mut any) = (u8::MAX, 0);
    for (point, carried) in points.into_iter().zip(carried) {
        let position = position(point);
        let Outcode(planes) = Outcode::new(&position, projection);
        (all, any) = (all & planes, any | planes);
        add(triangle, &ClipVertex { position, carried });
    }
    if all != 0 {
        return;
    }
    let polygon = clip(Outcode(any), projection, mix, &mut places);
    // Clipping leaves w as it is: nothing has to be divided.
    let snap = |vertex: &ClipVertex| projection.held(vertex.position.x, vertex.position.y);
    let least = least(polygon, &|vertex, _| snap(vertex));
    let (before, from) = polygon.split_at_checked(least).unwrap_or_default();
    let mut corners = Vec::<_, MOST_CORNERS>::new();
    for vertex in from.iter().chain(before) {
        let _ = corners.push((snap(vertex), &vertex.carried));
    }
    let [first, second, rest @ ..] = corners.as_slice() else { return };
    let area = |(middle, _): &(Snapped, _), (last, _): &(Snapped, _)| area2(first.0, *middle, *last);
    // Which way round all of it is. Snapped, a polygon can be dented by a step.
    let (turn, _) = rest.iter().fold((0, second), |(sum, middle), last| (sum + area(middle, last), last));
    let mut middle = second;
    for last in rest {
        if area(middle, last).signum() == -turn.signum() && turn != 0 {
            // A step back: it would hit pixels of its neighbours again.
            continue;
        }
        let order = canonical([*first, *middle, *last]);
        let drawn = Setup::sorted(order.map(|(at, _)| at))
            .map(|setup| draw(&setup, &window, order.map(|(_, carried)| carried)));
        if drawn == Some(false) {
            return;
        }
        middle = last;
    }
}

/// The w of flat drawings.
const ONE: i32 = SUBPIXELS;

fn position(at: Snapped) -> Position {
    let (x, y) = at.bits();
    Position { x, y, z: 0, w: ONE }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::Fraction;

    // Red when w is no power of two, or flat drawings have a centre, or a reach.
    #[test]
    fn what_is_not_projected_is_where_it_would_be() {
        let projection = Projection::of_pixels(Viewport::largest(Size::new(320, 240)));
        let mut state = 1_u64;
        for round in 0..100_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let [x, y] =
                [state as u32, (state >> 32) as u32].map(|bits| bits.cast_signed() >> (2 + round % 20));
            let at = position(Snapped::from_bits(x, y));
            assert_eq!(projection.project(&at, Projection::inverse(at.w)), projection.held(x, y), "{x} {y}");
            assert_eq!(Fraction((state >> 34) as i32).mix(ONE, ONE), ONE);
        }
    }
}

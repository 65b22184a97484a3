//! Single triangles, drawn straight to a display: no camera, no list, no buffer, no depth.

use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

use crate::attributes::{Carried, Words, carried, mixed};
use crate::clip::{ClipVertex, Mix, Outcode, Polygon, clip, least};
use crate::depth::NoDepth;
use crate::math::format::{Attribute, SUBPIXELS};
use crate::pipeline::{self, Vertices};
use crate::pixel::Pixel;
use crate::point::Point;
use crate::raster::{Spans, Window};
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
        Self { points, shade: Shade::Gouraud(colours) }
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
        match self.shade {
            Shade::Flat(colour) => {
                let colour = Rgb888::from(colour);
                draw::<C, _, _>(&FlatPixel, points, [(); 3], [colour.r(), colour.g(), colour.b()], target)
            }
            Shade::Gouraud(colours) => {
                let colours = colours.map(|colour| {
                    let colour = Rgb888::from(colour);
                    [colour.r(), colour.g(), colour.b()]
                });
                draw::<C, _, _>(&GouraudPixel, points, colours, [0; 3], target)
            }
            Shade::Textured(texels, texture) => {
                draw::<C, _, _>(&Textured::new(&texture, Affine), points, texels, [0; 3], target)
            }
        }
    }
}

/// Draws a triangle by a shader.
fn draw<'a, C: Pixel + RgbColor, S: PixelShader<'a, C>, D: DrawTarget<Color = C>>(
    shader: &S,
    points: [Snapped; 3],
    attributes: [S::Vertex; 3],
    colour: [u8; 3],
    target: &mut D,
) -> Result<(), D::Error> {
    let bounds = target.bounding_box();
    let projection = Projection::of_pixels(Viewport::largest(bounds.size));
    let window = Window { columns: 0..projection.viewport.width(), rows: 0..projection.viewport.height() };
    let mut display = Display { origin: bounds.top_left, target };
    let mut result = Ok(());
    fan(&projection, points, attributes.map(carried), &mixed::<S::Vertex>, &mut |setup, corners| {
        let [Some(a), Some(b), Some(c)] = corners.map(|words| S::Vertex::load(&mut words.iter().copied()))
        else {
            return true;
        };
        let vertices =
            Vertices { depths: [(); 3], inverses: [PerVertexInverse::ONE; 3], attributes: [a, b, c], colour };
        result = pipeline::draw::<C, S, Spans, NoDepth, _>(setup, *shader, vertices, &window, display.lend());
        result.is_ok()
    });
    result
}

/// Clips a triangle, as clip vertices with a w of one, and calls `draw` with each of the fan that is left, until it says
/// that this was the last. Whatever the shader is, this is linked once.
#[inline(never)]
fn fan(
    projection: &Projection,
    points: [Snapped; 3],
    carried: [Carried; 3],
    mix: Mix<'_>,
    draw: &mut dyn FnMut(&Setup, [&Carried; 3]) -> bool,
) {
    let ([a, b, c], [p, q, r]) = (points.map(position), carried);
    let [d, e, f] = [a, b, c].map(|at| Outcode::new(&at, projection).0);
    if d & e & f != 0 {
        return;
    }
    let snap = |vertex: &ClipVertex| projection.project(&vertex.position, Projection::inverse(ONE));
    let mut places = [Polygon::new(), Polygon::new()];
    let [triangle, _] = &mut places;
    for (position, carried) in [(a, p), (b, q), (c, r)] {
        let _ = triangle.push(ClipVertex { position, carried });
    }
    let polygon = clip(Outcode(d | e | f), projection, mix, &mut places);
    let least = least(polygon, |_, vertex| {
        let (at, (x, y)) = (vertex.position, snap(vertex).bits());
        [y, x, at.x, at.y]
    });
    let (before, from) = polygon.split_at_checked(least).unwrap_or_default();
    let mut fan = from.iter().chain(before);
    let (Some(first), Some(second)) = (fan.next(), fan.next()) else { return };
    let area = |middle, last| area2(snap(first), snap(middle), snap(last));
    // Which way round all of it is. Snapped, a polygon can be dented by a step.
    let (turn, _) = fan.clone().fold((0, second), |(sum, middle), last| (sum + area(middle, last), last));
    let mut middle = second;
    for last in fan {
        if area(middle, last).signum() == -turn.signum() && turn != 0 {
            // A step back: it would hit pixels of its neighbours again.
            continue;
        }
        let order = canonical([first, middle, last].map(|vertex| (snap(vertex), vertex)));
        let drawn = Setup::sorted(order.map(|(at, _)| at))
            .map(|setup| draw(&setup, order.map(|(_, vertex)| &vertex.carried)));
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

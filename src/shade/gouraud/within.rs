//! Triangles of nearly one colour in one.

use super::{Channels, Gouraud, GouraudPixel, in_steps};
use crate::depth::Depth;
use crate::math::format::Attribute;
use crate::mesh::Mesh;
use crate::pixel::{Pixel, Stepped};
use crate::pose::Pose;
use crate::run::Run;
use crate::shade::light::Lighting;
use crate::shade::{DrawTriangle, FlatPixel, PixelShader, Shader, Uniforms};
use crate::transform::PerVertexInverse;

/// How far off a channel of a pixel may be, in codes of 255, for the sake of speed.
///
/// ```
/// use topleft::{Attribute, ColourError};
///
/// let half = ColourError::codes(Attribute::lit("0.5"));
/// assert_eq!(ColourError::codes(Attribute::lit("0.9")), half);
/// assert_eq!(ColourError::codes(Attribute::lit("-3")), ColourError::codes(Attribute::ZERO));
/// assert_eq!(ColourError::codes(Attribute::MAX), ColourError::codes(Attribute::lit("127.5")));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColourError {
    /// Twice the error: what vertices may differ by, in whole codes.
    spread: u8,
}

impl ColourError {
    /// An error of at most so many codes: from 0 to 127.5, in steps of a half, rounded down. Less than 0 is 0, and more than
    /// 127.5 is that: half of what two colours can differ by.
    pub const fn codes(error: Attribute) -> Self {
        let twice = error.to_bits() >> 15;
        Self {
            spread: if twice < 0 {
                0
            } else if twice > 255 {
                255
            } else {
                twice as u8
            },
        }
    }
}

/// Four codes: half a step of a channel of five bits, which is what such a display rounds by; eight are a step of it.
impl Default for ColourError {
    fn default() -> Self {
        Self { spread: 8 }
    }
}

/// [`Gouraud`], with each triangle of nearly one colour drawn in one, as far as a [`ColourError`] allows.
///
/// A triangle between whose vertices no channel differs by more than twice the error is drawn in the middle of each
/// channel, as fast as one of [`Flat`](super::super::Flat). What it would show lies between its vertices' colours, so none of
/// it is off by more than half of their difference, and so than the error. The middle is found in the display's steps
/// and rounded down to 2^-17 of one; then it is rounded to nearest, as every colour is. All other triangles are drawn by
/// [`Gouraud`]'s own loop.
///
/// An error of zero gives the same bytes as [`Gouraud`]: what is of one colour is found out, and nothing else is. From 127.5
/// codes on every triangle is of one colour.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use topleft::{Attribute, ColourError, Gouraud, Length, Material, Sun};
///
/// let (sun, brass) = (Sun::new([Length::ONE; 3]), Material::from(Rgb888::new(0xD0, 0xA0, 0x40)));
/// let quick = Gouraud::new(&sun, &brass).within(ColourError::default());
/// let closer = Gouraud::new(&sun, &brass).within(ColourError::codes(Attribute::ONE));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct GouraudWithin<L> {
    gouraud: Gouraud<L>,
    error: ColourError,
}

impl<L: Lighting> Gouraud<L> {
    /// The same with each triangle of nearly one colour drawn in one: no channel is off by more than `error`.
    #[must_use]
    pub const fn within(self, error: ColourError) -> GouraudWithin<L> {
        GouraudWithin { gouraud: self, error }
    }
}

impl<'a, P: Pixel, L: Lighting> Shader<'a, P> for GouraudWithin<L> {
    type Pixel = GouraudWithinPixel;
    type Local = L::Local;

    fn pixel(&self) -> GouraudWithinPixel {
        GouraudWithinPixel { spread: self.error.spread }
    }

    fn local(&self, mesh: &Mesh<'_>, pose: &Pose) -> L::Local {
        Shader::<P>::local(&self.gouraud, mesh, pose)
    }

    fn vertex(&self, local: &L::Local, mesh: &Mesh<'_>, vertex: usize) -> [u8; 3] {
        Shader::<P>::vertex(&self.gouraud, local, mesh, vertex)
    }

    fn face(&self, _: &L::Local, _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

/// The pixel half of [`GouraudWithin`].
#[derive(Clone, Copy, Debug)]
pub struct GouraudWithinPixel {
    spread: u8,
}

impl<'a, P: Pixel> PixelShader<'a, P> for GouraudWithinPixel {
    type Vertex = [u8; 3];
    type Varying = Channels;
    type Triangle = ();
    type Simple = Self;
    const PERSPECTIVE: bool = false;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms { words: [self.spread.into(), 0], ..Uniforms::NONE }
    }

    #[inline]
    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
        let [spread, _] = uniforms.words;
        Self { spread: spread as u8 }
    }

    #[inline]
    fn triangle(
        &self,
        colour: [u8; 3],
        vertices: [[u8; 3]; 3],
        inverses: [PerVertexInverse; 3],
    ) -> ((), [Channels; 3]) {
        PixelShader::<P>::triangle(&GouraudPixel, colour, vertices, inverses)
    }

    #[inline]
    fn choose<D: DrawTriangle<'a, P>>(
        &self,
        colour: [u8; 3],
        vertices: [[u8; 3]; 3],
        inverses: [PerVertexInverse; 3],
        onto: D,
    ) -> D::Output {
        match one_colour(self.spread, vertices) {
            Some(colour) => onto.draw(FlatPixel, colour, [(); 3]),
            None => GouraudPixel.choose(colour, vertices, inverses, onto),
        }
    }

    #[inline(always)]
    fn shade<D: Depth>(&self, (): &(), start: Channels, step: &Channels, run: Run<'_, P, D>) {
        GouraudPixel.shade(&(), start, step, run);
    }
}

/// The middle of three colours, where no channel differs by more than `spread`.
#[inline(always)]
fn one_colour<P: Pixel>(spread: u8, [a, b, c]: [[u8; 3]; 3]) -> Option<P> {
    let ([ar, ag, ab], [br, bg, bb], [cr, cg, cb]) = (a, b, c);
    let ends = |a: u8, b: u8, c: u8| {
        let (least, most) = (a.min(b).min(c), a.max(b).max(c));
        if most - least > spread { None } else { Some((least, most)) }
    };
    let ((least_r, most_r), (least_g, most_g), (least_b, most_b)) =
        (ends(ar, br, cr)?, ends(ag, bg, cg)?, ends(ab, bb, cb)?);
    let least = in_steps::<P>([least_r, least_g, least_b]);
    let most = in_steps::<P>([most_r, most_g, most_b]);
    let (Channels([least_r, least_g, least_b]), Channels([most_r, most_g, most_b])) = (least, most);
    let middle = |a: Attribute, b: Attribute| Attribute::from_bits((a.to_bits() + b.to_bits()) >> 1);
    let middles = [middle(least_r, most_r), middle(least_g, most_g), middle(least_b, most_b)];
    Some(P::Stepped::new(middles).colour())
}

//! An error budget for colour and light: what changes little over a triangle is drawn as one.
//!
//! [`ColourError`] is the budget. What differs in colour is here a file: `colour.rs` has the colours of a face,
//! `light.rs` the light on a texture.

use super::textured::LitTexture;
use super::{Gouraud, PixelShader, Shader};
use crate::math::format::Attribute;
use crate::mesh::Mesh;
use crate::pose::Pose;

mod colour;
mod light;

/// How far off a channel of a pixel may be, in codes of 255, for the sake of speed.
///
/// A triangle between whose vertices no channel differs by more than twice this is drawn in one colour: the middle of
/// what it would show. A channel of its pixels lies between those of its vertices, so it is off by at most half of their
/// difference, and so by this. The same holds for the light on a texture, whose full light is 255. All other triangles
/// are drawn as without a budget.
///
/// Beside this there is what there is without a budget: half a step of the display's channel, as it is rounded to
/// nearest; 255 steps of 2^-16 of one for how a vertex's colour is put in them; and for a texture half a step of light,
/// 255 / 128 codes. The middle adds 2^-17 of a step, and interpolating nothing: what is not interpolated is not off by it.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use topleft::{Attribute, ColourError, Gouraud, Length, Material, Sun};
///
/// let (sun, brass) = (Sun::new([Length::ONE; 3]), Material::from(Rgb888::new(0xD0, 0xA0, 0x40)));
/// let exact = Gouraud::new(&sun, &brass);
/// let cheaper = exact.within(ColourError::codes(Attribute::lit("4")));
/// assert_eq!(ColourError::codes(Attribute::lit("-1")), ColourError::NONE);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColourError {
    /// Twice the error: what vertices may differ by, in whole codes.
    spread: u8,
}

impl ColourError {
    /// None: the same bytes as without a budget. What is of one colour is drawn as such.
    pub const NONE: Self = Self { spread: 0 };

    /// An error of at most so many codes of 255, in steps of a half. Less than 0 is 0; from 127.5 on all triangles are drawn
    /// in one colour.
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

/// A shader that may be as far off as a [`ColourError`] allows.
#[derive(Clone, Copy, Debug)]
pub struct Budgeted<S> {
    shader: S,
    error: ColourError,
}

impl<L> Gouraud<L> {
    /// The same with triangles of nearly one colour drawn in one.
    pub const fn within(self, error: ColourError) -> Budgeted<Self>
    where
        L: Copy,
    {
        Budgeted { shader: self, error }
    }
}

impl<C: Copy> LitTexture<'_, C> {
    /// The same with triangles of nearly one light drawn under one, and in full light as without.
    pub const fn within(self, error: ColourError) -> Budgeted<Self> {
        Budgeted { shader: self, error }
    }
}

/// The pixel half of [`Budgeted`].
#[derive(Clone, Copy, Debug)]
pub struct BudgetedPixel<S>(S);

impl<'a, P, S: Shader<'a, P>> Shader<'a, P> for Budgeted<S>
where
    BudgetedPixel<S::Pixel>: PixelShader<'a, P, Vertex = <S::Pixel as PixelShader<'a, P>>::Vertex>,
{
    type Pixel = BudgetedPixel<S::Pixel>;
    type Local = S::Local;

    fn pixel(&self) -> Self::Pixel {
        BudgetedPixel(self.shader.pixel())
    }

    fn local(&self, mesh: &Mesh<'_>, pose: &Pose) -> S::Local {
        self.shader.local(mesh, pose)
    }

    fn vertex(
        &self,
        local: &S::Local,
        mesh: &Mesh<'_>,
        vertex: usize,
    ) -> <S::Pixel as PixelShader<'a, P>>::Vertex {
        self.shader.vertex(local, mesh, vertex)
    }

    /// What vertices may differ by, in place of a colour, which faces of these shaders have not.
    fn face(&self, _: &S::Local, _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [self.error.spread, 0, 0]
    }
}

/// The middle of three values that do not differ by more than `spread` steps of their format.
#[inline(always)]
fn middle([a, b, c]: [Attribute; 3], spread: i32) -> Option<Attribute> {
    let (least, most) = (a.min(b).min(c).to_bits(), a.max(b).max(c).to_bits());
    let difference = most.wrapping_sub(least);
    if difference > spread { None } else { Some(Attribute::from_bits(least.wrapping_add(difference >> 1))) }
}

//! A colour a vertex, interpolated.

use super::light::{Lighting, Material, Sun, Unlit};
use super::{PixelShader, Shader, Uniforms};
use crate::depth::Depth;
use crate::gradients::Plane;
use crate::math::format::Attribute;
use crate::mesh::Mesh;
use crate::pixel::{Pixel, Stepped};
use crate::pose::Pose;
use crate::raster::Shade;
use crate::run::Run;
use crate::transform::PerVertexInverse;

mod channels;
mod within;

use channels::Channels;
pub use within::{ColourError, GouraudWithin};

/// A colour a vertex, interpolated over the face: lit by the vertices' normals, or the mesh's own colours as they are.
///
/// Colours are interpolated in steps of the display's own channels, with 16 fraction bits, and rounded to nearest. Before
/// that they are off by less than 2^-6 of a step within 2000 pixels of the triangle's first vertex, columns and rows together.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use topleft::{Gouraud, Length, Material, Sun};
///
/// let sun = Sun::new([Length::ONE; 3]);
/// let brass = Material::from(Rgb888::new(0xD0, 0xA0, 0x40));
/// let shader = Gouraud::new(&sun, &brass);
/// let painted = Gouraud::unlit(&Material::OfMesh);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Gouraud<L = Sun> {
    material: Material,
    light: L,
}

impl Gouraud {
    /// The material under the light that falls on each vertex by its normal.
    pub const fn new(sun: &Sun, material: &Material) -> Self {
        Self { material: *material, light: *sun }
    }
}

impl Gouraud<Unlit> {
    /// The material as it is.
    pub const fn unlit(material: &Material) -> Self {
        Self { material: *material, light: Unlit }
    }
}

impl<'a, P: Pixel, L: Lighting> Shader<'a, P> for Gouraud<L> {
    type Pixel = GouraudPixel;
    type Local = L::Local;

    fn pixel(&self) -> GouraudPixel {
        GouraudPixel
    }

    fn local(&self, _: &Mesh<'_>, pose: &Pose) -> L::Local {
        self.light.local(pose)
    }

    fn vertex(&self, local: &L::Local, mesh: &Mesh<'_>, vertex: usize) -> [u8; 3] {
        L::on_vertex(local, mesh, vertex, self.material.of_vertex(mesh, vertex))
    }

    fn face(&self, _: &L::Local, _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

/// The pixel half of [`Gouraud`].
#[derive(Clone, Copy, Debug)]
pub struct GouraudPixel;

impl<'a, P: Pixel> PixelShader<'a, P> for GouraudPixel {
    type Vertex = [u8; 3];
    type Varying = Channels;
    type Triangle = ();
    type Simple = Self;
    const PERSPECTIVE: bool = false;
    const KERNELS: bool = true;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms::NONE
    }

    #[inline]
    fn from_uniforms(_: &Uniforms<'a>) -> Self {
        Self
    }

    #[inline]
    fn triangle(&self, _: [u8; 3], vertices: [[u8; 3]; 3], _: [PerVertexInverse; 3]) -> ((), [Channels; 3]) {
        let [a, b, c] = vertices;
        ((), [in_steps::<P>(a), in_steps::<P>(b), in_steps::<P>(c)])
    }

    #[inline(always)]
    fn shade<D: Depth>(
        &self,
        (): &(),
        Channels(start): Channels,
        Channels(step): &Channels,
        run: Run<'_, P, D>,
    ) {
        let (mut colour, step) = (P::Stepped::new(start), P::Stepped::new(*step));
        for pixel in run.pixels() {
            pixel.shade(|| colour.colour());
            colour = colour.plus(step);
        }
    }

    #[inline(always)]
    fn for_kernel<'c>(
        &self,
        (): &(),
        channels: Plane<Channels>,
        colours: &'c mut [P],
    ) -> Option<(&'c mut [u16], Shade<'a>)> {
        let Plane { start: Channels(start), dx: Channels(dx), dy: Channels(dy) } = channels;
        Some((P::words(colours)?, Shade::Gouraud(Plane { start, dx, dy })))
    }
}

/// A colour of 0 to 255 in steps of the pixel's channels, and a half, so that dropping the fraction rounds to nearest.
#[inline]
fn in_steps<P: Pixel>([r, g, b]: [u8; 3]) -> Channels {
    let [max_r, max_g, max_b] = P::MAX;
    let channel = |c: u8, max: u8| {
        let per_code = (i32::from(max) << 16) / 255;
        Attribute::from_bits(i32::from(c) * per_code + (1 << 15))
    };
    Channels([channel(r, max_r), channel(g, max_g), channel(b, max_b)])
}

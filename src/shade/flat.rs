//! One colour a face.

use super::light::{Lighting, Material, Sun, Unlit};
use super::{PixelShader, Shader, Uniforms};
use crate::depth::Depth;
use crate::gradients::Plane;
use crate::mesh::Mesh;
use crate::pixel::Pixel;
use crate::pose::Pose;
use crate::raster::Shade;
use crate::run::Run;
use crate::transform::PerVertexInverse;

/// One colour a face, with or without light.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use topleft::{Flat, Length, Material, Sun};
///
/// let paper = Flat::new(Rgb888::new(250, 240, 220));
/// let painted = Flat::new(Material::OfMesh).lit_by(&Sun::new([Length::ONE; 3]));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Flat<L = Unlit> {
    material: Material,
    light: L,
}

impl Flat {
    /// The material as it is, without light.
    pub fn new(material: impl Into<Material>) -> Self {
        Self { material: material.into(), light: Unlit }
    }
}

impl<L: Lighting> Flat<L> {
    /// The same under a light that falls on each face by its normal.
    #[must_use]
    pub const fn lit_by(self, sun: &Sun) -> Flat<Sun> {
        Flat { material: self.material, light: *sun }
    }
}

impl<'a, P: Pixel, L: Lighting> Shader<'a, P> for Flat<L> {
    type Pixel = FlatPixel;
    type Local = L::Local;

    fn pixel(&self) -> FlatPixel {
        FlatPixel
    }

    fn local(&self, _: &Mesh<'_>, pose: &Pose) -> L::Local {
        self.light.local(pose)
    }

    fn vertex(&self, _: &L::Local, _: &Mesh<'_>, _: usize) {}

    fn face(&self, local: &L::Local, mesh: &Mesh<'_>, face: usize) -> [u8; 3] {
        L::on_face(local, mesh, face, self.material.of_face(mesh, face))
    }
}

/// The pixel half of [`Flat`].
#[derive(Clone, Copy, Debug)]
pub struct FlatPixel;

impl<'a, P: Pixel> PixelShader<'a, P> for FlatPixel {
    type Vertex = ();
    type Varying = ();
    type Triangle = P;
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
    fn triangle(&self, colour: [u8; 3], _: [(); 3], _: [PerVertexInverse; 3]) -> (P, [(); 3]) {
        (P::from_rgb(colour), [(); 3])
    }

    #[inline(always)]
    fn shade<D: Depth>(&self, colour: &P, (): (), (): &(), run: Run<'_, P, D>) {
        run.fill(*colour);
    }

    #[inline(always)]
    fn for_kernel<'c>(
        &self,
        colour: &P,
        _: Plane<()>,
        colours: &'c mut [P],
    ) -> Option<(&'c mut [u16], Shade<'a>)> {
        Some((P::words(colours)?, Shade::Flat(P::word(*colour)?)))
    }

    fn solid(&self, colour: &P) -> Option<P> {
        Some(*colour)
    }
}

//! One colour a face.

use super::light::{LocalSun, Material, Sun, lit};
use super::{PixelShader, Shader, Uniforms};
use crate::depth::Depth;
use crate::mesh::Mesh;
use crate::pixel::Pixel;
use crate::pose::Pose;
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
pub struct Flat {
    material: Material,
    sun: Option<Sun>,
}

impl Flat {
    /// The material as it is, without light.
    pub fn new(material: impl Into<Material>) -> Self {
        Self { material: material.into(), sun: None }
    }

    /// The same under a light that falls on each face by its normal.
    #[must_use]
    pub const fn lit_by(mut self, sun: &Sun) -> Self {
        self.sun = Some(*sun);
        self
    }
}

impl<'a, P: Pixel> Shader<'a, P> for Flat {
    type Pixel = FlatPixel;
    type Local = Option<LocalSun>;

    fn pixel(&self) -> FlatPixel {
        FlatPixel
    }

    fn local(&self, _: &Mesh<'_>, pose: &Pose) -> Option<LocalSun> {
        self.sun.map(|sun| sun.local(pose))
    }

    fn vertex(&self, _: &Option<LocalSun>, _: &Mesh<'_>, _: usize) {}

    fn face(&self, local: &Option<LocalSun>, mesh: &Mesh<'_>, face: usize) -> [u8; 3] {
        let colour = self.material.of_face(mesh, face);
        match local {
            Some(sun) => lit(colour, sun.on_face(mesh, face)),
            None => colour,
        }
    }
}

/// The pixel half of [`Flat`].
#[derive(Clone, Copy, Debug)]
pub struct FlatPixel;

impl<'a, P: Pixel> PixelShader<'a, P> for FlatPixel {
    type Vertex = ();
    type Varying = ();
    type Triangle = P;
    const PERSPECTIVE: bool = false;

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

    fn solid(&self, colour: &P) -> Option<P> {
        Some(*colour)
    }
}

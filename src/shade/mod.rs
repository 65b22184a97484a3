//! Stage 7. The colour of each pixel of a visible run.
//!
//! A shader has two halves. Its vertex half, [`Shader`], is borrowed while a mesh is drawn into a list: it makes
//! attributes of vertices and colours of faces. Its pixel half, [`PixelShader`], is small and `Copy`: the list keeps it
//! and calls it for each run. Only the shaders that a program uses are linked.

use crate::attributes::Attributes;
use crate::depth::Depth;
use crate::gradients::Plane;
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::raster::Shade;
use crate::run::Run;
use crate::texture::Texture;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

mod flat;
mod gouraud;
mod light;
mod over_w;
mod perspective;
mod sampler;
mod textured;

pub use flat::{Flat, FlatPixel};
pub use gouraud::GouraudPixel;
pub use gouraud::{ColourError, Gouraud, GouraudWithin};
pub use light::{Lighting, Material, Sun, Unlit};
pub use perspective::{
    Affine, Correction, Divide, Divided, DrawTexels, PerPixel, Portable, Subspans, Within,
};
pub use sampler::Sampler;
pub use textured::{LitTexture, Textured};

/// The vertex half of a shader, borrowed while a mesh is drawn into a list.
pub trait Shader<'a, P> {
    /// The pixel half.
    type Pixel: PixelShader<'a, P>;
    /// What is computed once a mesh: the light as the mesh sees it.
    type Local;

    /// The pixel half, which the list keeps.
    fn pixel(&self) -> Self::Pixel;

    /// What all vertices and faces of a mesh in this pose share.
    fn local(&self, mesh: &Mesh<'_>, pose: &Pose) -> Self::Local;

    /// What a vertex carries.
    fn vertex(
        &self,
        local: &Self::Local,
        mesh: &Mesh<'_>,
        vertex: usize,
    ) -> <Self::Pixel as PixelShader<'a, P>>::Vertex;

    /// The colour of a face: red, green, blue.
    fn face(&self, local: &Self::Local, mesh: &Mesh<'_>, face: usize) -> [u8; 3];
}

/// The pixel half of a shader, kept by a list.
///
/// ```
/// use topleft::stages::{DrawTriangle, FlatPixel, PerVertexInverse, PixelShader, Run, Shader, Uniforms, Varying};
/// use topleft::{Attribute, Depth, Mesh, Pixel, Pose};
///
/// /// Grey by height, and one grey where a triangle is level.
/// #[derive(Clone, Copy)]
/// struct Heights;
///
/// fn grey<P: Pixel>(height: Attribute) -> P {
///     P::from_rgb([height.to_num::<i32>().clamp(0, 255) as u8; 3])
/// }
///
/// impl<'a, P: Pixel> Shader<'a, P> for Heights {
///     type Pixel = Self;
///     type Local = ();
///
///     fn pixel(&self) -> Self {
///         *self
///     }
///
///     fn local(&self, _: &Mesh<'_>, _: &Pose) {}
///
///     fn vertex(&self, (): &(), mesh: &Mesh<'_>, vertex: usize) -> Attribute {
///         let [_, y, _] = mesh.positions()[vertex];
///         Attribute::from_bits((i32::from(y) + 32_768) << 8)
///     }
///
///     fn face(&self, (): &(), _: &Mesh<'_>, _: usize) -> [u8; 3] {
///         [0; 3]
///     }
/// }
///
/// impl<'a, P: Pixel> PixelShader<'a, P> for Heights {
///     type Vertex = Attribute;
///     type Varying = Attribute;
///     type Triangle = ();
///     type Simple = Self;
///     const PERSPECTIVE: bool = false;
///
///     // Of two shaders with the same uniforms a list keeps one.
///     fn uniforms(&self) -> Uniforms<'a> {
///         Uniforms::NONE
///     }
///
///     fn from_uniforms(_: &Uniforms<'a>) -> Self {
///         Self
///     }
///
///     fn triangle(
///         &self,
///         _: [u8; 3],
///         heights: [Attribute; 3],
///         _: [PerVertexInverse; 3],
///     ) -> ((), [Attribute; 3]) {
///         ((), heights)
///     }
///
///     fn choose<D: DrawTriangle<'a, P>>(
///         &self,
///         _: [u8; 3],
///         heights: [Attribute; 3],
///         _: [PerVertexInverse; 3],
///         onto: D,
///     ) -> D::Output {
///         let [a, b, c] = heights;
///         if a == b && b == c { onto.draw(FlatPixel, grey(a), [(); 3]) } else { onto.draw(*self, (), heights) }
///     }
///
///     fn shade<D: Depth>(&self, (): &(), mut height: Attribute, step: &Attribute, run: Run<'_, P, D>) {
///         for place in run.pixels() {
///             place.shade(|| grey(height));
///             height = height.plus(*step);
///         }
///     }
/// }
/// # use embedded_graphics_core::{geometry::Size, pixelcolor::Rgb888};
/// # use topleft::{ListStorage, Orthographic, Strip};
/// # let (mut storage, mut colours) = (ListStorage::<100, 12>::new(), [Rgb888::new(9, 0, 0); 256]);
/// # let mut list = storage.list();
/// # let camera = Orthographic::new(Size::new(16, 16), 4.0, -9.0..9.0).look_at([0.0, 1.0, 1.0], [0.0; 3]);
/// # list.draw(&camera, &scenes::mesh::CUBE, &Pose::new(), &Heights).unwrap();
/// # list.render(0..16, &mut Strip::new(16, &mut colours).unwrap());
/// # let top = Pixel::channels(colours[16 * 6 + 8]);
/// # assert!(top == [255; 3], "{top:?}");
/// ```
pub trait PixelShader<'a, P>: Copy {
    /// What a vertex of the list carries.
    type Vertex: Attributes;
    /// What changes from pixel to pixel: linear on the screen.
    type Varying: Varying;
    /// What all pixels of a triangle share.
    type Triangle: Copy;
    /// What draws the triangles that [`is_simple`](Self::is_simple) tells, by the same uniforms; `Self`, if it tells none. One that
    /// needs 1/w where this shader's vertices carry none does not compile.
    type Simple: PixelShader<'a, P, Vertex = Self::Vertex>;
    /// Whether a vertex carries 1/w as well.
    const PERSPECTIVE: bool;

    /// This shader as a list keeps it.
    fn uniforms(&self) -> Uniforms<'a>;

    /// The shader that was kept.
    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self;

    /// What the pixels of a triangle share, and the varyings at its vertices.
    ///
    /// `inverses` are the vertices' 1/w; they mean something only where [`PERSPECTIVE`](Self::PERSPECTIVE) is true.
    fn triangle(
        &self,
        colour: [u8; 3],
        vertices: [Self::Vertex; 3],
        inverses: [PerVertexInverse; 3],
    ) -> (Self::Triangle, [Self::Varying; 3]);

    /// Whether [`is_simple`](Self::is_simple) is ever true: it is not asked otherwise.
    const SIMPLIFIES: bool = false;

    /// Whether a triangle may be drawn by [`Simple`](Self::Simple): asked once, when the triangle comes into a list, of the words
    /// of this shader's uniforms and of what the vertices carry. Such a triangle never comes to [`choose`](Self::choose), which
    /// is asked in each strip.
    #[inline(always)]
    fn is_simple(words: [u32; 2], vertices: [Self::Vertex; 3], inverses: [PerVertexInverse; 3]) -> bool {
        let _ = (words, vertices, inverses);
        false
    }

    /// Has a triangle drawn: by this shader, or by a cheaper one that shows the same of it, or what the caller allowed.
    ///
    /// `onto` takes any pixel shader, such as [`FlatPixel`] with a colour. `inverses` mean something only where this
    /// shader's [`PERSPECTIVE`](Self::PERSPECTIVE) is true.
    #[inline(always)]
    fn choose<D: DrawTriangle<'a, P>>(
        &self,
        colour: [u8; 3],
        vertices: [Self::Vertex; 3],
        inverses: [PerVertexInverse; 3],
        onto: D,
    ) -> D::Output {
        let (triangle, varyings) = self.triangle(colour, vertices, inverses);
        onto.draw(*self, triangle, varyings)
    }

    /// Colours a run: `start` at its first pixel, `step` more at each after it. [`Varying::plus`] takes the step, and wraps:
    /// past the last pixel the sum may not fit.
    fn shade<D: Depth>(
        &self,
        triangle: &Self::Triangle,
        start: Self::Varying,
        step: &Self::Varying,
        run: Run<'_, P, D>,
    );

    /// Whether [`for_kernel`](Self::for_kernel) may ever give something.
    const KERNELS: bool = false;

    /// Where a [`Kernel`](crate::stages::Kernel) gets the colours of some cells from, if there are kernels for such cells and
    /// colours; and the cells as words, one for each, in their order.
    #[inline(always)]
    fn for_kernel<'c>(
        &self,
        triangle: &Self::Triangle,
        varying: Plane<Self::Varying>,
        colours: &'c mut [P],
    ) -> Option<(&'c mut [u16], Shade<'a>)> {
        let _ = (triangle, varying, colours);
        None
    }

    /// The one colour of the triangle, where it has but one.
    fn solid(&self, triangle: &Self::Triangle) -> Option<P> {
        let _ = triangle;
        None
    }
}

/// What a shader hands a triangle to, once it has chosen how to draw it.
pub trait DrawTriangle<'a, P> {
    /// What comes of it.
    type Output;

    /// Draws the triangle: what its pixels share, and the varyings at its vertices.
    fn draw<S: PixelShader<'a, P>>(
        self,
        shader: S,
        triangle: S::Triangle,
        varyings: [S::Varying; 3],
    ) -> Self::Output;
}

/// A pixel shader as a list keeps it: a texture and two words, for whatever it is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Uniforms<'a> {
    /// The texture, or one white texel.
    pub texture: Texture<'a>,
    /// Anything else.
    pub words: [u32; 2],
}

impl<'a> Uniforms<'a> {
    /// Nothing but one white texel.
    pub const NONE: Self = Self { texture: Texture::WHITE, words: [0; 2] };

    /// A texture.
    pub const fn texture(texture: Texture<'a>) -> Self {
        Self { texture, words: [0; 2] }
    }

    /// Whether it is the same: equal, with the texels in the same place.
    pub(crate) fn is(&self, other: &Self) -> bool {
        self.words == other.words && self.texture.is(&other.texture)
    }
}

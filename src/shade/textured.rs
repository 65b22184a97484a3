//! Textures, as they are or under light.

use core::marker::PhantomData;

use super::light::{Lighting, LocalSun, Sun};
use super::perspective::{Affine, Correction, DrawTexels};
use super::sampler::{Lit, Paint, Painted, Plain};
use super::{DrawTriangle, PixelShader, Shader, Uniforms};
use crate::depth::Depth;
use crate::gradients::Plane;
use crate::math::format::Attribute;
use crate::mesh::Mesh;
use crate::pixel::Pixel;
use crate::pose::Pose;
use crate::raster::Shade;
use crate::run::Run;
use crate::texture::Texture;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// A texture, nearest texel, as it is.
///
/// ```
/// use topleft::{Affine, PerPixel, Texture, Textured};
///
/// static TEXELS: [u16; 4] = [0xF800, 0x07E0, 0x001F, 0xFFFF];
/// let texture = Texture::new(2, 2, &TEXELS).unwrap();
/// let exact = Textured::new(&texture, PerPixel);
/// let cheap = Textured::new(&texture, Affine);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Textured<'a, C> {
    texture: Texture<'a>,
    correction: C,
}

impl<'a, C: Correction> Textured<'a, C> {
    /// The texture, with texels found by `correction`.
    pub const fn new(texture: &Texture<'a>, correction: C) -> Self {
        Self { texture: *texture, correction }
    }

    /// Paints a run.
    #[inline(always)]
    fn walk<P>(
        &self,
        triangle: &C::Triangle,
        start: C::Varying,
        step: &C::Varying,
        run: &mut [P],
        paint: impl Paint<P>,
    ) {
        let Self { texture, correction } = self;
        correction.walk(triangle, start, step, run, &mut Painted { texture, paint });
    }

    /// The same under a light that falls on each vertex by its normal.
    pub const fn lit_by(self, sun: &Sun) -> LitTexture<'a, C> {
        LitTexture { textured: self, sun: *sun }
    }
}

/// A texture, nearest texel, under a light that is interpolated from vertex to vertex.
#[derive(Clone, Copy, Debug)]
pub struct LitTexture<'a, C> {
    textured: Textured<'a, C>,
    sun: Sun,
}

/// A vertex's place in the texture, in texels. A mesh without coordinates shows the first texel only.
fn texel(texture: &Texture<'_>, mesh: &Mesh<'_>, vertex: usize) -> [Attribute; 2] {
    let [u, v] = mesh.uvs().get(vertex).copied().unwrap_or_default();
    let [width, height] = texture.sizes_log2();
    // raw 2^exponent / 2^15 of the size, in 16 fraction bits: at most 2^15 texels.
    let scaled = |raw: i16, size: u8| Attribute::from_bits(i32::from(raw) << (1 + size + mesh.uv_exponent()));
    [scaled(u, width), scaled(v, height)]
}

/// Three texels as they are drawn: of one column, all are in it, as the sampler has it.
#[inline(always)]
fn columns(texture: &Texture<'_>, texels: [[Attribute; 2]; 3]) -> [[Attribute; 2]; 3] {
    let mask = if texture.width() == 1 { 0 } else { !0 };
    let column = |u: Attribute| Attribute::from_bits(u.to_bits() & mask);
    let [[au, av], [bu, bv], [cu, cv]] = texels;
    [[column(au), av], [column(bu), bv], [column(cu), cv]]
}

impl<'a, P: Pixel, C: Correction> Shader<'a, P> for Textured<'a, C> {
    type Pixel = Self;
    type Local = ();

    fn pixel(&self) -> Self {
        *self
    }

    fn local(&self, _: &Mesh<'_>, _: &Pose) {}

    fn vertex(&self, (): &(), mesh: &Mesh<'_>, vertex: usize) -> [Attribute; 2] {
        texel(&self.texture, mesh, vertex)
    }

    fn face(&self, (): &(), _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

impl<'a, P: Pixel, C: Correction> PixelShader<'a, P> for Textured<'a, C> {
    type Vertex = [Attribute; 2];
    type Varying = C::Varying;
    type Triangle = C::Triangle;
    type Simple = Textured<'a, Affine>;
    const PERSPECTIVE: bool = C::PERSPECTIVE;
    const SIMPLIFIES: bool = C::FINDS_AFFINE;
    const KERNELS: bool = C::KERNELS;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms { texture: self.texture, words: self.correction.words() }
    }

    #[inline]
    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
        Self { texture: uniforms.texture, correction: C::from_words(uniforms.words) }
    }

    #[inline]
    fn is_simple(words: [u32; 2], texels: [[Attribute; 2]; 3], inverses: [PerVertexInverse; 3]) -> bool {
        C::from_words(words).is_affine(texels, inverses)
    }

    #[inline]
    fn triangle(
        &self,
        _: [u8; 3],
        vertices: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
    ) -> (C::Triangle, [C::Varying; 3]) {
        let texels = columns(&self.texture, vertices);
        self.correction.triangle(texels, inverses, self.texture.sizes_log2())
    }

    #[inline]
    fn choose<D: DrawTriangle<'a, P>>(
        &self,
        _: [u8; 3],
        vertices: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        onto: D,
    ) -> D::Output {
        let Self { texture, correction } = *self;
        let onto = OntoTexels { texture, onto, pixel: PhantomData::<P> };
        correction.choose(columns(&texture, vertices), inverses, texture.sizes_log2(), onto)
    }

    #[inline(always)]
    fn shade<D: Depth>(
        &self,
        triangle: &C::Triangle,
        start: C::Varying,
        step: &C::Varying,
        run: Run<'_, P, D>,
    ) {
        run.visible(|skipped, pixels| {
            self.walk(triangle, after(start, step, skipped), step, pixels, Plain);
        });
    }

    #[inline(always)]
    fn for_kernel<'c>(
        &self,
        triangle: &C::Triangle,
        varying: Plane<C::Varying>,
        colours: &'c mut [P],
    ) -> Option<(&'c mut [u16], Shade<'a>)> {
        let Self { texture, correction } = *self;
        Some((P::words(colours)?, correction.for_kernel(texture, triangle, varying)?))
    }
}

/// What is linear, so many pixels after its start: at most runs' first pixel it is the start.
#[inline(always)]
fn after<V: Varying>(start: V, step: &V, pixels: i32) -> V {
    if pixels == 0 { start } else { start.plus(step.times(pixels)) }
}

/// Where a triangle of a texture is drawn, by whichever method.
struct OntoTexels<'a, P, D> {
    texture: Texture<'a>,
    onto: D,
    pixel: PhantomData<P>,
}

impl<'a, P: Pixel, D: DrawTriangle<'a, P>> DrawTexels for OntoTexels<'a, P, D> {
    type Output = D::Output;

    #[inline(always)]
    fn draw<C: Correction>(
        self,
        method: C,
        triangle: C::Triangle,
        varyings: [C::Varying; 3],
    ) -> Self::Output {
        self.onto.draw(Textured { texture: self.texture, correction: method }, triangle, varyings)
    }
}

/// The same, under the light of its vertices.
struct OntoLit<'a, P, D> {
    plain: OntoTexels<'a, P, D>,
    light: [Attribute; 3],
}

impl<'a, P: Pixel, D: DrawTriangle<'a, P>> DrawTexels for OntoLit<'a, P, D> {
    type Output = D::Output;

    #[inline(always)]
    fn draw<C: Correction>(
        self,
        method: C,
        triangle: C::Triangle,
        varyings: [C::Varying; 3],
    ) -> Self::Output {
        let Self { plain: OntoTexels { texture, onto, .. }, light } = self;
        let shader = LitTexturePixel(Textured { texture, correction: method });
        onto.draw(shader, triangle, under(varyings, light))
    }
}

/// Texels at three vertices, and the light there.
#[inline]
fn under<V>([a, b, c]: [V; 3], [p, q, r]: [Attribute; 3]) -> [(V, Attribute); 3] {
    [(a, p), (b, q), (c, r)]
}

impl<'a, P: Pixel, C: Correction> Shader<'a, P> for LitTexture<'a, C> {
    type Pixel = LitTexturePixel<'a, C>;
    type Local = LocalSun;

    fn pixel(&self) -> LitTexturePixel<'a, C> {
        LitTexturePixel(self.textured)
    }

    fn local(&self, _: &Mesh<'_>, pose: &Pose) -> LocalSun {
        self.sun.local(pose)
    }

    fn vertex(&self, sun: &LocalSun, mesh: &Mesh<'_>, vertex: usize) -> ([Attribute; 2], Attribute) {
        // 255 in 8 fraction bits is full light, and 64 steps are: 64 * 65536 / (255 * 256) = 64.25.
        let steps = sun.on_vertex(mesh, vertex) * 257 / 4 + (1 << 15);
        (texel(&self.textured.texture, mesh, vertex), Attribute::from_bits(steps.cast_signed()))
    }

    fn face(&self, _: &LocalSun, _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

/// The pixel half of [`LitTexture`].
#[derive(Clone, Copy, Debug)]
pub struct LitTexturePixel<'a, C>(Textured<'a, C>);

impl<'a, P: Pixel, C: Correction> PixelShader<'a, P> for LitTexturePixel<'a, C> {
    /// The texel, and light in 64 steps with a half for rounding.
    type Vertex = ([Attribute; 2], Attribute);
    type Varying = (C::Varying, Attribute);
    type Triangle = C::Triangle;
    type Simple = LitTexturePixel<'a, Affine>;
    const PERSPECTIVE: bool = C::PERSPECTIVE;
    const SIMPLIFIES: bool = C::FINDS_AFFINE;

    fn uniforms(&self) -> Uniforms<'a> {
        PixelShader::<P>::uniforms(&self.0)
    }

    #[inline]
    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
        Self(<Textured<'a, C> as PixelShader<'a, P>>::from_uniforms(uniforms))
    }

    #[inline]
    fn is_simple(words: [u32; 2], vertices: [Self::Vertex; 3], inverses: [PerVertexInverse; 3]) -> bool {
        let [(a, _), (b, _), (c, _)] = vertices;
        C::from_words(words).is_affine([a, b, c], inverses)
    }

    #[inline]
    fn triangle(
        &self,
        _: [u8; 3],
        vertices: [([Attribute; 2], Attribute); 3],
        inverses: [PerVertexInverse; 3],
    ) -> (C::Triangle, [(C::Varying, Attribute); 3]) {
        let (triangle, texels) = self.0.correction.triangle(
            columns(&self.0.texture, vertices.map(|vertex| vertex.0)),
            inverses,
            self.0.texture.sizes_log2(),
        );
        (triangle, under(texels, vertices.map(|vertex| vertex.1)))
    }

    #[inline]
    fn choose<D: DrawTriangle<'a, P>>(
        &self,
        _: [u8; 3],
        vertices: [([Attribute; 2], Attribute); 3],
        inverses: [PerVertexInverse; 3],
        onto: D,
    ) -> D::Output {
        let Self(Textured { texture, correction }) = *self;
        let plain = OntoTexels { texture, onto, pixel: PhantomData::<P> };
        let onto = OntoLit { plain, light: vertices.map(|vertex| vertex.1) };
        let texels = columns(&texture, vertices.map(|vertex| vertex.0));
        correction.choose(texels, inverses, texture.sizes_log2(), onto)
    }

    #[inline(always)]
    fn shade<D: Depth>(
        &self,
        triangle: &C::Triangle,
        start: (C::Varying, Attribute),
        step: &(C::Varying, Attribute),
        run: Run<'_, P, D>,
    ) {
        run.visible(|skipped, pixels| {
            let (start, light) = after(start, step, skipped);
            self.0.walk(triangle, start, &step.0, pixels, Lit(light, step.1));
        });
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::pixelcolor::Rgb565;

    use super::*;
    use crate::math::recip;
    use crate::shade::Affine;

    // Red when a texture of one column has others, in a triangle set up by itself.
    #[test]
    fn one_column_repeats() {
        let texels = [1, 2, 3, 4];
        let shader = Textured::new(&Texture::new(1, 4, &texels).unwrap(), Affine);
        let at = |u: i32, v: i32| [u, v].map(Attribute::from_num);
        let vertices = [at(7, -1), at(-2, 0), at(9, 5)];
        let inverses = [PerVertexInverse::new(recip::vertex(1)); 3];
        let ((), varyings) = PixelShader::<Rgb565>::triangle(&shader, [0; 3], vertices, inverses);
        let step = varyings[1].plus(varyings[0].times(-1));
        let mut colours = [Rgb565::from_texel(0); 6];
        shader.shade(&(), varyings[0], &step, Run::new(&mut colours));
        assert_eq!(colours, [4, 1, 2, 3, 4, 1].map(Rgb565::from_texel));
    }
}

//! Stage 7. Colours: light, texels, and their quantisation to RGB565. Code values throughout, no gamma.

use crate::matrix::{Vec3, dot};
use crate::setup::Cull;
use crate::varying::Method;
use topleft::{Texture, Wrap};

/// Red, green, blue in code values 0 to 255, not rounded.
pub type Rgb = [f64; 3];

/// An ambient light and one from a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The unit vector towards the light, in the mesh's own space.
    pub towards: Vec3,
    /// What every surface gets: 1 shows the base colour.
    pub ambient: f64,
    /// What a surface that faces the light gets besides.
    pub diffuse: f64,
}

impl Light {
    /// min(1, ambient + diffuse * max(0, n . l)).
    pub fn at(&self, normal: Vec3) -> f64 {
        (self.ambient + self.diffuse * dot(normal, self.towards).max(0.0)).min(1.0)
    }
}

/// A colour at a light of 0 to 1.
pub fn lit(colour: Rgb, light: f64) -> Rgb {
    colour.map(|channel| channel * light)
}

/// What colour a surface has before light.
#[derive(Clone, Copy, Debug)]
pub enum Base<'a> {
    /// One colour.
    Uniform([u8; 3]),
    /// The mesh's colour of each face.
    FaceColours,
    /// The mesh's colours of the vertices, interpolated.
    VertexColours,
    /// A texture at the mesh's coordinates.
    Texture(Texture<'a>),
}

/// Whose normals are lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normals {
    /// One light a face.
    Face,
    /// One light a vertex, interpolated.
    Vertex,
}

/// How a mesh is drawn.
///
/// The colour of a vertex is its base times its light, and is interpolated (Gouraud). A texel is multiplied by the
/// interpolated light.
#[derive(Clone, Copy, Debug)]
pub struct Look<'a> {
    /// The colour before light.
    pub base: Base<'a>,
    /// The light and whose normals it falls on, or full light everywhere.
    pub light: Option<(Light, Normals)>,
    /// How colours and light are carried.
    pub colours: Method,
    /// How texture coordinates are carried.
    pub texels: Method,
    /// What is left out.
    pub cull: Cull,
    /// Whether the depth buffer is tested and written.
    pub depth: bool,
}

impl Look<'_> {
    /// One colour without light, perspective-correct, back faces culled, with depth.
    pub fn flat(colour: [u8; 3]) -> Self {
        Self {
            base: Base::Uniform(colour),
            light: None,
            colours: Method::Perspective,
            texels: Method::Perspective,
            cull: Cull::Back,
            depth: true,
        }
    }
}

/// Stored texture coordinates in texels: `raw * 2^exponent / 32768` of the texture's size.
pub fn uv(raw: [i16; 2], exponent: u8, texture: &Texture<'_>) -> [f64; 2] {
    let repeats = raw.map(|value| f64::from(value) * f64::from(1_u32 << exponent) / 32_768.0);
    [repeats[0] * f64::from(texture.width()), repeats[1] * f64::from(texture.height())]
}

/// The nearest texel at coordinates in texels: column and row rounded down, then wrapped or clamped.
pub fn texel(texture: &Texture<'_>, uv: [f64; 2]) -> u16 {
    let place = |value: f64, size: u16| {
        let (index, size) = (value.floor() as i64, i64::from(size));
        match texture.wrap() {
            Wrap::Repeat => index.rem_euclid(size) as usize,
            Wrap::Clamp => index.clamp(0, size - 1) as usize,
        }
    };
    let (column, row) = (place(uv[0], texture.width()), place(uv[1], texture.height()));
    texture.texels()[row * usize::from(texture.width()) + column]
}

/// An RGB565 word as code values: red and blue are c * 255 / 31, green c * 255 / 63, not rounded.
pub fn from_rgb565(word: u16) -> Rgb {
    let channel = |shift: u32, most: u16| f64::from(word >> shift & most) * 255.0 / f64::from(most);
    [channel(11, 31), channel(5, 63), channel(0, 31)]
}

/// Code values as an RGB565 word: a channel c becomes round(c * 31 / 255), green round(c * 63 / 255), ties up, limited
/// to what the bits hold.
pub fn to_rgb565(colour: Rgb) -> u16 {
    let channel = |value: f64, most: f64| (value * most / 255.0).round().clamp(0.0, most) as u16;
    channel(colour[0], 31.0) << 11 | channel(colour[1], 63.0) << 5 | channel(colour[2], 31.0)
}

/// Code values as bytes: rounded to nearest, ties up, limited to 0 to 255.
pub fn to_rgb888(colour: Rgb) -> [u8; 3] {
    colour.map(|value| value.round().clamp(0.0, 255.0) as u8)
}

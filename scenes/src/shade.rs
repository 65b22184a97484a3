//! How an object looks, and the ways to shade it: each a shader type of its own.

use topleft::{
    Affine, Flat, Gouraud, Length, Material, PerPixel, Pixel, Subspans, Sun, Texture, Textured, Within,
};

/// What an object is made of.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Its colour under full light.
    pub material: Material,
    /// Its texture, for the ways of shading that show one.
    pub texture: Texture<'static>,
    /// How it is shaded unless the caller says otherwise.
    pub shade: Shade,
    /// How its texels are found unless the caller says otherwise.
    pub method: Method,
}

/// A way to shade an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// One colour a face, without light.
    Plain,
    /// One colour a face, by the face's light.
    Flat,
    /// A colour a vertex, by the vertex's light.
    Gouraud,
    /// The texture as it is.
    Textured,
    /// The texture under the vertices' light.
    Lit,
}

impl Shade {
    /// All ways, in the order of what they cost.
    pub const ALL: [Self; 5] = [Self::Plain, Self::Flat, Self::Gouraud, Self::Textured, Self::Lit];

    /// The name on a command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Flat => "flat",
            Self::Gouraud => "gouraud",
            Self::Textured => "textured",
            Self::Lit => "lit",
        }
    }
}

/// How texels are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Without perspective.
    Affine,
    /// The cheapest way that is within a quarter of a texel.
    Within,
    /// With a reciprocal every 16 pixels.
    Subspans,
    /// With a reciprocal a pixel.
    PerPixel,
}

impl Method {
    /// All methods, in the order of what they cost.
    pub const ALL: [Self; 4] = [Self::Affine, Self::Within, Self::Subspans, Self::PerPixel];

    /// The name on a command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Affine => "affine",
            Self::Within => "within",
            Self::Subspans => "subspans",
            Self::PerPixel => "per-pixel",
        }
    }
}

/// A sun above the viewer's left shoulder.
pub fn sun() -> Sun {
    const TOWARDS: [Length; 3] = [Length::lit("-0.5"), Length::lit("0.9"), Length::lit("0.7")];
    Sun::new(TOWARDS)
}

/// Calls back with the shader for a way of shading: each is a type of its own.
pub(crate) trait WithShader<'a, P> {
    type Output;

    fn with<S: topleft::stages::Shader<'a, P>>(self, shader: &S) -> Self::Output;
}

impl Look {
    pub(crate) fn shader<'a, P: Pixel, W: WithShader<'a, P>>(
        &self,
        shade: Shade,
        method: Method,
        with: W,
    ) -> W::Output {
        let texture: Texture<'a> = self.texture;
        match (shade, method) {
            (Shade::Plain, _) => with.with(&Flat::new(self.material)),
            (Shade::Flat, _) => with.with(&Flat::new(self.material).lit_by(&sun())),
            (Shade::Gouraud, _) => with.with(&Gouraud::new(&sun(), &self.material)),
            (Shade::Textured, Method::Affine) => with.with(&Textured::new(&texture, Affine)),
            (Shade::Textured, Method::Within) => with.with(&Textured::new(&texture, Within::default())),
            (Shade::Textured, Method::Subspans) => with.with(&Textured::new(&texture, Subspans::Of16)),
            (Shade::Textured, Method::PerPixel) => with.with(&Textured::new(&texture, PerPixel)),
            (Shade::Lit, Method::Affine) => with.with(&Textured::new(&texture, Affine).lit_by(&sun())),
            (Shade::Lit, Method::Within) => {
                with.with(&Textured::new(&texture, Within::default()).lit_by(&sun()))
            }
            (Shade::Lit, Method::Subspans) => {
                with.with(&Textured::new(&texture, Subspans::Of16).lit_by(&sun()))
            }
            (Shade::Lit, Method::PerPixel) => with.with(&Textured::new(&texture, PerPixel).lit_by(&sun())),
        }
    }
}

//! Shaded, textured, depth-tested triangles for microcontroller displays.
#![no_std]
#![cfg_attr(not(test), deny(clippy::disallowed_types, clippy::float_arithmetic))]

mod math;

mod mesh;
mod blob;
mod texture;

mod viewport;
mod pose;
mod camera;
mod point;

mod attributes;
mod snapped;
mod transform;
mod clip;

mod gradients;
mod varying;
mod setup;
mod raster;
mod depth;
mod pixel;
mod shade;

mod pipeline;
mod target;
mod list;
mod triangle;

pub use blob::{Aligned, BlobError};
pub use camera::{Camera, MatrixCamera, Orthographic, Perspective};
pub use depth::{Depth, Depth16, NoDepth};
pub use list::{DrawError, DrawList, ListStorage, ListTriangle, Stats};
pub use math::format::{Attribute, Coord, DepthCode, Inverse, Length};
pub use math::matrix::Matrix;
pub use math::turn::Turn;
pub use mesh::{MAX_UV_EXPONENT, MAX_VERTICES, Mesh, MeshError};
pub use pixel::Pixel;
pub use point::{Point, point};
pub use pose::Pose;
pub use raster::{BoxWalk, Spans};
pub use setup::Cull;
pub use shade::{Affine, Flat, Gouraud, LitTexture, Material, PerPixel, Sun, Textured};
pub use target::{Strip, StripError};
pub use texture::{MAX_TEXTURE_SIZE, Texture, TextureError, Wrap};
pub use triangle::ShadedTriangle;
pub use viewport::{TooLarge, Viewport};

/// The stages themselves, for shaders of your own and for tests.
pub mod stages {
    pub use crate::attributes::{Attributes, Fraction, Words};
    pub use crate::gradients::{Gradients, Plane};
    pub use crate::raster::{Span, Traversal, Window};
    pub use crate::setup::Setup;
    pub use crate::shade::{Correction, PixelShader, Shader, Uniforms};
    pub use crate::snapped::Snapped;
    pub use crate::transform::PerVertexInverse;
    pub use crate::varying::Varying;
}

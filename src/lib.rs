//! Shaded, textured, depth-tested triangles for microcontroller displays.
#![no_std]

mod math;

mod mesh;
mod texture;

pub use math::format::{Attribute, Clip, Coord, DepthCode, Inverse, Length};
pub use mesh::{MAX_UV_EXPONENT, MAX_VERTICES, Mesh, MeshError};
pub use texture::{MAX_TEXTURE_SIZE, Texture, TextureError, Wrap};

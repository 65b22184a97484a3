//! Any input is legal: nothing panics, overflows or hangs, and what is drawn is what is visible.
//!
//! The test profile checks every overflow and every assertion.
#![allow(clippy::disallowed_types, reason = "floats are inputs here, and the reference computes with them")]

#[path = "../support/mod.rs"]
mod support;

mod counting;
mod edges;
mod flat;

mod colour_errors;
mod triangles;
mod meshes;
mod full_list;
mod behind_the_eye;

use topleft::Texture;

static TEXELS: [u16; 8] = [1, 2, 3, 4, 5, 6, 7, 0xFFFF];

/// A texture that is wider than high.
fn texture() -> Texture<'static> {
    Texture::new(4, 2, &TEXELS).unwrap()
}

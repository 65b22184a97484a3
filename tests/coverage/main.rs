//! Promise 1: coverage is the exact answer, and every pixel belongs to exactly one triangle.
//!
//! Everything here is equality: spans against 128-bit integers, hits against winding numbers.
#![expect(
    clippy::disallowed_types,
    reason = "views are given in floats, to the library and to the reference alike"
)]

#[path = "../support/mod.rs"]
mod support;

mod drawings;
mod fans;
mod meshes;
mod triangles;
mod winding;

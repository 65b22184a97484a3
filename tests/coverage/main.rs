//! Promise 1: coverage is the exact answer, and every pixel belongs to exactly one triangle.
//!
//! Everything here is equality: spans against 128-bit integers, hits against winding numbers.
#![expect(clippy::disallowed_types, reason = "cameras are given in floats")]

#[path = "../support/mod.rs"]
mod support;

mod drawings;
mod fans;
mod many;
mod meshes;
mod triangles;

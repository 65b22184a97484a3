//! The library against the `f64` and `i128` reference, stage by stage and scene by scene.
//!
//! What may differ is in `support/tolerance.rs`, derived; each test prints its worst case beside the bound
//! (`cargo test --test against_reference -- --nocapture`).
#![allow(clippy::disallowed_types, reason = "the reference computes with floats")]

#[path = "../support/mod.rs"]
mod support;

mod random;
mod probe;
mod patches;

mod numbers;
mod light;
mod colour;
mod texture;
mod interpolation;
mod vertices;
mod depth;
mod methods;
mod texels;
mod frames;

use support::{measured, tolerance};

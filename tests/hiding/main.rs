//! What hides what without a depth buffer: convex meshes, painter's order, and the cheapest way that is safe.
#![allow(clippy::disallowed_types, reason = "cameras are given in floats, and distances compared in them")]

#[path = "../support/mod.rs"]
mod support;

mod solids;

mod cheapest;
mod convex;
mod slivers;
mod sorted;

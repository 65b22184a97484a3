//! An outsider's displays: anywhere on the plane, cropped, translated, empty, one pixel wide, and failing.
//!
//! The strict display panics where a pixel outside its box is sent, or a fill brings too few colours or too many.
#![expect(clippy::disallowed_types, reason = "points are given in floats")]

#[path = "../support/mod.rs"]
mod support;

mod colours;
mod lists;
mod triangles;

//! Vertices that are on the screen already: the same bytes as by mesh and camera, exact coverage as far as the guard
//! rectangle, and nothing but an error or a figure for what cannot be drawn.

#[path = "../support/mod.rs"]
mod support;

mod same_bytes;
mod coverage;
mod any_input;
mod errors;
mod in_order;

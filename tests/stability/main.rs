//! Where methods fail: for each failure an input around its worst case, the naive method shown to fail on it with its
//! figure, and the library within its bound. `docs/stability.md` walks through them.
#![allow(clippy::disallowed_types, reason = "the reference computes with floats")]

#[path = "../support/mod.rs"]
mod support;

#[path = "../against_reference/probe.rs"]
#[allow(dead_code, reason = "one function of it is used")]
mod probe;
#[path = "../against_reference/random.rs"]
#[allow(dead_code, reason = "`probe` uses it")]
mod random;

#[path = "../any_input/edges.rs"]
mod edges;

mod carried;
mod figure;
mod planes;

mod clipping;
mod coverage;
mod depth;
mod input_range;
mod inverse;
mod order;
mod origin;
mod perspective;
mod slivers;
mod textures;
mod time;

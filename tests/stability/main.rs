//! Where methods fail: for each failure an input around its worst case, the naive method shown to fail on it with its
//! figure, and the library within its bound. `docs/stability.md` walks through them.
#![allow(clippy::disallowed_types, reason = "the reference computes with floats")]

#[path = "../support/mod.rs"]
mod support;

mod figure;

mod coverage;

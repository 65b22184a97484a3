//! How results are compared: the library's own tests do it the same way.
#![allow(dead_code, reason = "the tests use more of it")]

#[path = "../../tests/support/counter.rs"]
pub(crate) mod counter;
#[path = "../../tests/support/difference.rs"]
mod difference;
#[path = "../../tests/support/exact.rs"]
pub(crate) mod exact;
#[path = "../../tests/support/frame.rs"]
pub(crate) mod frame;
#[path = "../../tests/support/polygons.rs"]
pub(crate) mod polygons;
#[path = "../../tests/support/stats.rs"]
pub(crate) mod stats;
#[path = "../../tests/support/tolerance.rs"]
pub(crate) mod tolerance;
#[path = "../../tests/support/winding.rs"]
pub(crate) mod winding;

pub(crate) use difference::same;

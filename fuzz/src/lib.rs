//! What the fuzz targets do with their inputs, as functions that a test can call too. Each panics where a property does
//! not hold; what is compared, and how, is the library's own tests' (`tests/support`).

mod blob;
mod cut;
mod frame;
mod lens;
mod numbers;
mod picture;
mod soup;
mod support;
mod triangle;

pub use blob::check_blob;
pub use frame::Frame;
pub use triangle::Case;

#[path = "../../tests/any_input/counting.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod counting;
#[path = "../../tests/any_input/edges.rs"]
mod edges;
#[path = "../../tests/any_input/flat.rs"]
mod flat;

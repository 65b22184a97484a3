//! Stage 8. Where runs of colour go: a strip of rows, a whole frame, or straight to a display.

mod display;
mod strip;

pub(crate) use display::Display;
pub(crate) use strip::Rows;
pub use strip::{Strip, StripError};

//! What is shown on the panel, and when; and the board that shows it.
//!
//! `show`, `shown` and `label` know of no chip, so a host draws the same with them.
#![no_std]

#[cfg(target_os = "none")]
pub mod chip;
mod label;
mod show;
mod shown;

pub use label::{Cells, label};
pub use show::{Memory, PANEL, STRIP_CELLS, STRIP_ROWS, Show, TRIANGLES, WORDS};
pub use shown::{Shown, strips};

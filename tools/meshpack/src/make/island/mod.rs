//! An island on a round board: land, the sea round it, a lighthouse, what stands on the land, and boats.
//!
//! A unit is the board's radius, and the sea is at y = 0. The counts of the files below are what the scene costs: a row
//! more anywhere is a few dozen triangles.

mod boats;
mod land;
mod lighthouse;
mod props;
mod sea;

pub(super) use boats::make as boats;
pub(super) use land::make as land;
pub(super) use lighthouse::make as lighthouse;
pub(super) use props::make as props;
pub(super) use sea::make as sea;

use super::surface::corner;
use crate::model::{Corner, Welder};

/// A corner whose vertex has the mean normal of its faces, whatever these are.
fn plain(position: [f64; 3]) -> Corner {
    Corner { normal: None, ..corner(position, [0.0; 3], None) }
}

/// A face of one colour.
fn face(welder: &mut Welder, corners: [[f64; 3]; 3], colour: [u8; 3]) {
    welder.face(corners.map(plain), Some(colour));
}

/// Four corners, counter-clockwise as seen from outside, as two faces.
fn quad(welder: &mut Welder, [a, b, c, d]: [[f64; 3]; 4], colour: [u8; 3]) {
    face(welder, [a, b, c], colour);
    face(welder, [a, c, d], colour);
}

/// A number from -1 to 1 without a pattern that the eye would find.
fn noise(place: usize, salt: usize) -> f64 {
    let mixed = (place as u32).wrapping_mul(0x9E37_79B1) ^ (salt as u32).wrapping_mul(0x85EB_CA77);
    let value = (mixed ^ mixed >> 15).wrapping_mul(0x2C1B_3C6D);
    f64::from(value >> 16) / 32_768.0 - 1.0
}

/// From a number in 0 to 1, its place between colours that stand in the order of theirs.
fn blend(steps: &[(f64, [u8; 3])], at: f64) -> [u8; 3] {
    let next = steps.iter().position(|(top, _)| at < *top).unwrap_or(steps.len() - 1).max(1);
    let ((low, from), (high, to)) = (steps[next - 1], steps[next]);
    let share = ((at - low) / (high - low)).clamp(0.0, 1.0);
    std::array::from_fn(|c| {
        (f64::from(from[c]) + (f64::from(to[c]) - f64::from(from[c])) * share).round() as u8
    })
}

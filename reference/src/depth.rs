//! Stage 6. The depth buffer: 16-bit codes, greater is nearer, cleared to 0.

/// What a cleared pixel holds. Every surface between near and far is nearer.
pub const CLEAR: u16 = 0;

/// The code that a pixel stores: the depth of [`crate::transform::depth`] rounded down, limited to 0 to 65535.
pub fn code(depth: f64) -> u16 {
    // The cast saturates.
    depth.floor() as u16
}

/// Whether a new code replaces an old one: only when it is nearer. Of equals the first drawn stays.
pub fn passes(new: u16, old: u16) -> bool {
    new > old
}

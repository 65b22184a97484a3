//! From floats to pixels by a cast, and what is decided before it.

use crate::setup::Triangle;

/// A pixel coordinate in 1/256 px as `(pixels * 2^bits) as i32` makes it, with `bits` of the 8 sub-pixel bits: towards
/// zero, so that all pixels right of 0 are moved left and all left of it are moved right; what is not a number stands
/// in the corner, and what is infinite at the end of the range. Small libraries do this with 0 bits.
pub fn cast(pixels: f64, bits: u32) -> i32 {
    let steps = (pixels * f64::from(1_u32 << bits)) as i32;
    // Beyond 32 bits it is held once more, as its range is that of 1/256 px.
    steps.saturating_mul(1 << (8 - bits))
}

/// A coordinate in 1/256 px rounded to one of `bits` sub-pixel bits: 0 is whole pixels.
pub fn rounded(steps: i32, bits: u32) -> i32 {
    let unit = 1 << (8 - bits);
    (steps + unit / 2).div_euclid(unit) * unit
}

/// Twice the area of a triangle before it is snapped: its sign may be another than that of what is drawn.
pub fn area2_before([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// Twice the area in 32 bits: nothing where a difference or a product does not fit, which stops a debug build.
pub fn area2_in_32_bits(triangle: Triangle) -> Option<i32> {
    let [[ax, ay], [bx, by], [cx, cy]] = triangle;
    let product = |p: Option<i32>, q: Option<i32>| p?.checked_mul(q?);
    let left = product(bx.checked_sub(ax), cy.checked_sub(ay))?;
    left.checked_sub(product(cx.checked_sub(ax), by.checked_sub(ay))?)
}

/// A whole pixel as Q16.16 by a shift: right from -32 768 to 32 767, and elsewhere 65 536 px or more away. (An
/// embedded-3dgfx of 40 000 px; it also stopped a game's renderer at 2560 columns.)
pub fn shifted_by_16(pixels: i32) -> i32 {
    pixels.wrapping_shl(16)
}

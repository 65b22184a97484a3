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

/// `1 - z / w` at the far plane of a small float, and as far from 1 at the near one, in its 2^32 steps.
const FLOAT_FAR: f64 = 8192.0;

/// The code of a small float for `1 - z / w`, not rounded: an exponent of 4 bits above a mantissa of 12, whose leading one
/// is not kept. What is below the 15 octaves goes down to 0 in even steps.
///
/// What a pixel stores is [`code`] of it.
pub fn small_float(nearness: f64) -> f64 {
    let steps = FLOAT_FAR + nearness * (2.0_f64.powi(32) - 2.0 * FLOAT_FAR);
    let octave = steps.log2().floor().max(17.0);
    4096.0 * (octave - 17.0) + steps * 2.0_f64.powf(12.0 - octave)
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when an octave's codes do not go on where those below end, or the float is of another range.
    #[test]
    fn codes_of_small_floats_go_on_from_octave_to_octave() {
        assert_eq!([0.0, 1.0].map(small_float).map(code), [256, 65_535]);
        for octave in 18..32 {
            let edge = (2.0_f64.powi(octave) - FLOAT_FAR) / (2.0_f64.powi(32) - 2.0 * FLOAT_FAR);
            let [below, above] = [edge * (1.0 - 1e-9), edge * (1.0 + 1e-9)].map(small_float);
            assert!(below < above && above - below < 0.001, "{below} {above}");
        }
    }
}

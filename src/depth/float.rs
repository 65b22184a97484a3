//! A 16-bit depth as a small float: 4 bits of exponent and 12 of mantissa, of `1 - z / w`.

use super::buffer::Code;

/// A 16-bit depth buffer of small floats, for scenes in which far is more than some 30 times as far away as near.
///
/// [`Depth16`](super::Depth16) has all its precision near the eye; this one spreads it evenly. Of two surfaces at a distance of
/// w near planes the nearer is seen where they are `2^-12 w` apart, and beyond w of 2^15 where they are `2^-27 w²` apart;
/// `Depth16` asks for `w² / 65528`, which is more from w of 16 on. A pixel costs some 15 cycles more on a
/// Cortex-M0+, and 26 more than one that a kernel draws.
///
/// A code is a `u16`: 0 is cleared, greater is nearer, and of two that are equal the earlier stays. It is the exponent above
/// the mantissa without its leading one, rounded down, from 256 at the far plane to 65 535 at the near one. Below 2^-15
/// codes are 2^-27 apart, as small floats are that have no leading one.
///
/// The plane under it is off by at most `(n + m + 2) 2^-33 + 2^-27`, n columns and m rows from the triangle's first vertex.
/// Near the eye that is less than a hundredth of a code; where depths are below 2^-15 it is `1 + (n + m + 2) / 64` codes. It
/// comes to more than `2^-12 w` where w is beyond `2^21 / (n + m + 66)`.
///
/// ```
/// use embedded_graphics_core::geometry::Size;
/// use topleft::{DepthFloat, DrawList, Flat, Length, ListStorage, Material, Mesh, Perspective, Pose, Strip, Turn};
///
/// // Two triangles, 1001 and 1000 units away.
/// let corners = |z| [[-9000, -9000, z], [9000, -9000, z], [0, 9000, z]];
/// let positions = [corners(-33), corners(0)].concat();
/// let mesh = Mesh::new(&positions, &[[0, 1, 2], [3, 4, 5]])?.with_face_colours(&[[255, 0, 0], [255; 3]])?;
/// let camera = Perspective::new(Size::new(32, 32), Turn::from_degrees(50), 1.0..2000.0);
/// let pose = Pose::new().scaled(Length::lit("1000")).at([0, 0, -1000].map(Length::from_num));
///
/// let mut storage: ListStorage<64, 8> = ListStorage::new();
/// let (mut colours, mut depths) = ([0_u16; 32 * 32], [0; 32 * 32]);
/// let mut strip = Strip::new(32, &mut colours)?.with_depth_float(&mut depths)?;
/// strip.clear();
/// let mut list = storage.list::<_, DepthFloat>();
/// list.draw(&camera, &mesh, &pose, &Flat::new(Material::OfMesh))?;
/// list.render(0..32, &mut strip);
/// assert_eq!(strip.colours()[16 * 32 + 16], 0xFFFF); // with `Depth16` both have one code, and the first stays
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct DepthFloat;

impl Code for DepthFloat {
    // Inside a guard rectangle n + m is at most 9215: 4609 steps of 2^-32 that a plane is off by, 4 for the reciprocal of
    // the triangle's area, and 21 at its vertices.
    const MARGIN_BITS: u32 = 13;

    #[inline(always)]
    fn of(depth: u32) -> u32 {
        // A small core has no instruction that counts zeros, and doing it otherwise takes five times as long.
        let top = depth >> 24;
        let index = if top != 0 { top } else { 256 | (depth >> 16 & 255) };
        // The index is below 512: this is for the compiler, which then needs no panic path.
        let octave = u32::from(OCTAVES.get(index as usize).copied().unwrap_or_default());
        // The mantissa's leading one, where there is one, is added to the exponent.
        (depth >> 5 >> (octave >> 3)) + (octave << 9)
    }
}

/// Bits of a depth above the lowest 18, times 8: by its 8 highest; and where they are 0, by the 8 below them.
static OCTAVES: [u8; 512] = {
    let mut octaves = [0; 512];
    let mut i = 0;
    while i < 256 {
        let bits = (u32::BITS - (i as u32).leading_zeros()) as u8;
        octaves[i] = 8 * (bits + 6);
        octaves[256 + i] = 8 * bits.saturating_sub(2);
        i += 1;
    }
    octaves
};

#[cfg(test)]
mod tests {
    use super::super::Depth;
    use super::*;

    /// The least depth of a code.
    fn least(code: u32) -> u32 {
        match code >> 12 {
            0 => code << 5,
            exponent => (1 << 12 | code & 0xFFF) << (exponent + 4),
        }
    }

    // Red when an octave of either half of the table begins elsewhere, or a mantissa has a bit more or less.
    #[test]
    fn each_code_is_from_its_least_depth_to_that_of_the_next() {
        for code in 0..1 << 16 {
            assert_eq!(DepthFloat::of(least(code)), code);
            let most = if code == 0xFFFF { u32::MAX } else { least(code + 1) - 1 };
            assert_eq!(DepthFloat::of(most), code);
        }
    }

    // Red when codes fall where depths grow: `octave << 9`.
    #[test]
    fn codes_grow_with_depth() {
        let depths = || (0..=u32::MAX).step_by(4099);
        assert!(depths().zip(depths().skip(1)).all(|(a, b)| DepthFloat::of(a) <= DepthFloat::of(b)));
    }

    // Red when a margin is less than what interpolation may be off by.
    #[test]
    fn planes_do_not_cross_the_ends() {
        let [far, near] = [0, u32::MAX].map(|nearness| {
            let vertex = <DepthFloat as Depth>::vertex(|| nearness);
            <DepthFloat as Depth>::varying(vertex).to_bits()
        });
        assert_eq!([far, near].map(DepthFloat::of), [256, 65_535]);
        assert!(far > 4634 && near < u32::MAX - 4634);
        assert!(DepthFloat::of(far - 4634) >= 1);
    }
}

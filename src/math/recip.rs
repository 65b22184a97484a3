//! Reciprocals and roots. Elsewhere only edges divide: the slope of a shallow edge, and an edge that starts above its
//! window; and `Divided`, which is asked to.
//!
//! All of them are defined to the bit: a table, linear interpolation and Newton steps in integers, so that no chip's
//! divider can change a pixel. The names are the uses.
//!
//! | function | for | relative error | steps |
//! |---|---|---|---|
//! | [`pixel`] | texels, once a pixel | -2^-15 - 2^-16 to 2^-14 + 2^-16 | table and interpolation |
//! | [`vertex`] | perspective divide, once a vertex | -2^-27.9 | and one Newton step |
//! | [`area`] | gradients, once a triangle | ±2^-30 | and one more |
//! | [`small_area`] | the same for a small triangle | ±2^-30 | table, interpolation, and two terms of a series |
//! | [`short`] | the slope of a short edge, which corrects it | -2^-16 to 2^-14 + 2^-15 | table and interpolation |
//!
//! The chord of a convex function lies above it, by at most `f'' h^2 / 8 = 2 / 64^2 / 8 = 2^-14` between entries, and
//! entries have steps of 2^-16; a Newton step squares the error and leaves it below.

use super::product;

/// `round(2^16 / (1 + i / 64)) - 2^15`, so that the first entry fits too.
static TABLE: [u16; 65] = {
    let mut table = [0; 65];
    let mut i = 0;
    while i < table.len() {
        let denominator = 64 + i as u32;
        table[i] = (((64 << 17) / denominator).div_ceil(2) - 32_768) as u16;
        i += 1;
    }
    table
};

/// What [`short`] interpolates in.
#[inline(always)]
pub(crate) fn short_table() -> &'static [u16; 65] {
    &TABLE
}

/// A reciprocal with its power of two: see each function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Reciprocal {
    /// 2^30 to 2^31: one over the argument's 32 leading bits.
    pub(crate) mantissa: u32,
    /// The argument's leading zeros.
    pub(crate) shift: u32,
}

/// `2^47 / x` for `x` in [2^31, 2^32), in [2^15, 2^16]: the table and linear interpolation.
#[inline(always)]
fn seed(normalised: u32) -> u32 {
    let index = (normalised >> 25 & 63) as usize;
    let fraction = normalised >> 9 & 0xFFFF;
    // `index` is below 64: these are for the compiler, which then needs no panic path.
    let low = TABLE.get(index).copied().unwrap_or_default() as u32;
    let high = TABLE.get(index + 1).copied().unwrap_or_default() as u32;
    low + 32_768 - (((low - high) * fraction + 0x8000) >> 16)
}

/// Lines from `round(2^16 / (1 + i / 64))`, at most 2^16 - 1, to the next: where each begins at x = 0 in the high half of a
/// word, and how much it falls in a 64th in the low.
static PIXEL: [u32; 64] = {
    let mut table = [0; 64];
    let mut i = 0;
    while i < table.len() {
        let entry = if i == 0 { 0xFFFF } else { TABLE[i] as u32 + 32_768 };
        let fall = entry - (TABLE[i + 1] as u32 + 32_768);
        table[i] = (entry + i as u32 * fall) << 16 | fall;
        i += 1;
    }
    table
};

/// The lines themselves, for code that reads them as [`pixel`] does.
#[inline(always)]
pub(crate) const fn lines() -> &'static [u32; 64] {
    &PIXEL
}

/// `2^16 / (1 + x 2^-32)`, in [2^15, 2^16), from the 32 bits that follow the leading one of a number: the table in one
/// word, and linear interpolation rounded down.
///
/// What the low half adds to the high one is less than a 64th of its step.
#[inline(always)]
pub(crate) fn pixel(x: u32) -> u32 {
    pixel_of(&PIXEL, x)
}

/// The same for many: where the table is, is kept. A core that makes an address of two halves would do that for each.
#[inline(always)]
pub(crate) fn pixels() -> impl Fn(u32) -> u32 {
    let table = if product::NARROW { &PIXEL } else { core::hint::black_box(&PIXEL) };
    move |x| pixel_of(table, x)
}

#[inline(always)]
fn pixel_of(table: &[u32; 64], x: u32) -> u32 {
    // The index is below 64: this is for the compiler, which then needs no panic path.
    let word = table.get((x >> 26) as usize).copied().unwrap_or_default();
    (word - (word & 0xFFFF) * (x >> 10)) >> 16
}

/// `part / x` in 31 fraction bits, from the reciprocal of an x normalised to 32 bits and a part of it to 31.
#[inline(always)]
pub(crate) fn quotient(part: u32, reciprocal: u32) -> u32 {
    (part >> 15).wrapping_mul(reciprocal)
}

/// The leading zeros of a number that is not 0, sought from those of the number before: where numbers change little, that
/// is cheaper than counting on a core that cannot.
#[inline(always)]
pub(crate) fn normalising(q: u32, mut shift: u32) -> u32 {
    // Both loops end: a number that is not 0 has at most 31 leading zeros.
    let q = q.max(1);
    while q >> 1 >> (31 - shift) != 0 {
        shift -= 1;
    }
    while q << shift >> 31 == 0 {
        shift += 1;
    }
    shift
}

/// `2^(18 + shift) / height` in [2^15, 2^16], and that shift, 0 to 10, for a height from 4 to 2^13 - 1.
#[inline(always)]
pub(crate) fn short(height: u32) -> (u32, u32) {
    // Most heights are of some pixels: few steps.
    let (mut normalised, mut shift) = (height << 19, 10);
    while normalised >> 31 == 0 && shift > 0 {
        normalised <<= 1;
        shift -= 1;
    }
    (seed(normalised), shift)
}

/// `2^62 / (w << shift)`: exact for powers of two. A zero counts as one.
#[inline]
pub(crate) fn vertex(w: u32) -> Reciprocal {
    let w = w.max(1);
    // Most coordinates of a mesh are not much less than the largest.
    let shift = if product::NARROW { normalising(w, 2) } else { w.leading_zeros() };
    Reciprocal { mantissa: newton(w << shift), shift }
}

/// The reciprocal of a number whose highest bit is set, by one Newton step from the table.
#[inline(never)]
fn newton(normalised: u32) -> u32 {
    let seed = seed(normalised);
    // r' = r (2 - x r), with x r in 47 fraction bits: 2 - x r is about 1, and has 31 of them left.
    let complement = product::scaled(normalised, seed, 0xFFFF).wrapping_neg();
    product::scaled(complement, seed, 0)
}

/// `2^62 / (a << shift)` to the last bit or two, of the doubled area's 32 leading bits. A zero counts as one.
///
/// `shift` is negative where the area has more than 32 bits; it is rounded to nearest there.
#[inline(never)]
pub(crate) fn area(area2: u64) -> (u32, i32) {
    let area2 = area2.max(1);
    let shift = product::leading_zeros(area2) as i32 - 32;
    // Most triangles have less than 2^16 px²: no shift of 64 bits for those.
    let (normalised, shift) = if shift >= 0 {
        ((area2 as u32) << shift, shift)
    } else {
        let rounded = (area2 >> (-shift - 1)).wrapping_add(1) >> 1;
        if rounded >> 32 == 0 { (rounded as u32, shift) } else { (1 << 31, shift - 1) }
    };
    let first = newton(normalised);
    // The second Newton step as a correction: what is missing from x r = 2^62, times r. It is below 2^36, and not negative.
    let missing = (1 << 62) - product::unsigned(normalised, first);
    let correction = product::unsigned((missing >> 8) as u32, first) >> 54;
    (first + correction as u32, shift)
}

/// A number that is not 0 without its leading zeros, and how many they were.
#[inline(always)]
fn normalised(x: u32) -> (u32, u32) {
    if product::NARROW { normalised_by_steps(x) } else { (x << x.leading_zeros(), x.leading_zeros()) }
}

/// The same for a core that cannot count zeros: most areas of small triangles have from 7 to 15.
#[inline(always)]
fn normalised_by_steps(x: u32) -> (u32, u32) {
    let (mut x, mut zeros) = (x, 0);
    if x >> 25 == 0 {
        (x, zeros) = (x << 7, 7);
    }
    if x >> 24 == 0 {
        (x, zeros) = (x << 8, zeros + 8);
    }
    while x >> 31 == 0 && zeros < 31 {
        (x, zeros) = (x << 1, zeros + 1);
    }
    (x, zeros)
}

/// [`area`] of an area below 2^32, with products of 32 bits. A zero counts as one.
#[inline]
pub(crate) fn small_area(area2: u32) -> (u32, i32) {
    let (normalised, shift) = normalised(area2.max(1));
    let seed = seed(normalised).cast_signed();
    // With e the part that is missing from x r = 2^47, the reciprocal is r (1 + e + e^2), and 2^-40 of it more. Steps of e
    // are 2^-28, and its halves are below 2^14.7 and 2^10.
    let (upper, lower) =
        ((normalised >> 16) * seed.cast_unsigned(), (normalised & 0xFFFF) * seed.cast_unsigned());
    // In steps of 2^-38, rounded down, of which 32 bits are enough: 2^47 is 0 there.
    let missing = 0_u32.wrapping_sub(upper << 7).wrapping_sub((lower + 511) >> 9).cast_signed();
    let (high, low) = (missing >> 10, missing & 0x3FF);
    let first = (seed * high + ((seed * low) >> 10)) >> 13;
    let second = (seed * ((high * high) >> 16)) >> 25;
    // Both were rounded down: up to two steps are missing, and one is added.
    let reciprocal = (seed.cast_unsigned() << 15).wrapping_add_signed(first + second + 1);
    (reciprocal.min(1 << 31), shift as i32)
}

/// A vector scaled to length 1, in 30 fraction bits, within ±2^-28. The zero vector stays.
pub(crate) fn normalise(vector: [i32; 3]) -> [i32; 3] {
    let largest = vector.iter().fold(0, |most, c| most.max(c.unsigned_abs()));
    let Some(zeros) = largest.checked_ilog2().map(|bits| 30 - bits as i32) else { return [0; 3] };
    // 30 bits a component: the squares of three fit.
    let scaled = vector.map(|c| if zeros >= 0 { c << zeros } else { c >> -zeros });
    let squares = scaled.iter().fold(0, |sum, &c| sum + product::signed(c, c).unsigned_abs());
    // 2^62 / length, for a length in [2^30, 2^32): a vector with a component in [2^30, 2^31).
    let (mantissa, shift) = area(root(squares).max(1));
    scaled.map(|c| {
        let size = (product::unsigned(c.unsigned_abs(), mantissa) << shift.clamp(0, 1)).cast_signed();
        (((if c < 0 { -size } else { size }) + (1 << 31)) >> 32) as i32
    })
}

/// The square root, rounded down: bit by bit, once a normal. The one of `core` links a division of 64 bits.
fn root(square: u64) -> u64 {
    let (mut root, mut rest) = (0, square);
    for place in (0..32).rev() {
        let bit = 1 << (2 * place);
        let more = root + bit;
        root >>= 1;
        if rest >= more {
            (rest, root) = (rest - more, root + bit);
        }
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every input at the table's knots and halfway, and a pseudo-random walk between.
    fn inputs() -> impl Iterator<Item = u32> {
        let knots = (0..128).map(|i| (1 << 31) + (i << 24));
        let walk = (1_u64..200_000).map(|i| (1 << 31) | (i.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 33) as u32);
        knots.chain(walk)
    }

    // Red when a bit is left out, or the rest is not taken along.
    #[test]
    fn a_root_is_rounded_down() {
        let squares = (0..10_000).map(|k| u64::from(u32::MAX) - k).map(|root| root * root);
        for square in squares.chain(0..10_000).chain([u64::MAX, u64::MAX >> 1]) {
            for square in [square.saturating_sub(1), square, square.saturating_add(1)] {
                assert_eq!(root(square), square.isqrt(), "{square}");
            }
        }
    }

    // Red when an entry is not rounded to nearest, or its difference is another's.
    #[test]
    fn pixel_is_within_the_chord_and_a_step() {
        for x in inputs() {
            let r = pixel(x << 1);
            // x r = 2^47 (1 + e). An entry is rounded by half a step of r, the first by one, and the interpolation by
            // one; the chord lies up to 2^-14 above, and what the low half adds by a 64th of a step.
            let (product, step) = (u64::from(x) * u64::from(r), u64::from(x));
            let down = if x >> 25 & 63 == 0 { 2 * step } else { 3 * step / 2 };
            assert!(product >= (1 << 47) - down, "{x:#x}: {product:#x} is too low");
            assert!(
                product <= (1 << 47) + (1 << 33) + step / 2 + step / 64,
                "{x:#x}: {product:#x} is too high"
            );
        }
    }

    // Red when either loop stops a bit early.
    #[test]
    fn the_shift_follows_any_number() {
        let mut following = 1;
        for (i, x) in inputs().enumerate() {
            let q = x >> (i * 7 % 33).min(31);
            following = normalising(q, following);
            assert_eq!(following, q.max(1).leading_zeros(), "{q:#x}");
        }
    }

    // Red when a step is too long, or the loop stops early.
    #[test]
    fn steps_find_all_leading_zeros() {
        for (i, x) in inputs().enumerate() {
            let x = x >> (i * 7 % 32);
            assert_eq!(normalised_by_steps(x), (x << x.leading_zeros(), x.leading_zeros()), "{x:#x}");
        }
    }

    #[test]
    fn vertex_is_below_by_at_most_the_square_and_exact_for_powers_of_two() {
        for x in inputs() {
            let r = vertex(x);
            let product = u64::from(x) * u64::from(r.mantissa);
            // The seed is off by at most 2^-14 + 2 steps of 2^-16 = 1.5 * 2^-14; squared, and two truncations.
            let square = (1_u64 << 62) >> 28;
            assert!(product <= 1 << 62, "{x:#x}");
            assert!((1 << 62) - product <= square * 9 / 4 + 3 * (1 << 32), "{x:#x}");
        }
        for bit in 0..32 {
            assert_eq!(vertex(1 << bit), Reciprocal { mantissa: 1 << 31, shift: 31 - bit });
        }
        assert_eq!(vertex(0), vertex(1));
    }

    #[test]
    fn area_is_within_2_to_the_minus_30() {
        for x in inputs() {
            for shift in [0, 5, 31] {
                let (r, normalised) = area(u64::from(x >> shift));
                let exact = u64::from(x >> shift) << normalised;
                let product = u128::from(exact) * u128::from(r);
                assert!(product.abs_diff(1 << 62) <= 1 << 32, "{x:#x} >> {shift}");
            }
            let wide = u64::from(x) << 8 | 0x5A;
            let (r, shift) = area(wide);
            let product = (u128::from(wide) * u128::from(r)) >> -shift;
            assert!(product.abs_diff(1 << 62) <= 1 << 32, "{x:#x} wide");
        }
        assert_eq!(area(u64::from(u32::MAX) << 8 | 0xFF), (1 << 31, -9), "rounding up to the next power");
    }

    // Red without the square, or when a half is taken with another sign or place.
    #[test]
    fn a_small_area_is_within_2_to_the_minus_30() {
        for x in inputs() {
            for shift in [0, 5, 31] {
                let (r, normalised) = small_area(x >> shift);
                let exact = u64::from(x >> shift) << normalised;
                let product = u128::from(exact) * u128::from(r);
                // A step of r and the cube.
                assert!(product.abs_diff(1 << 62) <= (1 << 32) + (1 << 23), "{x:#x} >> {shift}: {r:#x}");
            }
        }
        assert_eq!(small_area(0), small_area(1));
    }

    #[test]
    fn a_normalised_vector_has_length_one() {
        for v in [[1, 0, 0], [3, -4, 12], [i32::MAX, i32::MIN, 1], [-70_000, 70_000, 70_000], [5, 5, 5]] {
            let n = normalise(v);
            let squares: i64 = n.iter().map(|&c| i64::from(c) * i64::from(c)).sum();
            // Each component is within 4 steps of 2^-30 of a unit vector: the square is off by 2 * sqrt(3) * 4 steps.
            assert!((squares - (1 << 60)).abs() <= 14 << 30, "{v:?} {n:?} {squares:#x}");
            assert!(v.iter().zip(n).all(|(&a, b)| a.signum() == b.signum() || b == 0));
        }
        assert_eq!(normalise([0; 3]), [0; 3]);
    }
}

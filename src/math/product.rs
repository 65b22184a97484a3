//! Products of 32 bits in 64, shifts of them, and zeros before them; and quotients of 32 bits.
//!
//! A Cortex-M0+ multiplies 32 bits into the low 32, and would call for a product of 64 bits by 64: four products of 16
//! bits take half the time. A shift of 64 bits would be a call as well, and so would be a division, of 400 bytes, and a count
//! of zeros, of 100. Chips that have the instructions use them. The result is the same.

use core::num::NonZeroU32;

/// Chips of Arm without compare-and-swap are those without `umull`: ARMv6-M.
pub(crate) const NARROW: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// `a * b`, unsigned.
#[inline(always)]
pub(crate) fn unsigned(a: u32, b: u32) -> u64 {
    if NARROW { by_halves(a, b) } else { u64::from(a) * u64::from(b) }
}

/// `a * b`, signed.
#[inline(always)]
pub(crate) fn signed(a: i32, b: i32) -> i64 {
    if NARROW { signed_by_halves(a, b) } else { i64::from(a) * i64::from(b) }
}

/// `(a * b + rounding) / 2^16` modulo 2^32, for a `b` of at most 2^16 and a rounding of less.
#[inline(always)]
pub(crate) fn scaled(a: u32, b: u32, rounding: u32) -> u32 {
    if NARROW {
        scaled_by_halves(a, b, rounding)
    } else {
        ((u64::from(a) * u64::from(b) + u64::from(rounding)) >> 16) as u32
    }
}

/// `(a * b - less) >> by`, of products that are at least `less`, which is 0 or 1, and below 2^63: for a `by` below 64.
#[inline(always)]
pub(crate) fn unsigned_down(a: u32, b: u32, less: u32, by: u32) -> u32 {
    if !NARROW {
        return down(unsigned(a, b) - u64::from(less), by);
    }
    let high = if by < 32 { None } else { high_by_halves(a, b, less, by & 31) };
    high.unwrap_or_else(|| whole_down(a, b, less, by))
}

/// The low half of `x >> by`, for a `by` below 64.
#[inline(always)]
pub(crate) fn down(x: u64, by: u32) -> u32 {
    if NARROW { down_by_words(x, by) } else { (x >> by) as u32 }
}

/// `x << by`, for a `by` below 32.
#[inline(always)]
pub(crate) fn up(x: u64, by: u32) -> u64 {
    if NARROW { up_by_words(x, by) } else { x << by }
}

/// Zeros before the highest bit.
#[inline(always)]
pub(crate) const fn leading_zeros(x: u64) -> u32 {
    if NARROW { zeros_by_steps(x) } else { x.leading_zeros() }
}

/// A step for each zero of a word: what is counted has few.
#[inline(never)]
const fn zeros_by_steps(x: u64) -> u32 {
    let high = (x >> 32) as u32;
    let (mut word, mut zeros) = if high == 0 { (x as u32, 32) } else { (high, 0) };
    while word >> 31 == 0 && zeros < 64 {
        // It stays a loop.
        core::hint::black_box(());
        (word, zeros) = (word << 1, zeros + 1);
    }
    zeros
}

/// Quotient, rounded down, and remainder.
#[inline(always)]
pub(crate) fn divided(dividend: u32, divisor: NonZeroU32) -> (u32, u32) {
    if NARROW { divided_by_bits(dividend, divisor) } else { (dividend / divisor, dividend % divisor) }
}

/// As many steps as the quotient has bits: most have few.
#[inline(never)]
fn divided_by_bits(dividend: u32, divisor: NonZeroU32) -> (u32, u32) {
    let (mut rest, mut part, mut bit, mut quotient) = (dividend, divisor.get(), 1, 0);
    while part <= rest >> 1 {
        (part, bit) = (part << 1, bit << 1);
    }
    while bit != 0 {
        if rest >= part {
            (rest, quotient) = (rest - part, quotient | bit);
        }
        (part, bit) = (part >> 1, bit >> 1);
    }
    (quotient, rest)
}

#[inline(always)]
const fn scaled_by_halves(a: u32, b: u32, rounding: u32) -> u32 {
    // Both are less than 2^32.
    ((a >> 16) * b).wrapping_add(((a & 0xFFFF) * b + rounding) >> 16)
}

#[inline(never)]
fn whole_down(a: u32, b: u32, less: u32, by: u32) -> u32 {
    down(unsigned(a, b) - u64::from(less), by)
}

/// `(a * b - less) >> (32 + by)`, if it does not depend on the product of the low halves: as most do not, where `by` is some
/// bits.
#[inline(always)]
const fn high_by_halves(a: u32, b: u32, less: u32, by: u32) -> Option<u32> {
    let (a_low, a_high, b_low, b_high) = (a & 0xFFFF, a >> 16, b & 0xFFFF, b >> 16);
    // Three parts were rounded down: two whole ones may be missing.
    let high = a_high * b_high + ((a_high * b_low) >> 16) + ((a_low * b_high) >> 16);
    let (least, most) = (high.wrapping_sub(less) >> by, (high + 2) >> by);
    if least == most { Some(least) } else { None }
}

#[inline(always)]
const fn down_by_words(x: u64, by: u32) -> u32 {
    let (low, high) = (x as u32, (x >> 32) as u32);
    if by < 32 { low >> by | high << 1 << (31 - by) } else { high >> (by & 31) }
}

#[inline(always)]
fn up_by_words(x: u64, by: u32) -> u64 {
    let (low, high, by) = (x as u32, (x >> 32) as u32, by & 31);
    u64::from(high << by | low >> 1 >> (31 - by)) << 32 | u64::from(low << by)
}

#[inline(never)]
fn by_halves(a: u32, b: u32) -> u64 {
    let ([a_low, a_high], [b_low, b_high]) = ([a & 0xFFFF, a >> 16], [b & 0xFFFF, b >> 16]);
    let (middle, carry) = (a_high * b_low).overflowing_add(a_low * b_high);
    let (low, up) = (a_low * b_low).overflowing_add(middle << 16);
    let high = a_high * b_high + (middle >> 16) + (u32::from(carry) << 16) + u32::from(up);
    u64::from(high) << 32 | u64::from(low)
}

#[inline(never)]
fn signed_by_halves(a: i32, b: i32) -> i64 {
    let product = by_halves(a.cast_unsigned(), b.cast_unsigned());
    // What a sign bit counts too much as a bit of 2^31.
    let high = ((a >> 31) & b).wrapping_add((b >> 31) & a);
    product.wrapping_sub(u64::from(high.cast_unsigned()) << 32).cast_signed()
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a carry between the halves is lost, or a product is told from its high halves to which one more is missing.
    #[test]
    fn halves_make_the_whole_product() {
        let ends =
            [0, 1, 2, 0x7FFF, 0x8000, 0xFFFF, 0x1_0000, 0x7FFF_FFFF, 0x8000_0000, 0xFFFF_0001, u32::MAX];
        let mut state = 1_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state ^ state >> 16
        };
        let pairs = ends.iter().flat_map(|&a| ends.map(|b| (a, b)));
        let mut told = 0;
        for (a, b) in pairs.chain((0..100_000).map(|_| (random(), random()))) {
            assert_eq!(by_halves(a, b), u64::from(a) * u64::from(b), "{a:#x} {b:#x}");
            for short in [b & 0xFFFF, 1 << 16] {
                for rounding in [0, b >> 16, 0xFFFF] {
                    let exact = (u64::from(a) * u64::from(short) + u64::from(rounding)) >> 16;
                    assert_eq!(scaled_by_halves(a, short, rounding), exact as u32, "{a:#x} {short:#x}");
                }
            }
            let (half, other) = (a >> 1, b >> 1);
            for (less, by) in (0..=1).flat_map(|less| [0, 1, 9, 31].map(|by| (less, by))) {
                let product = u64::from(half) * u64::from(other);
                if product < u64::from(less) {
                    continue;
                }
                let exact = ((product - u64::from(less)) >> (32 + by)) as u32;
                if let Some(high) = high_by_halves(half, other, less, by) {
                    assert_eq!(high, exact, "{half:#x} {other:#x} {less} {by}");
                    told += 1;
                }
                assert_eq!(unsigned_down(half, other, less, 32 + by), exact);
            }
            let (a, b) = (a.cast_signed(), b.cast_signed());
            assert_eq!(signed(a, b), i64::from(a) * i64::from(b), "{a:#x} {b:#x}");
        }
        assert!(told > 300_000, "{told}");
    }

    // Red when a bit of the quotient is left out, or a rest that is as large as the part of it is not taken.
    #[test]
    fn bits_make_the_whole_quotient() {
        let ends = [0, 1, 2, 3, 0x7FFF, 0x8000, 0xFFFF, 0x1_0000, 0x7FFF_FFFF, 0x8000_0000, u32::MAX];
        let mut state = 1_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> (state & 31)
        };
        let pairs = ends.iter().flat_map(|&a| ends.map(|b| (a, b)));
        for (a, b) in pairs.chain((0..100_000).map(|_| (random(), random()))) {
            let Some(b) = NonZeroU32::new(b) else { continue };
            assert_eq!(divided_by_bits(a, b), (a / b, a % b), "{a} / {b}");
        }
    }

    // Red when the step to the high word is left out, or the last zero is not counted.
    #[test]
    fn all_leading_zeros_are_counted() {
        for bit in 0..64 {
            for x in [1 << bit, u64::MAX >> bit, 0x9E37_79B9_7F4A_7C15 >> bit, 0] {
                assert_eq!(zeros_by_steps(x), x.leading_zeros(), "{x:#x}");
            }
        }
    }

    // Red when a bit is lost between the words, or at the ends of a shift's range.
    #[test]
    fn words_are_shifted_as_one() {
        for x in [1, u64::MAX, 0x8000_0000, 1 << 32, 0x9E37_79B9_7F4A_7C15] {
            for by in 0..64 {
                assert_eq!(down_by_words(x, by), (x >> by) as u32, "{x:#x} >> {by}");
            }
            for by in 0..32 {
                assert_eq!(up_by_words(x, by), x << by, "{x:#x} << {by}");
            }
        }
    }
}

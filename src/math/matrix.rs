//! Matrices as integer mantissas that share one power of two.

use super::format::Length;
use super::product;

/// A 4x4 matrix for column vectors: integers of up to 30 bits that share one exponent, so nothing is lost when a
/// small mesh stands far away.
///
/// An element is `mantissa * 2^-exponent`. Products are rounded to nearest at 2^-30 of the largest element.
///
/// ```
/// use topleft::{Length, Matrix};
///
/// const HALF: Length = Length::lit("0.5");
/// const O: Length = Length::ZERO;
/// const SHRINK: Matrix = Matrix::new([[HALF, O, O, O], [O, HALF, O, O], [O, O, HALF, O], [O, O, O, Length::ONE]]);
/// let quarter = SHRINK.times(&SHRINK);
/// assert_eq!(quarter.row(0)[0] * 4, quarter.row(3)[3]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Matrix {
    rows: [[i32; 4]; 4],
    exponent: i32,
}

impl Matrix {
    /// Leaves every point where it is.
    pub const IDENTITY: Self = {
        let (i, o) = (Length::ONE, Length::ZERO);
        Self::new([[i, o, o, o], [o, i, o, o], [o, o, i, o], [o, o, o, i]])
    };

    /// Sends every point to nowhere: what a camera that cannot exist draws with.
    pub const NOWHERE: Self = Self { rows: [[0; 4]; 4], exponent: 0 };

    /// A matrix of fixed-point elements, row by row. Usable in a `const`, without a float in the program.
    pub const fn new(rows: [[Length; 4]; 4]) -> Self {
        let mut wide = [[0; 4]; 4];
        let mut i = 0;
        while i < 16 {
            wide[i / 4][i % 4] = rows[i / 4][i % 4].to_bits() as i64;
            i += 1;
        }
        Self::normalised(&wide, 16)
    }

    /// The mantissas of a row, in 2^-30 to 2^30.
    pub const fn row(&self, row: usize) -> [i32; 4] {
        if row < 4 { self.rows[row] } else { [0; 4] }
    }

    /// All mantissas.
    pub(crate) const fn rows_mut(&mut self) -> &mut [[i32; 4]; 4] {
        &mut self.rows
    }

    /// The power of two that the elements share: an element is its mantissa times 2 to the minus this.
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The matrix that does `other` first and then this.
    #[must_use]
    #[inline(never)]
    pub fn times(&self, other: &Self) -> Self {
        // Mantissas have at most 30 bits and a sign: four products fit.
        let element = |row: &[i32; 4], column: usize| row.get(column).copied().unwrap_or_default();
        let wide = core::array::from_fn(|row| {
            let row = self.row(row);
            core::array::from_fn(|column| {
                row.iter()
                    .zip(&other.rows)
                    .map(|(&factor, row)| product::signed(factor, element(row, column)))
                    .sum()
            })
        });
        Self::normalised(&wide, self.exponent.saturating_add(other.exponent))
    }

    /// Rounds wide elements so that the largest has 30 bits.
    #[inline(never)]
    pub(crate) const fn normalised(wide: &[[i64; 4]; 4], exponent: i32) -> Self {
        let (mut bits, mut rest) = (0, wide.as_flattened());
        while let [element, tail @ ..] = rest {
            bits |= element.unsigned_abs();
            rest = tail;
        }
        let shift = product::leading_zeros(bits) as i32 - 34;
        let mut rows = [[0; 4]; 4];
        let (mut from, mut to) = (wide.as_flattened(), rows.as_flattened_mut());
        while let ([wide, from_tail @ ..], [element, to_tail @ ..]) = (from, to) {
            *element = shifted(*wide, shift);
            (from, to) = (from_tail, to_tail);
        }
        // Nowhere has one exponent.
        Self { rows, exponent: if bits == 0 { 0 } else { exponent.saturating_add(shift) } }
    }
}

/// `value * 2^shift`, rounded to nearest and held to ±(2^30 - 1), for values of at most 30 bits once they are shifted: from words,
/// as a shift of 64 bits may be a call.
const fn shifted(value: i64, shift: i32) -> i32 {
    const LIMIT: i32 = (1 << 30) - 1;
    let (low, high) = (value as u32, (value >> 32) as i32);
    if shift >= 0 {
        return (low << shift).cast_signed();
    }
    // Of halves there are up to 2^31.
    let down = (-shift - 1).cast_unsigned();
    let halves = if down < 32 {
        (low >> down | high.cast_unsigned() << 1 << (31 - down)).cast_signed()
    } else {
        high >> (down & 31)
    };
    let moved = (halves >> 1) + (halves & 1);
    if moved > LIMIT {
        LIMIT
    } else if moved < -LIMIT {
        -LIMIT
    } else {
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_does_the_right_factor_first() {
        let l = |v: i32| Length::from_num(v);
        let o = Length::ZERO;
        let scale = Matrix::new([[l(2), o, o, o], [o, l(2), o, o], [o, o, l(2), o], [o, o, o, l(1)]]);
        let shift = Matrix::new([[l(1), o, o, l(5)], [o, l(1), o, o], [o, o, l(1), o], [o, o, o, l(1)]]);
        let value = |m: &Matrix, r: usize, c: usize| m.row(r)[c] >> m.exponent();
        let both = scale.times(&shift);
        assert_eq!((value(&both, 0, 0), value(&both, 0, 3)), (2, 10));
        let both = shift.times(&scale);
        assert_eq!((value(&both, 0, 0), value(&both, 0, 3)), (2, 5));
    }

    #[test]
    fn extremes_neither_overflow_nor_panic() {
        let most = Matrix::new([[Length::MIN; 4]; 4]);
        let mut product = most;
        for _ in 0..100 {
            product = product.times(&most);
            assert!(product.row(0)[0].unsigned_abs() < 1 << 30);
        }
        assert_eq!(most.times(&Matrix::NOWHERE), Matrix::NOWHERE);
    }

    // Red when halves are rounded down, a bit is lost between the words, or what rounds up to one bit more is not held.
    #[test]
    fn an_element_is_shifted_and_rounded_to_nearest() {
        let mut state = 1_u64;
        for round in 0..200_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // As far as the largest goes, which has 30 bits then.
            let bits = 1 + round % 63;
            let shift = 30 - bits;
            let most = (1_i64 << (bits - 1) << 1).wrapping_sub(1);
            for value in [(state >> 1).cast_signed() & most, most, most - 1] {
                for value in [value, -value] {
                    let exact = if shift >= 0 {
                        i128::from(value) << shift
                    } else {
                        (i128::from(value) + (1 << (-shift - 1))) >> -shift
                    };
                    let held = exact.clamp(1 - (1 << 30), (1 << 30) - 1);
                    assert_eq!(i128::from(shifted(value, shift)), held, "{value} {shift}");
                }
            }
        }
    }
}

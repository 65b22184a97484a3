//! Angles as fractions of a turn, with sine and cosine from a table.

/// An angle: 65 536 steps to the full turn, counter-clockwise. It wraps.
///
/// ```
/// use topleft::Turn;
///
/// let quarter = Turn::from_degrees(90);
/// assert_eq!(quarter, Turn::new(16_384));
/// assert_eq!(quarter + quarter + quarter + quarter, Turn::ZERO);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Turn(u16);

impl Turn {
    /// No turn.
    pub const ZERO: Self = Self(0);

    /// `steps` of 1/65 536 turn.
    pub const fn new(steps: u16) -> Self {
        Self(steps)
    }

    /// Whole degrees, to the nearest step (0.0055 degrees); any number of turns.
    pub const fn from_degrees(degrees: i32) -> Self {
        let degrees = degrees.rem_euclid(360) as u32;
        Self(((degrees * 65_536 + 180) / 360) as u16)
    }

    /// Steps of 1/65 536 turn.
    pub const fn steps(self) -> u16 {
        self.0
    }

    /// The sine in 30 fraction bits, within ±2^-15.6: the table's rounding and the chord below the arc.
    pub(crate) fn sin(self) -> i32 {
        let quadrant = self.0 >> 14;
        let within = self.0 & 0x3FFF;
        // The second and fourth quarter run backwards, the lower half is negative.
        let from_zero = if quadrant & 1 == 0 { within } else { 0x4000 - within };
        let index = usize::from(from_zero >> 6);
        let fraction = i32::from(from_zero & 63);
        let mut entry = i32::from(ENTRIES.get(index / STRIDE).copied().unwrap_or_default());
        let mut steps = STEPS.get(index & !(STRIDE - 1)..).unwrap_or_default().iter();
        for &step in steps.by_ref().take(index % STRIDE) {
            // It stays a loop.
            core::hint::black_box(());
            entry += i32::from(step);
        }
        let step = i32::from(steps.next().copied().unwrap_or_default());
        // 15 fraction bits in the table, 6 from the interpolation.
        let sine = (entry << 6) + step * fraction;
        let sine = sine << 9;
        if quadrant & 2 == 0 { sine } else { -sine }
    }

    /// The cosine in 30 fraction bits, within ±2^-15.6: the table's rounding and the chord below the arc.
    pub(crate) fn cos(self) -> i32 {
        Self(self.0.wrapping_add(0x4000)).sin()
    }
}

impl core::ops::Add for Turn {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }
}

impl core::ops::Sub for Turn {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0.wrapping_sub(other.0))
    }
}

/// A quarter wave, 257 entries with 15 fraction bits: rounding 2^-16, interpolation `(pi / 512)^2 / 8 = 2^-17.7`.
const QUARTER: [u16; 257] = {
    let mut table = [0; 257];
    let mut i = 0;
    while i < table.len() {
        table[i] = ((sine_of(i as i128) + (1 << 44)) >> 45) as u16;
        i += 1;
    }
    table
};

/// Of the quarter wave, one entry in so many is kept, and the steps between all: half of the flash, as no step is above 201.
const STRIDE: usize = 16;

static ENTRIES: [u16; 256 / STRIDE + 1] = {
    let mut entries = [0; 256 / STRIDE + 1];
    let mut i = 0;
    while i < entries.len() {
        entries[i] = QUARTER[i * STRIDE];
        i += 1;
    }
    entries
};

static STEPS: [u8; 256] = {
    let mut steps = [0; 256];
    let mut i = 0;
    while i < steps.len() {
        steps[i] = (QUARTER[i + 1] - QUARTER[i]) as u8;
        i += 1;
    }
    steps
};

/// The sine of `i / 1024` of a turn in 60 fraction bits, by its power series.
const fn sine_of(i: i128) -> i128 {
    /// Pi in 60 fraction bits.
    const PI: i128 = 3_622_009_729_038_561_421;
    let x = PI * i / 512;
    let square = (x * x) >> 60;
    let mut term = x;
    let mut sum = x;
    let mut n = 1;
    while n < 12 {
        term = -((term * square) >> 60) / (2 * n * (2 * n + 1));
        sum += term;
        n += 1;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_and_cosine_lie_on_the_circle() {
        for steps in 0..=u16::MAX {
            let (s, c) = (i64::from(Turn(steps).sin()), i64::from(Turn(steps).cos()));
            // Each is off by at most 2^-16 + 2^-17.7 = 2^-15.6: the squares by at most 2 sqrt(2) times that.
            assert!((s * s + c * c - (1 << 60)).abs() < 1 << 46, "{steps}");
        }
        assert_eq!([0, 90, 180, 270].map(|d| Turn::from_degrees(d).sin()), [0, 1 << 30, 0, -(1 << 30)]);
        assert_eq!(
            Turn::from_degrees(30).sin() >> 15,
            (1 << 14) - 1,
            "the sine of 30 degrees, rounded to a step"
        );
        assert_eq!(Turn::from_degrees(-90), Turn::from_degrees(270));
    }

    // Red when an entry is one too far, or the steps before the one that is interpolated are not all added.
    #[test]
    fn entries_and_steps_make_the_quarter_wave() {
        for steps in 0..=0x4000 {
            let (index, fraction) = (usize::from(steps >> 6), i32::from(steps & 63));
            let [here, next] =
                [index, index + 1].map(|i| i32::from(QUARTER.get(i).copied().unwrap_or_default()));
            let between = if fraction == 0 { 0 } else { (next - here) * fraction };
            assert_eq!(Turn(steps).sin(), ((here << 6) + between) << 9, "{steps}");
        }
    }
}

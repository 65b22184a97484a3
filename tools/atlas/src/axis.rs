//! Axes of maps, and the scale of their colours.

use crate::canvas::Colour;

/// How numbers are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scale {
    Log,
    Linear,
}

impl Scale {
    /// Where `value` lies between two others: 0 at `from`, 1 at `to`.
    fn place(self, value: f64, [from, to]: [f64; 2]) -> f64 {
        match self {
            Self::Log => (value / from).log2() / (to / from).log2(),
            Self::Linear => (value - from) / (to - from),
        }
    }

    /// The value at a place.
    fn value(self, place: f64, [from, to]: [f64; 2]) -> f64 {
        match self {
            Self::Log => from * (place * (to / from).log2()).exp2(),
            Self::Linear => from + place * (to - from),
        }
    }
}

/// An axis that is cut into cells of the same length.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) name: &'static str,
    pub(crate) scale: Scale,
    pub(crate) ends: [f64; 2],
    pub(crate) cells: usize,
    pub(crate) ticks: Vec<(f64, String)>,
}

impl Axis {
    /// The value in the middle of a cell.
    pub(crate) fn middle(&self, cell: usize) -> f64 {
        self.scale.value((cell as f64 + 0.5) / self.cells as f64, self.ends)
    }

    /// 0 to 1 of a value.
    pub(crate) fn place(&self, value: f64) -> f64 {
        self.scale.place(value, self.ends)
    }

    /// The value at 0 to 1.
    pub(crate) fn value(&self, place: f64) -> f64 {
        self.scale.value(place, self.ends)
    }
}

/// Ticks with their own numbers as labels.
pub(crate) fn ticks(values: &[f64]) -> Vec<(f64, String)> {
    values.iter().map(|&value| (value, short(value))).collect()
}

/// Ticks at powers of two, labelled so.
pub(crate) fn powers(exponents: impl IntoIterator<Item = i32>) -> Vec<(f64, String)> {
    exponents.into_iter().map(|e| (f64::from(e).exp2(), format!("2^{e}"))).collect()
}

/// A number with three significant digits at the most.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let power = value.abs().log10().floor() as i32;
    if !(-4..=5).contains(&power) {
        return format!("{value:.0e}");
    }
    let text = format!("{value:.*}", (2 - power).max(0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// The colours of a map, dark for little: between two values, and one more for nothing at all.
#[derive(Clone, Debug)]
pub(crate) struct Bar {
    pub(crate) name: &'static str,
    /// By powers.
    pub(crate) ends: [f64; 2],
    pub(crate) ticks: Vec<(f64, String)>,
}

/// Steps of the scale: more cannot be told apart.
pub(crate) const STEPS: i32 = 48;

impl Bar {
    pub(crate) fn place(&self, value: f64) -> f64 {
        Scale::Log.place(value, self.ends)
    }

    pub(crate) fn colour(&self, value: f64) -> Colour {
        if value == 0.0 { NOTHING } else { step((self.place(value) * f64::from(STEPS)).floor() as i32) }
    }
}

/// The colour of no error.
pub(crate) const NOTHING: Colour = [255; 3];

/// From dark blue over green to yellow, each lighter than the last.
const STOPS: [[f64; 3]; 6] = [
    [40.0, 12.0, 84.0],
    [58.0, 76.0, 140.0],
    [33.0, 130.0, 140.0],
    [52.0, 178.0, 116.0],
    [150.0, 214.0, 60.0],
    [250.0, 230.0, 40.0],
];

/// The colour of a step of the scale; those beyond its ends are the ends'.
pub(crate) fn step(step: i32) -> Colour {
    let place = f64::from(step.clamp(0, STEPS - 1)) / f64::from(STEPS - 1) * (STOPS.len() - 1) as f64;
    let low = (place as usize).min(STOPS.len() - 2);
    let part = place - low as f64;
    [0, 1, 2].map(|k| (STOPS[low][k] + (STOPS[low + 1][k] - STOPS[low][k]) * part).round() as u8)
}

//! How numbers are spread along an axis.

/// A scale from one number to another.
#[derive(Clone, Debug)]
pub(crate) struct Scale {
    pub(crate) ends: [f64; 2],
    pub(crate) log: bool,
    pub(crate) ticks: Vec<(f64, String)>,
}

impl Scale {
    /// By powers, with a tick at each of `steps` in each power of ten.
    pub(crate) fn log(ends: [f64; 2], steps: &[f64]) -> Self {
        let powers = ends[0].log10().floor() as i32..=ends[1].log10().ceil() as i32;
        let values = powers.flat_map(|power| steps.iter().map(move |step| step * 10.0_f64.powi(power)));
        let ticks = values
            .filter(|value| (ends[0] * 0.999..=ends[1] * 1.001).contains(value))
            .map(|value| (value, short(value)))
            .collect();
        Self { ends, log: true, ticks }
    }

    /// Even, from 0, with a tick every `step`.
    pub(crate) fn even(end: f64, step: f64) -> Self {
        let count = (end / step + 1e-9).floor() as u32;
        let ticks = (0..=count).map(|k| (f64::from(k) * step, short(f64::from(k) * step))).collect();
        Self { ends: [0.0, end], log: false, ticks }
    }

    /// 0 at the first end, 1 at the other; values beyond them lie at the ends.
    pub(crate) fn place(&self, value: f64) -> f64 {
        let [from, to] = self.ends;
        let place = if self.log {
            (value.max(f64::MIN_POSITIVE) / from).ln() / (to / from).ln()
        } else {
            (value - from) / (to - from)
        };
        place.clamp(0.0, 1.0)
    }
}

/// A number with three significant digits at the most.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let power = value.abs().log10().floor() as i32;
    let text = format!("{value:.*}", (2 - power).max(0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

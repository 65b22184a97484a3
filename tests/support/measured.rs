//! Errors as rows of a table: what was measured, what is allowed, and how much of that was used.

use std::collections::BTreeMap;
use std::fmt;

/// The errors of one kind, each held against its own bound as it is added.
#[derive(Clone, Debug, Default)]
pub(crate) struct Errors {
    count: u64,
    max: f64,
    bound: f64,
    ratio: f64,
    /// How many errors have the same 6 leading bits of their mantissa; by these bits and the exponent.
    sizes: BTreeMap<u64, u64>,
}

/// Bits of a mantissa that a size is not sorted by.
const DROPPED: u32 = 52 - 6;

impl Errors {
    /// Adds an error, and panics with `what` where it is larger than its bound, or no number.
    #[track_caller]
    pub(crate) fn add(&mut self, error: f64, bound: f64, what: impl FnOnce() -> String) {
        let error = error.abs();
        assert!(error <= bound, "{}: {error:e} > {bound:e}", what());
        self.count += 1;
        self.max = self.max.max(error);
        self.bound = self.bound.max(bound);
        // 0 of 0 is 0.
        if error > 0.0 {
            self.ratio = self.ratio.max(error / bound);
        }
        *self.sizes.entry(error.to_bits() >> DROPPED).or_default() += 1;
    }

    /// How many were added.
    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// The largest.
    pub(crate) fn max(&self) -> f64 {
        self.max
    }

    /// The largest share of its own bound that one of them has.
    pub(crate) fn ratio(&self) -> f64 {
        self.ratio
    }

    /// What 999 of 1000 do not exceed, rounded up to 7 bits.
    fn p999(&self) -> f64 {
        let above = self.count / 1000;
        let mut seen = 0;
        for (size, count) in self.sizes.iter().rev() {
            seen += count;
            if seen > above {
                let end = if *size == 0 { 0 } else { (size + 1) << DROPPED };
                return f64::from_bits(end).min(self.max);
            }
        }
        0.0
    }
}

/// A row of `docs/measured/accuracy.csv`, whose columns have the same names.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) stage: &'static str,
    pub(crate) scene: String,
    pub(crate) method: String,
    pub(crate) metric: &'static str,
    pub(crate) unit: String,
    pub(crate) measured_max: f64,
    pub(crate) measured_p999: f64,
    pub(crate) bound: f64,
    pub(crate) ratio: f64,
    /// What `ratio` must reach, where the bound can be shown to be tight.
    pub(crate) least: f64,
}

impl Row {
    /// The first row of a table.
    pub(crate) const COLUMNS: &str = "stage,scene,method,metric,unit,measured_max,measured_p999,bound,ratio";

    /// What was found of one kind of error.
    pub(crate) fn new(
        stage: &'static str,
        scene: impl Into<String>,
        method: impl Into<String>,
        [metric, unit]: [&'static str; 2],
        errors: &Errors,
    ) -> Self {
        assert!(errors.count > 0, "{stage}, {metric}: nothing was measured");
        Self {
            stage,
            scene: scene.into(),
            method: method.into(),
            metric,
            unit: unit.into(),
            measured_max: errors.max,
            measured_p999: errors.p999(),
            bound: errors.bound,
            ratio: errors.ratio,
            least: 0.0,
        }
    }

    /// That none of `compared` pixels, or others, is wrong: who compares them panics at the first that is.
    pub(crate) fn none_of(
        compared: u64,
        things: &str,
        stage: &'static str,
        scene: impl Into<String>,
        method: impl Into<String>,
    ) -> Self {
        let mut none = Errors::default();
        none.add(0.0, 0.0, String::new);
        let row = Self::new(stage, scene, method, ["mismatches", ""], &none);
        assert!(compared > 0, "{row}: nothing was compared");
        Self { unit: format!("of {compared} {things}"), ..row }
    }

    /// The same, and some error must use at least this share of its bound, or the cases are not hard ones.
    pub(crate) fn reaching(self, least: f64) -> Self {
        Self { least, ..self }
    }

    /// Panics where the bound does not hold, or is not reached.
    #[track_caller]
    pub(crate) fn hold(&self) {
        assert!(self.ratio <= 1.0, "{self}: above the bound");
        assert!(
            self.ratio >= self.least,
            "{self}: not hard enough, {} of the bound are asked for",
            self.least
        );
    }
}

/// Prints rows, and panics where one does not hold.
#[track_caller]
pub(crate) fn hold(rows: &[Row]) {
    for row in rows {
        println!("{row}");
    }
    for row in rows {
        row.hold();
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { stage, scene, method, metric, unit, .. } = self;
        let [max, p999, bound, ratio] =
            [self.measured_max, self.measured_p999, self.bound, self.ratio].map(digits);
        write!(f, "{stage},{scene},{method},{metric},{unit},{max},{p999},{bound},{ratio}")
    }
}

/// A number with four significant digits.
fn digits(value: f64) -> String {
    let power = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    match power {
        _ if value == 0.0 || value.is_infinite() => format!("{value}"),
        -4..=3 => format!("{value:.*}", (3 - power) as usize),
        4..=6 => format!("{value:.0}"),
        _ => format!("{value:.3e}"),
    }
}

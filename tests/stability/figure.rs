//! Figures of many cases, as they are printed.

use std::cell::Cell;

use reference::compare::coverage;

/// A number in groups of three digits.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|group| std::str::from_utf8(group).unwrap_or("?")).collect();
    groups.join(" ")
}

/// Pixels compared with how often they should be hit.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    pixels: Cell<u64>,
    missing: Cell<u64>,
    extra: Cell<u64>,
}

impl Tally {
    /// Adds a frame; gives back how many of its pixels are wrong.
    pub(crate) fn add(&self, hits: &[u32], right: &[u32]) -> u64 {
        let found = coverage(hits, right);
        self.pixels.set(self.pixels.get() + found.pixels);
        self.missing.set(self.missing.get() + found.missing);
        self.extra.set(self.extra.get() + found.extra);
        found.missing + found.extra
    }

    pub(crate) fn pixels(&self) -> u64 {
        self.pixels.get()
    }

    /// Pixels hit less often than they should be.
    pub(crate) fn missing(&self) -> u64 {
        self.missing.get()
    }

    /// Pixels hit more often than they should be.
    pub(crate) fn extra(&self) -> u64 {
        self.extra.get()
    }

    pub(crate) fn wrong(&self) -> u64 {
        self.missing() + self.extra()
    }
}

/// Hit counts as the walks and the exact winding give them.
pub(crate) fn unsigned(hits: &[i32]) -> Vec<u32> {
    hits.iter().map(|hits| hits.unsigned_abs()).collect()
}

//! What a triangle was set up to in one strip, for the next: records in a row, in words that nothing else uses.
//!
//! What will be needed again below the last row of a strip is put when a triangle is drawn, and taken in the next strip. The
//! same triangles come in the same order there: so nothing has to say whose a record is, or how long it is.

use core::cell::Cell;
use core::ops::Range;

use crate::attributes::Words;

/// Records while a strip is drawn: those of the strip above, and those for the one below.
#[derive(Debug)]
pub(crate) struct Retained<'w> {
    /// Triangles whose first row is above this one, from the strip above.
    top: i32,
    taken: &'w [Cell<u32>],
    /// Triangles that end below this row, for the strip below.
    bottom: i32,
    put: &'w [Cell<u32>],
}

impl<'w> Retained<'w> {
    /// No record of any triangle.
    pub(crate) const NOTHING: Self = Self { top: i32::MIN, taken: &[], bottom: i32::MAX, put: &[] };

    /// What a triangle was set up to that has its first row here: all of them are taken in the order in which they were put.
    #[inline(always)]
    pub(crate) fn take<W: Words>(&mut self, first: i32) -> Option<W> {
        if first >= self.top {
            return None;
        }
        let (record, rest) = self.taken.split_at_checked(W::WORDS)?;
        self.taken = rest;
        W::load(&mut record.iter().map(Cell::get))
    }

    /// Puts what a triangle is set up to that ends here, if there is room. All that is put after one that did not fit is
    /// shorter than that one: it takes nothing then.
    #[inline(always)]
    pub(crate) fn put<W: Words>(&mut self, end: i32, value: impl FnOnce() -> W) {
        if end <= self.bottom {
            return;
        }
        let Some((record, rest)) = self.put.split_at_checked(W::WORDS) else { return };
        self.put = rest;
        let mut words = record.iter();
        value().store(&mut |word| {
            if let Some(place) = words.next() {
                place.set(word);
            }
        });
    }
}

/// Where the records of a strip are, in the words that a list leaves free.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Records {
    start: usize,
    length: usize,
    /// The first row of the strip that they are for.
    row: i32,
}

impl Records {
    /// For no strip.
    pub(crate) const NONE: Self = Self { start: 0, length: 0, row: -1 };

    /// For a strip of some rows, at least one: its own go to the longer part of the words, before those that are taken or
    /// behind them.
    pub(crate) fn start<'w>(&mut self, words: &'w [Cell<u32>], rows: &Range<i32>) -> Retained<'w> {
        if self.row != rows.start {
            *self = Self::NONE;
        }
        let (before, rest) = words.split_at_checked(self.start).unwrap_or_default();
        let (taken, behind) = rest.split_at_checked(self.length).unwrap_or_default();
        let (start, put) =
            if before.len() > behind.len() { (0, before) } else { (self.start + self.length, behind) };
        *self = Self { start, length: put.len(), row: rows.end };
        Retained { top: rows.start, taken, bottom: rows.end, put }
    }

    /// When the strip is drawn.
    pub(crate) const fn end(&mut self, retained: &Retained<'_>) {
        self.length -= retained.put.len();
    }
}

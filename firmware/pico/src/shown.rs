//! What the panel shows already: which rows of a frame have to be sent, and in which strips.

use core::ops::Range;

use crate::{PANEL, STRIP_ROWS};

const HEIGHT: i32 = PANEL.height as i32;
const ROWS: i32 = STRIP_ROWS as i32;
const _: () = assert!(HEIGHT % ROWS == 0, "strips that hold the whole panel reach beyond it");

/// What the panel shows: one colour, but for some rows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// Nothing is known of it before the first frame.
    background: Option<u16>,
    rows: Range<i32>,
}

impl Shown {
    /// The rows that have to be sent for a frame with something to see in `rows`, and a line at the bottom if triangles
    /// were left out: those, and the ones that the frame before showed something in. All where the background is new.
    pub fn change(&mut self, background: u16, rows: Range<i32>, left_out: usize) -> Range<i32> {
        let next = if left_out == 0 { rows } else { rows.start..HEIGHT };
        let last = core::mem::replace(&mut self.rows, next.clone());
        if self.background.replace(background) != Some(background) {
            0..HEIGHT
        } else if last.is_empty() {
            next
        } else if next.is_empty() {
            last
        } else {
            last.start.min(next.start)..last.end.max(next.end)
        }
    }
}

/// The first rows of the fewest strips that hold these rows, from the top down. Rows that are not asked for are the first ones, if
/// there is room above: the less there is to see in the first strip, the better, as it is sent while the bus has nothing else to do.
pub fn strips(rows: Range<i32>) -> impl Iterator<Item = i32> {
    let count = rows.len().div_ceil(STRIP_ROWS) as i32;
    let first = (rows.end - count * ROWS).max(0);
    (0..count).map(move |strip| first + strip * ROWS)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red when: what the last frame showed is not erased, the first frame or one with a new background is not sent as a whole,
    /// or the line at the bottom is not, or is not erased.
    #[test]
    fn rows_are_sent_that_change() {
        let mut shown = Shown::default();
        let steps = [
            // The panel shows anything.
            (1, 90..100, 0, 0..HEIGHT),
            (1, 90..100, 0, 90..100),
            (1, 95..110, 0, 90..110),
            (1, 20..30, 0, 20..110),
            (1, 20..30, 5, 20..HEIGHT),
            (1, 25..35, 0, 20..HEIGHT),
            (1, 0..0, 0, 25..35),
            (1, 0..0, 0, 0..0),
            (1, 50..60, 0, 50..60),
            (2, 50..60, 0, 0..HEIGHT),
            (2, 50..60, 0, 50..60),
        ];
        for (number, (background, rows, left_out, expected)) in steps.into_iter().enumerate() {
            assert_eq!(shown.change(background, rows, left_out), expected, "step {number}");
        }
    }

    /// Red when: a strip is left out, leaves rows between it and the next, reaches beyond the panel, or is one too many.
    #[test]
    fn strips_hold_all_rows() {
        for start in 0..=HEIGHT {
            for end in start..=HEIGHT {
                let (mut count, mut next) = (0, None);
                for top in strips(start..end) {
                    assert!(top >= 0 && top + ROWS <= HEIGHT && next.is_none_or(|next| next == top));
                    assert!(count > 0 || top <= start);
                    (count, next) = (count + 1, Some(top + ROWS));
                }
                assert!(
                    start == end && next.is_none() || next.is_some_and(|next| next >= end),
                    "{start}..{end}"
                );
                assert_eq!(count, (end - start + ROWS - 1) / ROWS);
            }
        }
    }
}

//! Long runs of one word, two cells at a time: a strip and its depths before they are drawn to.

use core::hint::black_box;

/// Sets all cells: in pairs where registers have 32 bits, and as the compiler does it where they have more.
#[inline]
pub(crate) fn fill(cells: &mut [u16], word: u16) {
    if cfg!(target_pointer_width = "32") { in_pairs(cells, word) } else { cells.fill(word) }
}

#[inline(never)]
fn in_pairs(cells: &mut [u16], word: u16) {
    let (first, pairs, last) = bytemuck::pod_align_to_mut::<u16, u32>(cells);
    // At most one cell each.
    for cell in first {
        black_box(());
        *cell = word;
    }
    for cell in last {
        black_box(());
        *cell = word;
    }
    let pair = u32::from(word) << 16 | u32::from(word);
    // Opaque, as words that are known to be equal would be in one register.
    in_fours(black_box(pair), black_box(pair), black_box(pair), black_box(pair), pairs);
}

/// Sets all words. The same word comes four times: a small core stores four registers at once in five cycles, and one alone in
/// two. They are the first arguments, so that they are in registers in the order that this takes.
#[inline(never)]
fn in_fours(a: u32, b: u32, c: u32, d: u32, words: &mut [u32]) {
    let four = [a, b, c, d];
    let (rest, fours) = words.as_rchunks_mut::<4>();
    let (few, eights) = fours.as_rchunks_mut::<8>();
    for word in rest {
        black_box(());
        *word = a;
    }
    for words in few {
        black_box(());
        *words = four;
    }
    // Written out: a step costs as much as four words.
    for [e, f, g, h, i, j, k, l] in eights {
        black_box(());
        (*e, *f, *g, *h) = (four, four, four, four);
        (*i, *j, *k, *l) = (four, four, four, four);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when the cell before the first pair, the one after the last, the pairs before the first four, the fours before the first
    // eight, or one of eight are left out.
    #[test]
    fn all_cells_are_set_and_no_other() {
        for start in 0..4 {
            for length in 0..150 {
                let mut cells = [7; 160];
                let (before, after) = (start, start + length);
                in_pairs(&mut cells[before..after], 0x1234);
                assert!(cells[before..after].iter().all(|&cell| cell == 0x1234), "{length} from {start}");
                assert!(
                    cells[..before].iter().chain(&cells[after..]).all(|&cell| cell == 7),
                    "{length} from {start}"
                );
            }
        }
    }
}

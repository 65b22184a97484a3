//! Long runs of one word, two cells at a time: a strip and its depths before they are drawn to.

/// Sets all cells: in pairs where registers have 32 bits, and as the compiler does it where they have more.
#[inline]
pub(crate) fn fill(cells: &mut [u16], word: u16) {
    if cfg!(target_pointer_width = "32") { in_pairs(cells, word) } else { cells.fill(word) }
}

#[inline(never)]
fn in_pairs(cells: &mut [u16], word: u16) {
    let (first, pairs, last) = bytemuck::pod_align_to_mut::<u16, u32>(cells);
    let pair = u32::from(word) << 16 | u32::from(word);
    // Written out: on a small core a store takes two cycles, and a step four more.
    let (eights, rest) = pairs.as_chunks_mut::<8>();
    for [a, b, c, d, e, f, g, h] in eights {
        core::hint::black_box(());
        (*a, *b, *c, *d) = (pair, pair, pair, pair);
        (*e, *f, *g, *h) = (pair, pair, pair, pair);
    }
    for few in rest {
        core::hint::black_box(());
        *few = pair;
    }
    // At most one cell each.
    for cell in first {
        core::hint::black_box(());
        *cell = word;
    }
    for cell in last {
        core::hint::black_box(());
        *cell = word;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when the cell before the first pair, the one after the last, or the pairs after the last eight are left out.
    #[test]
    fn all_cells_are_set_and_no_other() {
        for start in 0..4 {
            for length in 0..70 {
                let mut cells = [7; 80];
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

//! A strip with cells before and behind it that nobody may write to.

use std::ops::Range;

use topleft::DrawList;
use topleft::stages::Traversal;

use super::frame::Strips;

const WIDTH: usize = 40;
const HEIGHT: usize = 23;
/// What stands before and behind the strip.
const GUARD: u16 = 0xA55A;

/// Colours and depths of a list's rows in a strip of 40 by 23 pixels, and a row of guards before and behind it.
pub(crate) fn guarded<D: Strips, T: Traversal>(
    list: &DrawList<'_, u16, D, T>,
    rows: Range<i32>,
) -> Result<Vec<u16>, String> {
    const ALL: usize = WIDTH * (HEIGHT + 2);
    const STRIP: Range<usize> = WIDTH..WIDTH * (HEIGHT + 1);
    let (mut cells, mut depths) = ([GUARD; ALL], [GUARD; ALL]);
    let mut strip = D::strip(WIDTH as u16, &mut cells[STRIP], &mut depths[STRIP]);
    strip.clear();
    list.render(rows, &mut strip);
    drop(strip);
    for guarded in [&cells, &depths] {
        if guarded[..STRIP.start].iter().chain(&guarded[STRIP.end..]).any(|&cell| cell != GUARD) {
            return Err("written beyond the strip".into());
        }
    }
    Ok([cells, depths].concat())
}

//! What each thing costs: a row for each, with a bar in each of six columns.

use crate::plot::{Anchor, BLACK, Canvas, GREY, Scale, Shape, short, svg};
use crate::table::{Table, number};

/// Where the first bars start, and how wide the widest is; beside it there is room for its number.
const LEFT: i32 = 216;
const WIDTH: i32 = 150;
const COLUMN: i32 = WIDTH + 66;
/// Of a bar and the gap below it.
const ROW: i32 = 26;
/// From the top of three columns to the bars.
const HEAD: i32 = 58;

/// Columns of the table: what they count, and of what. Three stand beside each other.
const PANELS: [[(&str, &str, &str); 3]; 2] = [
    [
        ("m0plus_per_px", "cycles a pixel", "Cortex-M0+, opt-level 3"),
        ("flash_bytes", "bytes of flash", "Cortex-M0+, opt-level s"),
        ("ram_bytes", "bytes of RAM", "strip 240x16, 1000 vertices"),
    ],
    [
        ("m0plus_per_triangle", "cycles a triangle", "Cortex-M0+, opt-level 3"),
        ("m4_per_px", "instructions a pixel", "Cortex-M4, opt-level 3"),
        ("m4_per_triangle", "instructions a triangle", "Cortex-M4, opt-level 3"),
    ],
];

pub(super) fn draw(table: &Table) -> String {
    let rows: Vec<_> = table.records().collect();
    let height = HEAD + rows.len() as i32 * ROW;
    let size = [LEFT + 3 * COLUMN, 2 * height + 14];
    svg(size.map(i32::unsigned_abs), |canvas| {
        for (down, panels) in PANELS.iter().enumerate() {
            let top = HEAD + down as i32 * height;
            for (row, of_part) in rows.iter().enumerate() {
                let y = top + row as i32 * ROW;
                if row % 2 == 0 {
                    canvas.block([8, y - 4], [size[0] - 8, y + ROW - 4], BAND);
                }
                canvas.text(of_part["part"], [LEFT - 10, y + ROW / 2 - 4], 13, BLACK, Anchor::Right);
            }
            for (across, (column, counted, of)) in panels.iter().enumerate() {
                let left = LEFT + across as i32 * COLUMN;
                canvas.text(counted, [left, top - 36], 15, BLACK, Anchor::Left);
                canvas.text(of, [left, top - 17], 12, GREY, Anchor::Left);
                let bars: Vec<_> = rows.iter().map(|row| number(row, column)).collect();
                panel(canvas, [left, top], &bars);
            }
        }
    })
}

/// Behind every other row, so that one is followed from its name to its last bar.
const BAND: [u8; 3] = [240, 240, 240];

fn panel(canvas: &Canvas<'_>, [left, top]: [i32; 2], bars: &[Option<f64>]) {
    let most = bars.iter().flatten().copied().fold(1e-9, f64::max);
    let scale = Scale::even(most, most);
    for (row, value) in bars.iter().enumerate() {
        let (y, middle) = (top + row as i32 * ROW, top + row as i32 * ROW + ROW / 2 - 4);
        let Some(value) = *value else {
            canvas.text("not measured", [left + 4, middle], 12, GREY, Anchor::Left);
            continue;
        };
        let end = left + (f64::from(WIDTH) * scale.place(value)).round() as i32;
        canvas.block([left, y], [end.max(left + 1), y + ROW - 9], Shape::TRIANGLE.colour);
        canvas.text(&short(value), [end + 6, middle], 13, BLACK, Anchor::Left);
    }
    canvas.line(&[[left, top - 4], [left, top + bars.len() as i32 * ROW - 4]], GREY, 1);
}

//! What each thing costs: a bar for each, in as many panels as there are columns.

use crate::plot::{Anchor, Canvas, Scale, Shape, short, svg};
use crate::table::{Table, number};

const LEFT: i32 = 230;
const WIDTH: i32 = 250;
const ROW: i32 = 24;

/// A column's title, and one of its table.
const TITLES: [(&str, &str); 6] = [
    ("m0plus_per_px", "Cortex-M0+: cycles a pixel"),
    ("m0plus_per_triangle", "Cortex-M0+: cycles a triangle"),
    ("m4_per_px", "Cortex-M4: instructions a pixel"),
    ("m4_per_triangle", "Cortex-M4: instructions a triangle"),
    ("flash_bytes", "flash: bytes"),
    ("ram_bytes", "RAM: bytes"),
];

pub(super) fn draw(table: &Table) -> String {
    let rows: Vec<_> = table.records().collect();
    let filled = |column: &str| rows.iter().any(|row| number(row, column).is_some());
    let shown: Vec<_> = TITLES.into_iter().filter(|(column, _)| filled(column)).collect();
    let height = 50 + rows.len() as i32 * ROW;
    let size = [LEFT + 2 * (WIDTH + 70), 10 + shown.len().div_ceil(2) as i32 * height];
    svg(size.map(i32::unsigned_abs), |canvas| {
        for (place, (column, title)) in shown.iter().enumerate() {
            let (across, down) = (place as i32 % 2, place as i32 / 2);
            let corner = [LEFT + across * (WIDTH + 70), 44 + down * height];
            let bars: Vec<_> = rows.iter().map(|row| (row["part"], number(row, column))).collect();
            panel(canvas, corner, title, &bars, across == 0);
        }
    })
}

fn panel(canvas: &Canvas<'_>, [left, top]: [i32; 2], title: &str, bars: &[(&str, Option<f64>)], named: bool) {
    canvas.text(title, [left, top - 20], 15, [20; 3], Anchor::Left);
    let most = bars.iter().filter_map(|bar| bar.1).fold(1e-9, f64::max);
    let scale = Scale::even(most, most);
    for (row, &(part, value)) in bars.iter().enumerate() {
        let y = top + row as i32 * ROW;
        if named {
            canvas.text(part, [left - 10, y + ROW / 2 - 2], 13, [20; 3], Anchor::Right);
        }
        let Some(value) = value else {
            canvas.text("not measured", [left + 4, y + ROW / 2 - 2], 12, [110; 3], Anchor::Left);
            continue;
        };
        let end = left + (f64::from(WIDTH) * scale.place(value)).round() as i32;
        let shape = Shape::ALL[row % Shape::ALL.len()];
        canvas.block([left, y], [end.max(left + 1), y + ROW - 6], shape.colour);
        canvas.text(&short(value), [end + 6, y + ROW / 2 - 2], 13, [20; 3], Anchor::Left);
    }
    canvas.line(&[[left, top - 4], [left, top + bars.len() as i32 * ROW]], [110; 3], 1);
}

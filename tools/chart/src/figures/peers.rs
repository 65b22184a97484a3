//! Other rasterizers: time against pixels that they miss or draw more than once.

use crate::plot::{Anchor, Edge, Fill, Labels, Panel, Scale, Shape, svg};
use crate::table::{Table, number};

const WORKS: [(&str, &str); 2] = [("flat+depth", "flat, with depth"), ("flat", "flat, without depth")];

pub(super) fn draw(table: &Table) -> String {
    svg([1000, 480], |canvas| {
        for (side, (work, title)) in WORKS.into_iter().enumerate() {
            let left = 80 + side as i32 * 480;
            let panel = Panel {
                corners: [[left, 40], [left + 420, 420]],
                x: Scale::log([20.0, 2000.0], &[1.0, 2.0, 5.0]),
                y: Scale::log([1.0, 100_000.0], &[1.0]),
            };
            let name = if side == 0 { "pixels missed and doubled" } else { "" };
            panel.draw(canvas, title, "µs for 512 triangles and 57 600 pixels, x86-64", name);
            let mut labels = Labels::new([[left + 3, 43], [left + 417, 417]]);
            let rows: Vec<_> = table.find(&[("work", work)]).collect();
            let mut points: Vec<_> = rows
                .iter()
                .filter_map(|row| {
                    let wrong = number(row, "missing")? + number(row, "doubled")?;
                    let package = row["peer"].split(',').next()?;
                    let shape = ["topleft", "retrofire-core", "euc", "embedded-3dgfx", "embedded-graphics"]
                        .iter()
                        .position(|&known| known == package)?;
                    let way =
                        row["peer"].split(", ").nth(1).unwrap_or(package).trim_start_matches("from the ");
                    Some((number(row, "host_us")?, wrong, Shape::ALL[shape], way.to_owned()))
                })
                .collect();
            // From left to right: what stands beside the one before has room to its right.
            points.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
            points.iter().for_each(|(time, wrong, ..)| labels.keep_clear(panel.at(*time, *wrong)));
            for (time, wrong, shape, label) in &points {
                shape.draw(canvas, panel.at(*time, *wrong), Fill::Whole);
                let text =
                    if panel.edge(*wrong) == Edge::Below { format!("{label}: 0") } else { label.clone() };
                labels.write(canvas, &text, panel.at(*time, *wrong), shape.colour);
            }
        }
        let names = ["topleft", "retrofire-core", "euc", "embedded-3dgfx", "embedded-graphics"];
        for (k, name) in names.into_iter().enumerate() {
            let x = 90 + 185 * k as i32;
            Shape::ALL[k].draw(canvas, [x, 470], Fill::Whole);
            canvas.text(name, [x + 14, 470], 13, [20; 3], Anchor::Left);
        }
    })
}

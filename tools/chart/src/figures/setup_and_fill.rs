//! A triangle and its pixels apart: measured at five sizes, and the line through them.

use crate::plot::{Anchor, Fill, Panel, Scale, Shape, svg};
use crate::table::{Table, number};

const CORES: [(&str, &str, [f64; 2]); 2] = [
    ("m0plus", "Cortex-M0+: cycles a triangle", [500.0, 500_000.0]),
    ("m4", "Cortex-M4: instructions a triangle", [200.0, 200_000.0]),
];

fn numbers(cells: &str) -> Vec<f64> {
    cells.split(' ').filter_map(|cell| cell.parse().ok()).collect()
}

pub(super) fn draw(table: &Table) -> String {
    svg([1000, 560], |canvas| {
        for (side, (core, title, ends)) in CORES.into_iter().enumerate() {
            let left = 80 + side as i32 * 385;
            let panel = Panel {
                corners: [[left, 40], [left + 300, 500]],
                x: Scale::log([5.0, 3000.0], &[1.0]),
                y: Scale::log(ends, &[1.0]),
            };
            panel.draw(canvas, title, "pixels of the triangle", "");
            for (way, row) in table.find(&[("core", core)]).enumerate() {
                let [Some(a), Some(b)] = ["per_triangle", "per_px"].map(|column| number(&row, column)) else {
                    continue;
                };
                let shape = Shape::ALL[way % Shape::ALL.len()];
                let fill = if way < Shape::ALL.len() { Fill::Whole } else { Fill::Hollow };
                let along = (0..=40).map(|k| 6.0 * (2000.0_f64 / 6.0).powf(f64::from(k) / 40.0));
                let line: Vec<_> = along.map(|pixels| [pixels, a + b * pixels]).collect();
                panel.line(canvas, &line, shape.colour, 1);
                for (pixels, cost) in numbers(row["px"]).into_iter().zip(numbers(row["cost"])) {
                    shape.draw(canvas, panel.at(pixels, cost), fill);
                }
                if side == 0 {
                    let y = 60 + 24 * way as i32;
                    shape.draw(canvas, [800, y], fill);
                    canvas.text(row["shading"], [816, y], 13, [20; 3], Anchor::Left);
                }
            }
        }
        canvas.text("lines: a + b x pixels", [792, 430], 13, [20; 3], Anchor::Left);
        canvas.text("markers: measured", [792, 454], 13, [20; 3], Anchor::Left);
    })
}

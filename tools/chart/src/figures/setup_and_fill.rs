//! A triangle and its pixels apart: measured at five sizes, and the line through them.

use crate::plot::{Anchor, Canvas, Fill, Panel, Scale, Shape, svg};
use crate::table::{Table, number};

/// A core's name in the table, its title, and the ends of its axis.
const CORES: [(&str, &str, [f64; 2]); 2] = [
    ("m0plus", "Cortex-M0+: cycles a triangle", [600.0, 400_000.0]),
    ("m4", "Cortex-M4: instructions a triangle", [400.0, 200_000.0]),
];

/// Shadings by name, without light and depth.
const SHAPES: [(&str, Shape); 5] = [
    ("flat", Shape::SQUARE),
    ("gouraud", Shape::CIRCLE),
    ("affine", Shape::TRIANGLE),
    ("perspective-subspan-16", Shape::DIAMOND),
    ("perspective-pixel", Shape::DOWN),
];

fn numbers(cells: &str) -> Vec<f64> {
    cells.split(' ').filter_map(|cell| cell.parse().ok()).collect()
}

pub(super) fn draw(table: &Table) -> String {
    svg([900, 900], |canvas| {
        for (column, (core, title, ends)) in CORES.into_iter().enumerate() {
            for (row, (with_depth, name)) in
                [(false, "without depth"), (true, "with depth")].into_iter().enumerate()
            {
                let [left, top] = [80 + 420 * column as i32, 40 + 405 * row as i32];
                let panel = Panel {
                    corners: [[left, top], [left + 360, top + 320]],
                    x: Scale::log([5.0, 3000.0], &[1.0]),
                    y: Scale::log(ends, &[1.0]),
                };
                panel.draw(canvas, &format!("{title}, {name}"), "pixels of the triangle", "");
                for row in table.find(&[("core", core)]) {
                    if row["shading"].ends_with("+depth") == with_depth {
                        let [Some(a), Some(b)] =
                            ["per_triangle", "per_px"].map(|column| number(&row, column))
                        else {
                            continue;
                        };
                        let measured: Vec<_> =
                            numbers(row["px"]).into_iter().zip(numbers(row["cost"])).collect();
                        draw_way(canvas, &panel, row["shading"], [a, b], &measured);
                    }
                }
            }
        }
        legend(canvas);
    })
}

fn draw_way(canvas: &Canvas<'_>, panel: &Panel, way: &str, [a, b]: [f64; 2], measured: &[(f64, f64)]) {
    let base = way.trim_end_matches("+depth").trim_start_matches("lit-");
    let known = SHAPES.iter().find(|(name, _)| *name == base);
    let (shape, fill) = (
        known.map_or(Shape::STAR, |(_, shape)| *shape),
        if way.starts_with("lit-") { Fill::Hollow } else { Fill::Whole },
    );
    let along = (0..=60).map(|k| 6.0 * (2000.0_f64 / 6.0).powf(f64::from(k) / 60.0));
    let line: Vec<_> = along.map(|pixels| [pixels, a + b * pixels]).collect();
    panel.line(canvas, &line, shape.colour, 1);
    for &(pixels, cost) in measured {
        shape.draw(canvas, panel.at(pixels, cost), fill);
    }
}

fn legend(canvas: &Canvas<'_>) {
    let mut x = 70;
    for (name, shape) in &SHAPES {
        shape.draw(canvas, [x, 850], Fill::Whole);
        canvas.text(name, [x + 14, 850], 13, [20; 3], Anchor::Left);
        x += 60 + 8 * name.len() as i32;
    }
    Shape::STAR.draw(canvas, [70, 878], Fill::Hollow);
    canvas.text("hollow: the same under light. Lines: a + b x pixels", [84, 878], 13, [20; 3], Anchor::Left);
}

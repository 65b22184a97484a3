//! What depth formats tell apart by distance, and wrong pixels against cost.

use crate::plot::{Anchor, Edge, Fill, Labels, Panel, Scale, Shape, svg};
use crate::table::{Table, number};

pub(super) fn draw(resolution: &Table, inversions: &Table) -> String {
    svg([1000, 560], |canvas| {
        let panel = Panel {
            corners: [[90, 40], [520, 460]],
            x: Scale::log([1.0, 1000.0], &[1.0]),
            y: Scale::log([1e-5, 0.1], &[1.0]),
        };
        let mut formats: Vec<&str> = Vec::new();
        for row in resolution.records() {
            if !formats.contains(&row["format"]) {
                formats.push(row["format"]);
            }
        }
        let shape = |name: &str| {
            Shape::ALL[1 + formats.iter().position(|format| *format == name).unwrap_or_default()]
        };
        panel.draw(
            canvas,
            "Resolution, near : far = 1 : 1000",
            "distance in near planes",
            "distance apart, as a share",
        );
        for format in &formats {
            let rows: Vec<_> = resolution.find(&[("format", format)]).collect();
            let values = |column: &str| -> Vec<[f64; 2]> {
                rows.iter().filter_map(|row| Some([number(row, "distance")?, number(row, column)?])).collect()
            };
            panel.line(canvas, &values("bound"), shape(format).colour, 2);
            for [x, y] in values("bound") {
                shape(format).draw(canvas, panel.at(x, y), Fill::Hollow);
            }
            for [x, y] in values("closest_pair_right") {
                shape(format).draw(canvas, panel.at(x, y), Fill::Whole);
            }
        }
        for (k, format) in formats.iter().enumerate() {
            let y = 60 + 22 * k as i32;
            shape(format).draw(canvas, [108, y], Fill::Whole);
            canvas.text(format, [122, y], 13, [20; 3], Anchor::Left);
        }
        canvas.text(
            "line, hollow: bound. Whole: the closest pair of the ladder that is right",
            [90, 516],
            13,
            [20; 3],
            Anchor::Left,
        );
        canvas.text(
            "at that distance; none is closer than 0.001, and beyond 0.05 no marker.",
            [90, 536],
            13,
            [20; 3],
            Anchor::Left,
        );

        let panel = Panel {
            corners: [[650, 40], [970, 460]],
            x: Scale::log([20.0, 200.0], &[1.0, 2.0, 5.0]),
            y: Scale::log([10.0, 100_000.0], &[1.0]),
        };
        panel.draw(
            canvas,
            "Wrong pixels in three frames",
            "cycles a pixel, flat, M0+",
            "pixels that show a hidden face",
        );
        let mut labels = Labels::new([[653, 43], [967, 457]]);
        let points: Vec<_> = inversions
            .records()
            .filter_map(|row| {
                let place = [number(&row, "m0_cycles_per_px")?, number(&row, "inverted")?];
                Some((row["method"].to_owned(), place))
            })
            .collect();
        points.iter().for_each(|(_, [x, y])| labels.keep_clear(panel.at(*x, *y)));
        for (name, [x, y]) in &points {
            let known = formats.contains(&name.as_str());
            let shape = if known { shape(name) } else { Shape::SQUARE };
            let fill = if name.contains("model") { Fill::Hollow } else { Fill::Whole };
            shape.draw(canvas, panel.at(*x, *y), fill);
            let text = if panel.edge(*y) == Edge::Below { format!("{name}: {y}") } else { name.clone() };
            labels.write(canvas, &text, panel.at(*x, *y), shape.colour);
        }
        canvas.text("hollow: a model, drawn at Depth16's cost", [650, 516], 13, [20; 3], Anchor::Left);
    })
}

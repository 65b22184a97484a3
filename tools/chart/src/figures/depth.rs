//! What depth formats tell apart by distance, and wrong pixels against cost.

use crate::plot::{Anchor, Canvas, Fill, Panel, Scale, Shape, svg};
use crate::table::{Table, number};

/// Scenes with near and far as they need them, and one with 1 : 1000, whose faces are listed from back to front.
const WRONG: [(&str, &[&str]); 2] =
    [("Wrong pixels: knot and teapot", &["knot", "teapot"]), ("Wrong pixels: ladder, 1 : 1000", &["ladder"])];

/// The ends of the axis of cycles a pixel.
const COSTS: [f64; 2] = [10.0, 200.0];

/// Markers in one place stand side by side, so far apart.
const ASIDE: i32 = 13;

pub(super) fn draw(resolution: &Table, inversions: &Table) -> String {
    let methods: Vec<&str> = inversions.records().map(|row| row["method"]).collect();
    svg([1000, 560], |canvas| {
        draw_resolution(canvas, resolution, &methods);
        for (place, (title, scenes)) in WRONG.into_iter().enumerate() {
            let top = 40 + 250 * place as i32;
            let panel = Panel {
                corners: [[640, top], [970, top + 170]],
                x: Scale::log(COSTS, &[1.0, 2.0, 5.0]),
                y: with_zero(Scale::log([0.4, 10_000.0], &[1.0])),
            };
            panel.draw(canvas, title, "cycles a pixel, flat, Cortex-M0+", "pixels");
            for row in inversions.records() {
                let wrong = scenes.iter().filter_map(|scene| number(&row, scene)).sum();
                let Some(cost) = number(&row, "m0_cycles_per_px") else { continue };
                let [x, y] = panel.at(cost, wrong);
                let place = place_of(&methods, row["method"]);
                // Two without a buffer, one with integers, two with small floats.
                let aside = ASIDE * [-1, 1, 0, -1, 1][place % 5] / 2;
                shape(&methods, row["method"]).draw(canvas, [x + aside, y], fill(row["method"]));
            }
        }
        canvas.text(
            "hollow: a model, at the cost of DepthFloat; side by side",
            [590, 544],
            13,
            [20; 3],
            Anchor::Left,
        );
    })
}

fn draw_resolution(canvas: &Canvas<'_>, table: &Table, methods: &[&str]) {
    let panel = Panel {
        corners: [[90, 40], [520, 460]],
        x: Scale::log([0.7, 1500.0], &[1.0]),
        y: Scale::log([1e-5, 0.1], &[1.0]),
    };
    panel.draw(
        canvas,
        "Resolution, near : far = 1 : 1000",
        "distance in near planes",
        "distance apart, as a share of it",
    );
    for (place, format) in methods.iter().skip(2).enumerate() {
        let shape = shape(methods, format);
        let values = |column: &str| -> Vec<[f64; 2]> {
            let rows = table.find(&[("format", format)]);
            rows.filter_map(|row| Some([number(&row, "distance")?, number(&row, column)?])).collect()
        };
        panel.line(canvas, &values("bound"), shape.colour, 2);
        for [x, y] in values("closest_pair_right") {
            let [column, row] = panel.at(x, y);
            shape.draw(canvas, [column + ASIDE * (place as i32 - 1), row], fill(format));
        }
    }
    for (k, method) in methods.iter().enumerate() {
        let y = 58 + 20 * k as i32;
        shape(methods, method).draw(canvas, [108, y], fill(method));
        canvas.text(method, [122, y], 13, [20; 3], Anchor::Left);
    }
    let notes = [
        "lines: bounds. Markers: the closest pair of the ladder that is right at that",
        "distance, side by side; no pair is closer than 0.001.",
    ];
    for (k, note) in notes.into_iter().enumerate() {
        canvas.text(note, [70, 518 + 20 * k as i32], 13, [20; 3], Anchor::Left);
    }
}

fn place_of(methods: &[&str], method: &str) -> usize {
    methods.iter().position(|known| *known == method).unwrap_or_default()
}

fn shape(methods: &[&str], method: &str) -> Shape {
    const SHAPES: [Shape; 5] = [Shape::SQUARE, Shape::DOWN, Shape::CIRCLE, Shape::TRIANGLE, Shape::DIAMOND];
    SHAPES[place_of(methods, method) % SHAPES.len()]
}

/// Models are hollow.
fn fill(method: &str) -> Fill {
    if method.contains("model") { Fill::Hollow } else { Fill::Whole }
}

/// With 0 at its lower end.
fn with_zero(mut scale: Scale) -> Scale {
    scale.ticks.push((scale.ends[0], "0".into()));
    scale
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    // Red when a marker stands on the end of the axis, over its numbers, as it is cheaper or dearer than all that is shown.
    #[test]
    fn costs_lie_on_their_axis() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/chart/depth-inversions.csv");
        let table = Table::read_if_there(&root).unwrap().unwrap();
        let costs: Vec<f64> = table.records().filter_map(|row| number(&row, "m0_cycles_per_px")).collect();
        let [least, most] = COSTS;
        assert!(
            costs.len() >= 4 && costs.iter().all(|cost| (1.2 * least..most / 1.2).contains(cost)),
            "{costs:?}"
        );
    }
}

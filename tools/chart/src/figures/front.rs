//! Cost against error: one panel a core.

use crate::method::Family;
use crate::plot::{Anchor, Canvas, Colour, Edge, Fill, Labels, Panel, Scale, Shape, svg};
use crate::table::{Table, number};

/// A core: where its cost stands in the table, and what a frame may take.
#[derive(Debug)]
pub(super) struct Core {
    column: &'static str,
    title: &'static str,
    unit: &'static str,
    ends: [f64; 2],
    /// Cost a pixel of a 240x240 panel at a number of frames a second.
    budgets: [(f64, &'static str); 2],
}

const PANEL: f64 = 240.0 * 240.0;

pub(super) const M0PLUS: Core = Core {
    column: "m0_cycles_per_px",
    title: "Cortex-M0+: texel error against cycles, textures with depth",
    unit: "cycles per covered pixel, opt-level 3, strips of 16 rows",
    ends: [35.0, 500.0],
    budgets: [(133e6 / 60.0 / PANEL, "60 fps at 133 MHz"), (133e6 / 30.0 / PANEL, "30 fps at 133 MHz")],
};

pub(super) const M4: Core = Core {
    column: "m4_instructions_per_px",
    title: "Cortex-M4: texel error against instructions, textures with depth",
    unit: "instructions per covered pixel, opt-level 3, strips of 16 rows (rules: at one a cycle)",
    ends: [20.0, 150.0],
    budgets: [(168e6 / 60.0 / PANEL, "60 fps at 168 MHz"), (168e6 / 30.0 / PANEL, "30 fps at 168 MHz")],
};

pub(super) const HOST: Core = Core {
    column: "host_ns_per_px",
    title: "x86-64: texel error against time, textures with depth",
    unit: "ns per covered pixel, whole frames (30 and 60 fps are 579 and 289: to the right of all this)",
    ends: [1.0, 20.0],
    budgets: [(1e9 / 60.0 / PANEL, "60 fps"), (1e9 / 30.0 / PANEL, "30 fps")],
};

/// Texels: errors below are drawn at the lower edge, those above at the upper one.
const ERRORS: [f64; 2] = [1.5e-3, 100.0];

/// One method, over all scenes.
#[derive(Clone, Debug)]
struct Point {
    family: Family,
    setting: String,
    /// The geometric mean, the least and the most.
    cost: [f64; 3],
    /// The worst, the least and the most.
    error: [f64; 3],
    bound: f64,
}

fn points(table: &Table, column: &str) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::new();
    let mut counts: Vec<f64> = Vec::new();
    for row in table.records() {
        let Some(family) = Family::ALL.into_iter().find(|family| family.name() == row["family"]) else {
            continue;
        };
        let values = ["texel_worst", "texel_bound"].map(|name| number(&row, name));
        let (Some(cost), [Some(error), Some(bound)]) = (number(&row, column), values) else { continue };
        let setting = row["setting"].to_owned();
        let known = points.iter().position(|point| point.family == family && point.setting == setting);
        let place = known.unwrap_or_else(|| {
            let none = [0.0, f64::MAX, 0.0];
            points.push(Point { family, setting, cost: none, error: none, bound: 0.0 });
            counts.push(0.0);
            points.len() - 1
        });
        let point = &mut points[place];
        counts[place] += 1.0;
        point.cost = [point.cost[0] + cost.ln(), point.cost[1].min(cost), point.cost[2].max(cost)];
        let [worst, least, most] = point.error;
        point.error = [worst.max(error), least.min(error), most.max(error)];
        point.bound = point.bound.max(bound);
    }
    for (point, count) in points.iter_mut().zip(counts) {
        point.cost[0] = (point.cost[0] / count).exp();
    }
    points
}

fn shape(family: Family) -> Shape {
    Shape::ALL[Family::ALL.iter().position(|&other| other == family).unwrap_or_default() % Shape::ALL.len()]
}

/// Those that no other beats in both, from the cheapest.
fn front(points: &[Point]) -> Vec<&Point> {
    let mut sorted: Vec<&Point> = points.iter().collect();
    sorted.sort_by(|a, b| a.cost[0].total_cmp(&b.cost[0]));
    let mut least = f64::MAX;
    sorted.retain(|point| {
        let better = point.error[0] < least;
        least = least.min(point.error[0]);
        better
    });
    sorted
}

const FRONT: Colour = [200, 200, 200];

pub(super) fn draw(table: &Table, core: &Core) -> String {
    svg([860, 640], |canvas| {
        let panel = Panel {
            corners: [[80, 40], [690, 580]],
            x: Scale::log(core.ends, &[1.0, 2.0, 5.0]),
            y: Scale::log(ERRORS, &[1.0]),
        };
        panel.draw(canvas, core.title, core.unit, "largest texel error, in texels");
        let [low, high] = panel.corners;
        let mut labels = Labels::new([[low[0] + 3, low[1] + 3], [high[0] - 3, high[1] - 3]]);
        for (error, name) in [(0.0625, "1/16 texel"), (0.25, "1/4 texel"), (1.0, "1 texel")] {
            labels.keep_block_clear(panel.rule_across(canvas, error, name));
            labels.keep_line_clear(panel.x.ends.map(|cost| panel.at(cost, error)));
        }
        for (cost, name) in core.budgets {
            let Some(block) = panel.rule_upright(canvas, cost, name) else { continue };
            labels.keep_block_clear(block);
            labels.keep_line_clear([panel.at(cost, ERRORS[0]), panel.at(cost, ERRORS[1])]);
        }
        let points = points(table, core.column);
        draw_front(canvas, &panel, &front(&points));
        draw_points(canvas, &panel, &points, labels);
        legend(canvas, &points);
    })
}

fn draw_front(canvas: &Canvas<'_>, panel: &Panel, front: &[&Point]) {
    let mut stairs: Vec<[f64; 2]> = Vec::new();
    for point in front {
        let error = point.error[0];
        let before = stairs.last().map_or(panel.y.ends[1], |last| last[1]);
        stairs.extend([[point.cost[0], before], [point.cost[0], error]]);
    }
    stairs.extend(stairs.last().copied().map(|[_, error]| [panel.x.ends[1], error]));
    panel.line(canvas, &stairs, FRONT, 5);
}

fn draw_points(canvas: &Canvas<'_>, panel: &Panel, points: &[Point], mut labels: Labels) {
    for point in points {
        let [x, worst] = panel.at(point.cost[0], point.error[0]);
        let [_, bound] = panel.at(point.cost[0], point.bound);
        let [_, least] = panel.at(point.cost[0], point.error[1]);
        let [ends_left, ends_right] = [point.cost[1], point.cost[2]].map(|cost| panel.at(cost, 1.0)[0]);
        labels.keep_clear([x, worst]);
        labels.keep_clear([x, bound]);
        labels.keep_block_clear([[x - 1, bound], [x + 1, least]]);
        labels.keep_block_clear([[ends_left, worst - 1], [ends_right, worst + 1]]);
    }
    for family in Family::ALL {
        let of_family: Vec<&Point> = points.iter().filter(|point| point.family == family).collect();
        let values: Vec<_> = of_family.iter().map(|point| [point.cost[0], point.error[0]]).collect();
        let shape = shape(family);
        if values.len() > 1 {
            panel.line(canvas, &values, shape.colour, 2);
        }
        for pair in values.windows(2) {
            labels.keep_line_clear([pair[0], pair[1]].map(|[x, y]| panel.at(x, y)));
        }
        for point in of_family {
            let ([cost, least, most], [error, ..]) = (point.cost, point.error);
            panel.line(canvas, &[[least, error], [most, error]], shape.colour, 1);
            panel.line(canvas, &[[cost, point.error[1]], [cost, point.bound]], shape.colour, 1);
            shape.draw(canvas, panel.at(cost, point.bound), Fill::Hollow);
            shape.draw(canvas, panel.at(cost, error), Fill::Whole);
            panel.arrow(canvas, cost, panel.edge(error), shape.colour);
        }
    }
    for point in points {
        let name = if point.setting.is_empty() { point.family.name() } else { &point.setting };
        let beyond = match panel.edge(point.error[0]) {
            Edge::Above => format!("{name}: {:.0}", point.error[0]),
            Edge::Below => format!("{name}: {:.0e}", point.error[0]),
            Edge::Inside => name.to_owned(),
        };
        labels.write(canvas, &beyond, panel.at(point.cost[0], point.error[0]), shape(point.family).colour);
    }
}

fn legend(canvas: &Canvas<'_>, points: &[Point]) {
    let mut y = 60;
    let mut line = |draw: &dyn Fn([i32; 2]), text: &str| {
        draw([712, y]);
        canvas.text(text, [728, y], 13, [20; 3], Anchor::Left);
        y += 24;
    };
    for family in Family::ALL {
        if points.iter().any(|point| point.family == family) {
            line(&|at| shape(family).draw(canvas, at, Fill::Whole), family.name());
        }
    }
    line(&|at| Shape::STAR.draw(canvas, at, Fill::Hollow), "hollow: bound");
    line(&|[x, y]| canvas.line(&[[x - 8, y], [x + 8, y]], FRONT, 5), "Pareto front");
    line(&|[x, y]| canvas.line(&[[x - 8, y], [x + 8, y]], [20; 3], 1), "from scene to scene");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(cost: f64, error: f64) -> Point {
        Point {
            family: Family::Affine,
            setting: String::new(),
            cost: [cost; 3],
            error: [error; 3],
            bound: error,
        }
    }

    // Red when the front keeps what another beats in both, or goes by the table's order.
    #[test]
    fn the_front_is_what_nothing_beats() {
        let points = [point(3.0, 0.1), point(1.0, 9.0), point(2.0, 20.0), point(2.5, 1.0), point(4.0, 0.1)];
        let costs: Vec<f64> = front(&points).iter().map(|point| point.cost[0]).collect();
        assert_eq!(costs, [1.0, 2.5, 3.0]);
    }
}

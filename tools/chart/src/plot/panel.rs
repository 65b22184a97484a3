//! A panel: a frame with two scales, and places in it.

use super::canvas::{Anchor, BLACK, Canvas, Colour, GREY, LIGHT};
use super::scale::Scale;

/// A frame from its upper left corner to its lower right one, with an axis each way.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    pub(crate) corners: [[i32; 2]; 2],
    pub(crate) x: Scale,
    pub(crate) y: Scale,
}

/// Where a value lies beyond an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Edge {
    Inside,
    Above,
    Below,
}

impl Panel {
    /// Where two values are in the picture; those beyond an axis lie at its end.
    pub(crate) fn at(&self, x: f64, y: f64) -> [i32; 2] {
        let [[left, top], [right, bottom]] = self.corners;
        let along = |from: i32, to: i32, place: f64| from + (f64::from(to - from) * place).round() as i32;
        [along(left, right, self.x.place(x)), along(bottom, top, self.y.place(y))]
    }

    /// Whether a value is beyond the y axis.
    pub(crate) fn edge(&self, y: f64) -> Edge {
        let [low, high] = self.y.ends;
        if y > high {
            Edge::Above
        } else if y < low {
            Edge::Below
        } else {
            Edge::Inside
        }
    }

    /// Draws grid, frame, ticks and names.
    pub(crate) fn draw(&self, canvas: &Canvas<'_>, title: &str, x_name: &str, y_name: &str) {
        let [[left, top], [right, bottom]] = self.corners;
        for (value, label) in &self.x.ticks {
            let [x, _] = self.at(*value, self.y.ends[0]);
            canvas.line(&[[x, top], [x, bottom]], LIGHT, 1);
            canvas.text(label, [x, bottom + 14], 13, BLACK, Anchor::Middle);
        }
        for (value, label) in &self.y.ticks {
            let [_, y] = self.at(self.x.ends[0], *value);
            canvas.line(&[[left, y], [right, y]], LIGHT, 1);
            canvas.text(label, [left - 7, y], 13, BLACK, Anchor::Right);
        }
        self.frame(canvas);
        canvas.text(title, [left, top - 16], 16, BLACK, Anchor::Left);
        canvas.text(x_name, [i32::midpoint(left, right), bottom + 34], 14, BLACK, Anchor::Middle);
        canvas.upwards(y_name, [left - 58, i32::midpoint(top, bottom)], 14, BLACK);
    }

    /// Only the frame.
    pub(crate) fn frame(&self, canvas: &Canvas<'_>) {
        let [[left, top], [right, bottom]] = self.corners;
        canvas.line(&[[left, top], [right, top], [right, bottom], [left, bottom], [left, top]], GREY, 1);
    }

    /// A rule across, with its name at the right end, above it. What the name takes is told.
    pub(crate) fn rule_across(&self, canvas: &Canvas<'_>, y: f64, name: &str) -> [[i32; 2]; 2] {
        let [[left, _], [right, _]] = self.corners;
        let [_, row] = self.at(self.x.ends[0], y);
        canvas.dashed([left, row], [right, row], GREY, 5);
        canvas.text(name, [right - 4, row - 8], 12, GREY, Anchor::Right);
        [[right - 4 - super::canvas::width(name, 12), row - 15], [right, row - 1]]
    }

    /// A rule upright, with its name along it at its lower end; nothing where the axis does not reach it. What the name
    /// takes is told.
    pub(crate) fn rule_upright(&self, canvas: &Canvas<'_>, x: f64, name: &str) -> Option<[[i32; 2]; 2]> {
        let [[_, top], [_, bottom]] = self.corners;
        if !(self.x.ends[0]..=self.x.ends[1]).contains(&x) {
            return None;
        }
        let [column, _] = self.at(x, self.y.ends[0]);
        canvas.dashed([column, top], [column, bottom], GREY, 5);
        let long = super::canvas::width(name, 12);
        canvas.upwards(name, [column - 8, bottom - 4 - long / 2], 12, GREY);
        Some([[column - 15, bottom - 4 - long], [column - 1, bottom]])
    }

    /// A line through values.
    pub(crate) fn line(&self, canvas: &Canvas<'_>, values: &[[f64; 2]], colour: Colour, width: u32) {
        let points: Vec<_> = values.iter().map(|&[x, y]| self.at(x, y)).collect();
        canvas.line(&points, colour, width);
    }

    /// A small arrow at the upper or the lower edge: the value lies beyond it.
    pub(crate) fn arrow(&self, canvas: &Canvas<'_>, x: f64, edge: Edge, colour: Colour) {
        let [[_, top], [_, bottom]] = self.corners;
        let [column, _] = self.at(x, self.y.ends[0]);
        let (tip, tail) = match edge {
            Edge::Above => (top - 12, top - 4),
            Edge::Below => (bottom - 2, bottom - 10),
            Edge::Inside => return,
        };
        canvas.polygon(&[[column, tip], [column - 4, tail], [column + 4, tail]], colour, true);
    }
}

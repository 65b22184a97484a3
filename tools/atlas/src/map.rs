//! Maps of where methods break: a measured number for each cell of two axes, and the line where a bound says that a
//! threshold is crossed.

use crate::axis::{Axis, Bar, NOTHING, STEPS, step};
use crate::canvas::{Canvas, Colour, INK, LINE, PALE, Stands, text_width};

/// Whether a method is beyond a threshold at two values of the axes, by its bound.
pub(crate) type Beyond = Box<dyn Fn(f64, f64) -> bool>;

/// One method's map.
pub(crate) struct Panel {
    pub(crate) title: String,
    /// In rows from the lowest value of y; nothing where no case was found.
    pub(crate) values: Vec<Option<f64>>,
    /// What its line says, and beyond which values it runs.
    pub(crate) line: (String, Beyond),
}

/// Maps of several methods over the same axes.
pub(crate) struct Map {
    pub(crate) title: &'static str,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    /// Width and height of a cell in pixels.
    pub(crate) cell: [i32; 2],
    pub(crate) bar: Bar,
    /// What a value may be where a line is not crossed.
    pub(crate) allowed: f64,
    pub(crate) panels: Vec<Panel>,
    pub(crate) notes: Vec<String>,
}

const LINE_COLOUR: Colour = [230, 20, 20];
/// Where nothing was measured.
const UNKNOWN: Colour = PALE;

const LEFT: i32 = 76;
const TOP: i32 = 58;
const GAP: i32 = 26;
const BAR: i32 = 14;
const MARGIN: i32 = 10;

impl Map {
    /// Measures each cell of a panel by the values in its middle: a number, or nothing where there is no case.
    pub(crate) fn cells<M: Into<Option<f64>>>(
        x: &Axis,
        y: &Axis,
        measure: impl Fn(f64, f64) -> M,
    ) -> Vec<Option<f64>> {
        (0..y.cells)
            .flat_map(|row| (0..x.cells).map(move |column| (column, row)))
            .map(|(column, row)| measure(x.middle(column), y.middle(row)).into())
            .collect()
    }

    pub(crate) fn draw(&self) -> Canvas {
        let size = [self.x.cells as i32 * self.cell[0], self.y.cells as i32 * self.cell[1]];
        let count = self.panels.len() as i32;
        let bar_left = LEFT + count * (size[0] + GAP);
        let bar_width = self.bar.ticks.iter().map(|(_, label)| text_width(label)).max().unwrap_or(0);
        let width = (bar_left + BAR + 8 + bar_width.max(7 * 6) + MARGIN + 24)
            .max(self.notes.iter().map(|note| text_width(note) + 2 * MARGIN).max().unwrap_or(0));
        let under = TOP + size[1] + 38;
        let height = under + self.notes.len() as i32 * (LINE + 3) + MARGIN;
        let mut canvas = Canvas::new(width, height);
        canvas.heading([MARGIN, 8], self.title);
        canvas.text_upwards([MARGIN, TOP + size[1] / 2], self.y.name);
        for (panel, index) in self.panels.iter().zip(0..) {
            let left = LEFT + index * (size[0] + GAP);
            panel.draw(&mut canvas, [left, TOP], self);
            self.ticks(&mut canvas, [left, TOP], size, index == 0);
            canvas.text([left + size[0] / 2, TOP + size[1] + 20], self.x.name, Stands::Centred);
        }
        self.scale(&mut canvas, [bar_left, TOP], size[1]);
        for (note, index) in self.notes.iter().zip(0..) {
            canvas.text([MARGIN, under + index * (LINE + 3)], note, Stands::Right);
        }
        canvas
    }

    fn ticks(&self, canvas: &mut Canvas, [left, top]: [i32; 2], [width, height]: [i32; 2], labels: bool) {
        canvas.frame([left, top], [width, height], INK);
        for (value, label) in &self.x.ticks {
            let x = left + (self.x.place(*value) * f64::from(width)).round() as i32;
            canvas.fill([x, top + height + 1], [1, 3], INK);
            canvas.text([x, top + height + 6], label, Stands::Centred);
        }
        for (value, label) in &self.y.ticks {
            let y = top + height - (self.y.place(*value) * f64::from(height)).round() as i32;
            canvas.fill([left - 4, y], [3, 1], INK);
            if labels {
                canvas.text([left - 7, y - LINE / 2], label, Stands::Left);
            }
        }
    }

    fn scale(&self, canvas: &mut Canvas, [left, top]: [i32; 2], height: i32) {
        let zero = LINE + 10;
        let long = height - 2 * zero;
        canvas.frame([left, top], [BAR, long], INK);
        for y in 0..long {
            canvas.fill([left, top + y], [BAR, 1], step((long - 1 - y) * STEPS / long));
        }
        for (value, label) in &self.bar.ticks {
            let y = top + long - (self.bar.place(*value) * f64::from(long)).round() as i32;
            canvas.fill([left + BAR + 1, y.min(top + long - 1)], [3, 1], INK);
            canvas.text([left + BAR + 6, y - LINE / 2], label, Stands::Right);
        }
        canvas.text([left, top - LINE - 4], self.bar.name, Stands::Right);
        let unknown = self.panels.iter().any(|panel| panel.values.contains(&None));
        let boxes = [(NOTHING, "0", height - 2 * zero + 8), (UNKNOWN, "no case", height - zero + 6)];
        for (colour, label, y) in boxes.into_iter().take(1 + usize::from(unknown)) {
            canvas.frame([left, top + y], [BAR, LINE], INK);
            canvas.fill([left, top + y], [BAR, LINE], colour);
            canvas.text([left + BAR + 6, top + y], label, Stands::Right);
        }
    }
}

impl Panel {
    /// A bound that does not hold is not drawn.
    fn check(&self, map: &Map) {
        let Map { x, y, allowed, .. } = map;
        for (index, value) in self.values.iter().enumerate() {
            let (x, y) = (x.middle(index % x.cells), y.middle(index / x.cells));
            let within = self.line.1(x, y) || value.is_none_or(|value| value <= *allowed);
            assert!(within, "{}: {value:?} at {x}, {y} is more than the bound says", self.title);
        }
    }

    fn draw(&self, canvas: &mut Canvas, [left, top]: [i32; 2], map: &Map) {
        let Map { x, y, cell, bar, .. } = map;
        let size = [x.cells as i32 * cell[0], y.cells as i32 * cell[1]];
        assert_eq!(self.values.len(), x.cells * y.cells, "{}: a value for each cell", self.title);
        canvas.text([left, 28], &self.title, Stands::Right);
        for (index, value) in self.values.iter().enumerate() {
            let (column, row) = ((index % x.cells) as i32, (index / x.cells) as i32);
            let at = [left + column * cell[0], top + size[1] - (row + 1) * cell[1]];
            canvas.fill(at, *cell, value.map_or(UNKNOWN, |value| bar.colour(value)));
        }
        let (label, beyond) = &self.line;
        self.check(map);
        canvas.fill([left, 45], [12, 2], LINE_COLOUR);
        canvas.text([left + 16, 41], label, Stands::Right);
        let at = |px: i32, py: i32| {
            let place = |pixel: i32, length: i32| (f64::from(pixel) + 0.5) / f64::from(length);
            beyond(x.value(place(px, size[0])), y.value(1.0 - place(py, size[1])))
        };
        for py in 0..size[1] - 1 {
            for px in 0..size[0] - 1 {
                let here = at(px, py);
                if here != at(px + 1, py) || here != at(px, py + 1) {
                    canvas.fill([left + px, top + py], [2; 2], LINE_COLOUR);
                }
            }
        }
    }
}

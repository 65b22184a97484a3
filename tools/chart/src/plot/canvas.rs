//! An SVG in pixels: lines, shapes and text.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::FontTransform;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Red, green and blue.
pub(crate) type Colour = [u8; 3];

pub(crate) const BLACK: Colour = [20, 20, 20];
pub(crate) const GREY: Colour = [110, 110, 110];
pub(crate) const LIGHT: Colour = [224, 224, 224];

/// Which point of a text stands at its place: left, middle or right, all at half of its height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Left,
    Middle,
    Right,
}

/// What is drawn on.
pub(crate) struct Canvas<'c> {
    area: DrawingArea<SVGBackend<'c>, Shift>,
}

/// The text of an SVG of this width and height, white before `draw`.
pub(crate) fn svg(size: [u32; 2], draw: impl FnOnce(&Canvas<'_>)) -> String {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (size[0], size[1])).into_drawing_area();
        let canvas = Canvas { area };
        canvas.area.fill(&WHITE).expect(MEMORY);
        draw(&canvas);
        canvas.area.present().expect(MEMORY);
    }
    text
}

const MEMORY: &str = "a string takes all that is written";

fn rgb([r, g, b]: Colour) -> RGBColor {
    RGBColor(r, g, b)
}

impl Canvas<'_> {
    /// A line through points.
    pub(crate) fn line(&self, points: &[[i32; 2]], colour: Colour, width: u32) {
        let points: Vec<_> = points.iter().map(|&[x, y]| (x, y)).collect();
        self.area.draw(&PathElement::new(points, rgb(colour).stroke_width(width))).expect(MEMORY);
    }

    /// A straight line in dashes of `dash` pixels with as long gaps.
    pub(crate) fn dashed(&self, from: [i32; 2], to: [i32; 2], colour: Colour, dash: i32) {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = f64::from(dx).hypot(f64::from(dy));
        let at =
            |along: f64| [0, 1].map(|k| from[k] + (f64::from([dx, dy][k]) * along / length).round() as i32);
        let mut along = 0.0;
        while along < length {
            self.line(&[at(along), at((along + f64::from(dash)).min(length))], colour, 1);
            along += 2.0 * f64::from(dash);
        }
    }

    /// A polygon, filled or as its outline.
    pub(crate) fn polygon(&self, points: &[[i32; 2]], colour: Colour, filled: bool) {
        let mut points: Vec<_> = points.iter().map(|&[x, y]| (x, y)).collect();
        if filled {
            self.area.draw(&Polygon::new(points, rgb(colour).filled())).expect(MEMORY);
        } else {
            points.extend(points.first().copied());
            self.area.draw(&PathElement::new(points, rgb(colour).stroke_width(2))).expect(MEMORY);
        }
    }

    /// A circle, filled or as its outline.
    pub(crate) fn circle(&self, [x, y]: [i32; 2], radius: i32, colour: Colour, filled: bool) {
        let style = if filled { rgb(colour).filled() } else { rgb(colour).stroke_width(2) };
        self.area.draw(&Circle::new((x, y), radius, style)).expect(MEMORY);
    }

    /// A filled rectangle from one corner to the other.
    pub(crate) fn block(&self, from: [i32; 2], to: [i32; 2], colour: Colour) {
        let corners = [(from[0], from[1]), (to[0], to[1])];
        self.area.draw(&Rectangle::new(corners, rgb(colour).filled())).expect(MEMORY);
    }

    /// Text of a height in pixels.
    pub(crate) fn text(&self, text: &str, [x, y]: [i32; 2], height: i32, colour: Colour, anchor: Anchor) {
        let style = style(height, colour, anchor);
        self.area.draw(&Text::new(text.to_owned(), (x, y), style)).expect(MEMORY);
    }

    /// Text that runs upwards, its middle at the place.
    pub(crate) fn upwards(&self, text: &str, [x, y]: [i32; 2], height: i32, colour: Colour) {
        let font = ("sans-serif", height).into_font().transform(FontTransform::Rotate270);
        let style = font.color(&rgb(colour)).pos(Pos::new(HPos::Center, VPos::Center));
        self.area.draw(&Text::new(text.to_owned(), (x, y), style)).expect(MEMORY);
    }
}

fn style(height: i32, colour: Colour, anchor: Anchor) -> TextStyle<'static> {
    let across = match anchor {
        Anchor::Left => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::Right => HPos::Right,
    };
    ("sans-serif", height).into_font().color(&rgb(colour)).pos(Pos::new(across, VPos::Center))
}

/// How wide a text is at the most: fonts differ from viewer to viewer.
pub(crate) fn width(text: &str, height: i32) -> i32 {
    (text.chars().count() as i32 * height * 58 + 99) / 100
}

//! What pictures are put together on: pixels, filled boxes and text.

use std::convert::Infallible;

use embedded_graphics::mono_font::ascii::{FONT_6X10, FONT_7X13_BOLD};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Alignment, Baseline, Text, TextStyleBuilder};

/// Red, green, blue.
pub(crate) type Colour = [u8; 3];

pub(crate) const PAPER: Colour = [255; 3];
pub(crate) const INK: Colour = [32; 3];
pub(crate) const PALE: Colour = [208; 3];

/// The width of a letter, and the height of a line.
const LETTER: i32 = 6;
pub(crate) const LINE: i32 = 10;

/// Where text stands from its point.
#[derive(Clone, Copy)]
pub(crate) enum Stands {
    Right,
    Centred,
    Left,
}

/// A picture in rows from the top.
pub(crate) struct Canvas {
    width: i32,
    height: i32,
    pixels: Vec<Colour>,
}

impl Canvas {
    pub(crate) fn new(width: i32, height: i32) -> Self {
        Self { width, height, pixels: vec![PAPER; (width * height) as usize] }
    }

    pub(crate) fn size(&self) -> [i32; 2] {
        [self.width, self.height]
    }

    pub(crate) fn pixels(&self) -> &[Colour] {
        &self.pixels
    }

    /// Sets a pixel. All that is drawn must lie on the canvas: a label that does not fit is a mistake.
    #[track_caller]
    pub(crate) fn set(&mut self, x: i32, y: i32, colour: Colour) {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        assert!(inside, "{x}, {y} is not on a canvas of {}x{}", self.width, self.height);
        self.pixels[(y * self.width + x) as usize] = colour;
    }

    #[track_caller]
    pub(crate) fn fill(&mut self, [left, top]: [i32; 2], [width, height]: [i32; 2], colour: Colour) {
        for y in top..top + height {
            for x in left..left + width {
                self.set(x, y, colour);
            }
        }
    }

    /// The outline just round a box.
    pub(crate) fn frame(&mut self, [left, top]: [i32; 2], [width, height]: [i32; 2], colour: Colour) {
        self.fill([left - 1, top - 1], [width + 2, 1], colour);
        self.fill([left - 1, top + height], [width + 2, 1], colour);
        self.fill([left - 1, top], [1, height], colour);
        self.fill([left + width, top], [1, height], colour);
    }

    /// A line of text whose upper edge is at `at`.
    pub(crate) fn text(&mut self, at: [i32; 2], text: &str, stands: Stands) {
        self.write(&FONT_6X10, at, text, stands);
    }

    /// A line of bold text.
    pub(crate) fn heading(&mut self, at: [i32; 2], text: &str) {
        self.write(&FONT_7X13_BOLD, at, text, Stands::Right);
    }

    /// A line of text that runs upwards, its middle at `at`, its upper edge to the left.
    pub(crate) fn text_upwards(&mut self, [x, y]: [i32; 2], text: &str) {
        let mut lying = Self::new(text_width(text), LINE);
        lying.text([0, 0], text, Stands::Right);
        for (index, &colour) in lying.pixels.iter().enumerate() {
            let (along, down) = (index as i32 % lying.width, index as i32 / lying.width);
            self.set(x + down, y + lying.width / 2 - along, colour);
        }
    }

    fn write(&mut self, font: &MonoFont<'_>, [x, y]: [i32; 2], text: &str, stands: Stands) {
        assert!(text.is_ascii(), "the fonts have no letter for all of: {text}");
        let alignment = match stands {
            Stands::Right => Alignment::Left,
            Stands::Centred => Alignment::Center,
            Stands::Left => Alignment::Right,
        };
        let style = TextStyleBuilder::new().alignment(alignment).baseline(Baseline::Top).build();
        let ink = MonoTextStyle::new(font, Rgb888::new(INK[0], INK[1], INK[2]));
        let Ok(_) = Text::with_text_style(text, Point::new(x, y), ink, style).draw(self);
    }
}

/// How wide a line of plain text is.
pub(crate) fn text_width(text: &str) -> i32 {
    text.len() as i32 * LETTER
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.width.unsigned_abs(), self.height.unsigned_abs())
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, colour) in pixels {
            self.set(at.x, at.y, [colour.r(), colour.g(), colour.b()]);
        }
        Ok(())
    }
}

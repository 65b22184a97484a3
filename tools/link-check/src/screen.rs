//! A display: what is sent to it is looked at by nobody, but the compiler cannot know.

use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Size};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::primitives::Rectangle;
use embedded_graphics_core::{Pixel, prelude::IntoStorage};

/// Pixels in a row, and rows.
pub(crate) const SIZE: Size = Size::new(240, 240);

/// A display of [`SIZE`].
pub(crate) struct Screen {
    pixels_sent: u32,
}

impl Screen {
    pub(crate) const fn new() -> Self {
        Self { pixels_sent: 0 }
    }

    fn send(&mut self, colour: Rgb565) {
        black_box(colour.into_storage());
        self.pixels_sent = self.pixels_sent.wrapping_add(1);
    }
}

impl OriginDimensions for Screen {
    fn size(&self) -> Size {
        black_box(SIZE)
    }
}

impl DrawTarget for Screen {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(_, colour) in pixels {
            self.send(colour);
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colours: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        black_box(area);
        for colour in colours {
            self.send(colour);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        black_box(area);
        self.send(colour);
        Ok(())
    }
}

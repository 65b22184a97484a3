//! A frame as a draw target: pixels and rectangles of one colour are written as directly as they can be.

use embedded_graphics::pixelcolor::{IntoStorage, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

use crate::grid::SIZE;

/// RGB565 words.
#[derive(Debug)]
pub(super) struct Frame(pub(super) Vec<u16>);

impl Default for Frame {
    fn default() -> Self {
        Self(vec![0; SIZE * SIZE])
    }
}

impl OriginDimensions for Frame {
    fn size(&self) -> Size {
        Size::new(SIZE as u32, SIZE as u32)
    }
}

impl DrawTarget for Frame {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    #[inline(always)]
    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, colour) in pixels {
            let (x, y) = (x as usize, y as usize);
            if x < SIZE && y < SIZE {
                self.0[y * SIZE + x] = colour.into_storage();
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Self::Error> {
        let area = area.intersection(&self.bounding_box());
        let (left, width) = (area.top_left.x as usize, area.size.width as usize);
        for y in area.rows() {
            let start = y as usize * SIZE + left;
            self.0[start..start + width].fill(colour.into_storage());
        }
        Ok(())
    }
}

//! The line that says how much of a scene is missing.

use core::fmt::Write;

use embedded_graphics::mono_font::{MonoTextStyleBuilder, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Alignment, Text};
use heapless::String;

use crate::PANEL;

/// Writes how many triangles were left out at the bottom of the panel, unless none were.
///
/// # Errors
/// What the target returned.
pub fn label<D: DrawTarget<Color = Rgb565>>(target: &mut D, left_out: usize) -> Result<(), D::Error> {
    if left_out == 0 {
        return Ok(());
    }
    let mut text = String::<40>::new();
    // Ten digits at the most: it fits.
    let _ = write!(text, " {left_out} triangles left out ");
    let style = MonoTextStyleBuilder::new()
        .font(&FONT_6X10)
        .text_color(Rgb565::WHITE)
        .background_color(Rgb565::BLACK)
        .build();
    let at = Point::new(PANEL.width as i32 / 2, PANEL.height as i32 - 6);
    Text::with_alignment(&text, at, style, Alignment::Center).draw(target).map(|_| ())
}

/// Some rows of the panel in memory, as a target: what is drawn elsewhere does not matter.
#[derive(Debug)]
pub struct Cells<'c> {
    cells: &'c mut [u16],
    /// The row of the panel that the first cells show.
    top: usize,
}

impl<'c> Cells<'c> {
    /// Whole rows of the panel from `top` on.
    pub const fn new(cells: &'c mut [u16], top: usize) -> Self {
        Self { cells, top }
    }
}

impl OriginDimensions for Cells<'_> {
    fn size(&self) -> Size {
        PANEL
    }
}

impl DrawTarget for Cells<'_> {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        let width = PANEL.width as usize;
        for Pixel(at, colour) in pixels {
            let (Ok(x), Ok(y)) = (usize::try_from(at.x), usize::try_from(at.y)) else { continue };
            let Some(row) = y.checked_sub(self.top).filter(|_| x < width) else { continue };
            if let Some(cell) = self.cells.get_mut(row * width + x) {
                *cell = colour.into_storage();
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec;

    const ALL: usize = (PANEL.width * PANEL.height) as usize;

    /// Red when: a strip starts at another row than it says, or writes beyond its own.
    #[test]
    fn strips_show_what_a_whole_frame_shows() {
        let mut frame = vec![7; ALL];
        label(&mut Cells::new(&mut frame, 0), 1234).unwrap();
        assert!(frame.contains(&0xFFFF) && frame[..ALL / 2].iter().all(|&cell| cell == 7));
        for rows in [1, 16, 24] {
            let mut strips = vec![7; ALL];
            for (number, strip) in strips.chunks_mut(rows * PANEL.width as usize).enumerate() {
                label(&mut Cells::new(strip, number * rows), 1234).unwrap();
            }
            assert_eq!(strips, frame);
        }
    }

    /// Red when: the line is written although nothing was left out.
    #[test]
    fn nothing_is_written_where_all_fits() {
        let mut frame = vec![7; ALL];
        label(&mut Cells::new(&mut frame, 0), 0).unwrap();
        assert!(frame.iter().all(|&cell| cell == 7));
    }
}

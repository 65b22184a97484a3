//! Stage 8. What a frame is drawn into: colours, depth and which triangle is seen, all unrounded.

use crate::depth::{CLEAR, code};
use crate::shade::{Rgb, from_rgb565, to_rgb565, to_rgb888};
use crate::transform::Viewport;

/// What is known of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Code values 0 to 255.
    pub colour: Rgb,
    /// In codes, not rounded; 0 where no triangle wrote a depth.
    pub depth: f64,
    /// The face that is seen, or none where the background is.
    pub face: Option<u32>,
    /// How often a colour was written: 1 everywhere means no overdraw and no hole.
    pub writes: u32,
}

/// A frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    viewport: Viewport,
    pixels: Vec<Pixel>,
}

impl Image {
    /// A frame of the background's colour, with a cleared depth.
    pub fn new(viewport: Viewport, background: Rgb) -> Self {
        let blank = Pixel { colour: background, depth: f64::from(CLEAR), face: None, writes: 0 };
        Self { viewport, pixels: vec![blank; viewport.width as usize * viewport.height as usize] }
    }

    /// The size.
    pub fn viewport(&self) -> Viewport {
        self.viewport
    }

    /// All pixels, in rows from the top.
    pub fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// The pixel in column `x` and row `y`.
    ///
    /// # Panics
    /// There is none.
    pub fn pixel(&self, x: u32, y: u32) -> &Pixel {
        assert!(x < self.viewport.width && y < self.viewport.height, "no pixel at {x}, {y}");
        &self.pixels[y as usize * self.viewport.width as usize + x as usize]
    }

    /// As [`Self::pixel`], for writing.
    pub(crate) fn pixel_mut(&mut self, x: u32, y: u32) -> &mut Pixel {
        &mut self.pixels[y as usize * self.viewport.width as usize + x as usize]
    }

    /// The colours as a 16-bit display shows them.
    pub fn rgb565(&self) -> Vec<u16> {
        self.pixels.iter().map(|pixel| to_rgb565(pixel.colour)).collect()
    }

    /// The colours as bytes.
    pub fn rgb888(&self) -> Vec<[u8; 3]> {
        self.pixels.iter().map(|pixel| to_rgb888(pixel.colour)).collect()
    }

    /// The depth buffer: one code a pixel.
    pub fn depth_codes(&self) -> Vec<u16> {
        self.pixels.iter().map(|pixel| code(pixel.depth)).collect()
    }

    /// The same frame with the colours that a 16-bit display can show.
    #[must_use]
    pub fn quantised(&self) -> Self {
        let mut result = self.clone();
        for pixel in &mut result.pixels {
            pixel.colour = from_rgb565(to_rgb565(pixel.colour));
        }
        result
    }
}

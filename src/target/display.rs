//! Straight to a display: a run is one `fill_contiguous`, or one `fill_solid`, without any buffer.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::pipeline::{Shading, Surface};
use crate::pixel::Pixel;
use crate::raster::{Span, Window};
use crate::shade::PixelShader;
use crate::varying::Varying;

/// A target that is drawn to run by run.
pub(crate) struct Display<'t, T> {
    pub(crate) target: &'t mut T,
    /// Where column 0 of row 0 is.
    pub(crate) origin: Point,
    pub(crate) window: Window,
}

impl<P: Pixel, T: DrawTarget<Color = P>> Surface<P, ()> for Display<'_, T>
where
    P: embedded_graphics_core::prelude::PixelColor,
{
    type Error = T::Error;

    fn window(&self) -> &Window {
        &self.window
    }

    fn span<'a, S: PixelShader<'a, P>>(
        &mut self,
        span: Span,
        _: ((), ()),
        shading: Shading<'_, S, S::Triangle, S::Varying>,
    ) -> Result<(), T::Error> {
        let length = (span.end - span.start).unsigned_abs();
        let at = Point::new(self.origin.x.saturating_add(span.start), self.origin.y.saturating_add(span.y));
        let area = Rectangle::new(at, Size::new(length, 1));
        match shading.shader.solid(shading.triangle) {
            Some(colour) => self.target.fill_solid(&area, colour),
            None => self.target.fill_contiguous(&area, Colours::new(shading, length)),
        }
    }
}

/// Pixels shaded at a time.
const CHUNK: u32 = 16;

/// The colours of a run, shaded a few pixels ahead.
struct Colours<'t, S, T, V, P> {
    shading: Shading<'t, S, T, V>,
    chunk: [P; CHUNK as usize],
    /// The next pixel of the run, and how many it has.
    next: u32,
    length: u32,
}

impl<'t, S, T, V, P: Pixel> Colours<'t, S, T, V, P> {
    fn new(shading: Shading<'t, S, T, V>, length: u32) -> Self {
        Self { shading, chunk: [P::from_channels([0; 3]); CHUNK as usize], next: 0, length }
    }
}

impl<'a, S: PixelShader<'a, P>, P: Pixel> Iterator for Colours<'_, S, S::Triangle, S::Varying, P> {
    type Item = P;

    fn next(&mut self) -> Option<P> {
        if self.next == self.length {
            return None;
        }
        let within = self.next % CHUNK;
        if within == 0 {
            let Shading { shader, triangle, start, step } = &self.shading;
            let start = start.plus(step.times(self.next.cast_signed()));
            let length = CHUNK.min(self.length - self.next) as usize;
            shader.shade(triangle, start, *step, self.chunk.get_mut(..length).unwrap_or_default());
        }
        self.next += 1;
        self.chunk.get(within as usize).copied()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = (self.length - self.next) as usize;
        (left, Some(left))
    }
}

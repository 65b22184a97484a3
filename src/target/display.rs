//! Straight to a display: a run is one `fill_contiguous`, or one `fill_solid`, without any buffer.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::depth::NoDepth;
use crate::gradients::Plane;
use crate::pipeline::{Shading, Surface};
use crate::pixel::Pixel;
use crate::raster::Span;
use crate::run::Run;
use crate::shade::PixelShader;

/// A target that is drawn to run by run.
pub(crate) struct Display<'t, T> {
    pub(crate) target: &'t mut T,
    /// Where column 0 of row 0 is.
    pub(crate) origin: Point,
}

impl<T> Display<'_, T> {
    /// The same target, for one triangle.
    pub(crate) fn lend(&mut self) -> Display<'_, T> {
        Display { origin: self.origin, target: self.target }
    }
}

impl<P: Pixel, T: DrawTarget<Color = P>> Surface<P, NoDepth> for Display<'_, T>
where
    P: embedded_graphics_core::prelude::PixelColor,
{
    type Error = T::Error;

    fn span<'a, S: PixelShader<'a, P>>(
        &mut self,
        span: Span,
        _: &Plane<()>,
        shading: &Shading<'a, P, S>,
    ) -> Result<(), T::Error> {
        let length = (span.end - span.start).unsigned_abs();
        let at = Point::new(self.origin.x.saturating_add(span.start), self.origin.y.saturating_add(span.y));
        let area = Rectangle::new(at, Size::new(length, 1));
        match shading.solid() {
            Some(colour) => self.target.fill_solid(&area, colour),
            None => self.target.fill_contiguous(&area, Colours::new(shading, span)),
        }
    }
}

/// Pixels shaded at a time.
const CHUNK: i32 = 16;

/// The colours of a span, shaded a few pixels ahead.
struct Colours<'t, 'a, P, S: PixelShader<'a, P>> {
    shading: &'t Shading<'a, P, S>,
    chunk: [P; CHUNK as usize],
    /// How many of the chunk are shaded, and which of them comes next.
    length: usize,
    within: usize,
    /// What is not shaded yet.
    rest: Span,
}

impl<'t, 'a, P: Pixel, S: PixelShader<'a, P>> Colours<'t, 'a, P, S> {
    fn new(shading: &'t Shading<'a, P, S>, rest: Span) -> Self {
        let chunk = [P::from_channels([0; 3]); CHUNK as usize];
        Self { shading, chunk, length: 0, within: 0, rest }
    }
}

impl<'a, P: Pixel, S: PixelShader<'a, P>> Iterator for Colours<'_, 'a, P, S> {
    type Item = P;

    fn next(&mut self) -> Option<P> {
        if self.within == self.length {
            let Span { y, start, end } = self.rest;
            self.length = CHUNK.min(end - start).max(0) as usize;
            let colours = self.chunk.get_mut(..self.length).filter(|colours| !colours.is_empty())?;
            self.shading.shade(start, y, Run::new(colours));
            self.rest.start += self.length as i32;
            self.within = 0;
        }
        let colour = self.chunk.get(self.within).copied();
        self.within += 1;
        colour
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = (self.rest.end - self.rest.start).max(0) as usize + self.length - self.within;
        (left, Some(left))
    }
}

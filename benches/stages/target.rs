//! A strip that is cleared, and one that is sent to a display.

use core::convert::Infallible;

use criterion::{Criterion, Throughput};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scenes::{View, by_name};
use topleft::{Depth16, DrawList, ListTriangle, Strip};

use crate::{FITS, PANEL};

/// A display that takes rectangles of pixels.
struct Display(Vec<Rgb565>);

impl OriginDimensions for Display {
    fn size(&self) -> Size {
        PANEL
    }
}

impl DrawTarget for Display {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, colour) in pixels {
            self.0[at.y as usize * PANEL.width as usize + at.x as usize] = colour;
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        let start = area.top_left.y as usize * PANEL.width as usize;
        self.0[start..].iter_mut().zip(colours).for_each(|(pixel, colour)| *pixel = colour);
        Ok(())
    }
}

pub(crate) fn bench(criterion: &mut Criterion) {
    const PIXELS: usize = 240 * 16;
    let (mut words, mut triangles) = (vec![0; 1 << 15], vec![ListTriangle::EMPTY; 2000]);
    let (mut colours, mut depths) = ([Rgb565::BLACK; PIXELS], [0; PIXELS]);
    let strip = Strip::new(PANEL.width as u16, &mut colours).expect("whole rows");
    let mut strip = strip.with_depth(&mut depths).expect("as many");
    let mut group = criterion.benchmark_group("target");
    group.throughput(Throughput::Elements(PIXELS as u64));
    group.bench_function("clear 16 rows", |bencher| bencher.iter(|| strip.clear()));

    let mut display = Display(vec![Rgb565::BLACK; (PANEL.width * PANEL.height) as usize]);
    let mut list = DrawList::<Rgb565, Depth16>::new(&mut words, &mut triangles);
    by_name("cube").expect("it is there").draw(&mut list, PANEL, &View::default()).expect(FITS);
    group.throughput(Throughput::Elements(u64::from(PANEL.width * PANEL.height)));
    group.bench_function("present a cube in 15 strips", |bencher| {
        bencher.iter(|| list.present(&mut strip, &mut display));
    });
    group.finish();
}

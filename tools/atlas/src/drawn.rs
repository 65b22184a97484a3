//! What the library draws, as pictures.

use core::convert::Infallible;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::{DrawTarget, Drawable as _, OriginDimensions, Pixel, RgbColor as _, Size};
use reference::naive::screen_clip::Valued;
use reference::setup::Triangle;
use reference::shade::to_rgb565;
use scenes::{Scene, View};
use topleft::stages::{Gradients, Setup, Snapped, Span, Traversal, Window};
use topleft::{Attribute, Coord, Depth16, DrawList, ListTriangle, Point, ShadedTriangle, Spans, Strip};

use crate::canvas::Colour;
use crate::planes;
use crate::strip::Picture;

/// Behind what is drawn without a scene.
pub(crate) const BACKGROUND: Colour = [16, 20, 40];

/// Whatever is put into a list, on a background, as one frame.
pub(crate) fn frame(
    size: Size,
    background: [u8; 3],
    fill: impl for<'s> FnOnce(&mut DrawList<'s, u16, Depth16>),
) -> Picture {
    let (mut words, mut triangles) = (vec![0; 1 << 16], vec![ListTriangle::EMPTY; 4000]);
    let cells = (size.width * size.height) as usize;
    let (mut colours, mut depths) = (vec![0; cells], vec![0; cells]);
    let mut list = DrawList::new(&mut words, &mut triangles);
    fill(&mut list);
    let strip = Strip::new(size.width as u16, &mut colours).and_then(|strip| strip.with_depth(&mut depths));
    let mut strip = strip.expect("whole rows").with_background(to_rgb565(background.map(f64::from)));
    strip.clear();
    list.render(0..size.height as i32, &mut strip);
    Picture::from_rgb565(size.width as usize, colours)
}

/// A scene.
pub(crate) fn scene(scene: &Scene, size: Size, view: &View) -> Picture {
    frame(size, scene.background, |list| scene.draw(list, size, view).expect("the list is long enough"))
}

/// Calls `each` with a triangle's spans in a window, and with how it was set up: its gradients and the order of its
/// corners. Not at all for one that has no area.
pub(crate) fn spans(triangle: Triangle, window: &Window, mut each: impl FnMut(Span, &Gradients, [usize; 3])) {
    let corners = triangle.map(|[x, y]| Snapped::from_bits(x, y));
    let Some((setup, order)) = Setup::new(corners) else { return };
    let gradients = setup.gradients();
    let Ok(()) = Spans::walk(&setup, window, |span| {
        each(span, &gradients, order);
        Ok::<_, Infallible>(())
    });
}

/// Whether the viewer sees a triangle's front, once it is snapped.
pub(crate) fn is_front(triangle: Triangle) -> bool {
    let corners = triangle.map(|[x, y]| Snapped::from_bits(x, y));
    Setup::new(corners).is_some_and(|(setup, order)| {
        let kept_round = matches!(order, [0, 1, 2] | [1, 2, 0] | [2, 0, 1]);
        (setup.area2() < 0) == kept_round
    })
}

/// How often triangles hit each pixel of a target.
pub(crate) fn hits(triangles: &[Triangle], width: i32, height: i32) -> Vec<u32> {
    let mut hits = vec![0; (width * height) as usize];
    for &triangle in triangles {
        spans(triangle, &Window { columns: 0..width, rows: 0..height }, |span, _, _| {
            for x in span.start..span.end {
                hits[(span.y * width + x) as usize] += 1;
            }
        });
    }
    hits
}

/// How often a display's pixels are sent when triangles are drawn to it one by one, with clipping.
pub(crate) fn sent(triangles: &[Triangle], size: Size) -> Vec<u32> {
    let mut display = Sent::new(size);
    for triangle in triangles {
        let corners = triangle.map(|[x, y]| Point::new(Coord::from_bits(x), Coord::from_bits(y)));
        let Ok(()) = ShadedTriangle::flat(corners, Rgb565::WHITE).draw(&mut display);
    }
    display.counts
}

/// A display that counts.
pub(crate) struct Sent {
    size: Size,
    /// How often each pixel was sent, in rows from the top.
    pub(crate) counts: Vec<u32>,
}

impl Sent {
    pub(crate) fn new(size: Size) -> Self {
        Self { size, counts: vec![0; (size.width * size.height) as usize] }
    }
}

impl OriginDimensions for Sent {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Sent {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, _) in pixels {
            self.counts[(at.y * self.size.width as i32 + at.x) as usize] += 1;
        }
        Ok(())
    }
}

/// Calls `each` with column, row and what an attribute is at each pixel of a triangle in a window.
pub(crate) fn values(
    triangle: Triangle,
    values: [f64; 3],
    window: &Window,
    mut each: impl FnMut(i32, i32, f64),
) {
    planes::values(triangle, values.map(Attribute::from_num), window, |x, y, value: Attribute| {
        each(x, y, value.to_num());
    });
}

/// Greys over triangles, later ones over earlier ones.
pub(crate) fn greys(shaded: &[Valued], side: i32) -> Picture {
    greys_in_strips(shaded, side, side as usize)
}

/// The same, so many rows at a time.
pub(crate) fn greys_in_strips(shaded: &[Valued], side: i32, rows: usize) -> Picture {
    let mut pixels = vec![BACKGROUND; (side * side) as usize];
    for top in (0..side).step_by(rows) {
        let window = Window { columns: 0..side, rows: top..(top + rows as i32).min(side) };
        for &(triangle, greys) in shaded {
            values(triangle, greys, &window, |x, y, grey| {
                pixels[(y * side + x) as usize] = [grey.round().clamp(0.0, 255.0) as u8; 3];
            });
        }
    }
    Picture::new(side as usize, pixels)
}

//! Targets that count what is drawn to them.

use core::convert::Infallible;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::primitives::Rectangle;

/// A target that counts, and that no one may draw beyond.
pub(crate) struct Counting {
    pub(crate) area: Rectangle,
    /// How often each pixel was drawn, in rows from the top.
    pub(crate) hits: Vec<u32>,
}

impl Counting {
    pub(crate) fn new(left: i32, top: i32, width: u32, height: u32) -> Self {
        let area = Rectangle::new(Point::new(left, top), Size::new(width, height));
        Self { area, hits: vec![0; (width * height) as usize] }
    }

    /// Counts the pixels of an area: one row, inside the target.
    fn count(&mut self, area: &Rectangle) {
        let inside = area.intersection(&self.area);
        assert_eq!(inside, *area, "drawn outside of {:?}", self.area);
        for y in area.rows() {
            for x in area.columns() {
                let place = Point::new(x, y) - self.area.top_left;
                self.hits[(place.y as u32 * self.area.size.width) as usize + place.x as usize] += 1;
            }
        }
    }
}

impl Dimensions for Counting {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Counting {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = embedded_graphics_core::Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        assert_eq!(pixels.into_iter().count(), 0, "single pixels are never drawn");
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        let given = colours.into_iter().take(1 << 20).count();
        assert_eq!(given, (area.size.width * area.size.height) as usize, "as many colours as pixels");
        self.count(area);
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, _: Rgb565) -> Result<(), Infallible> {
        self.count(area);
        Ok(())
    }
}

/// Targets of all kinds: far from the origin, of one pixel or column, and empty.
pub(crate) fn targets() -> [Counting; 7] {
    [
        Counting::new(0, 0, 40, 30),
        Counting::new(-7, 1000, 64, 3),
        Counting::new(i32::MIN, i32::MAX - 20, 9, 9),
        Counting::new(5, 5, 1, 1),
        Counting::new(0, 0, 1, 200),
        Counting::new(3, 3, 0, 0),
        Counting::new(0, 0, 0, 7),
    ]
}

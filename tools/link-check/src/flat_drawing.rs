//! Triangles straight to the display.

use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::Drawable;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use scenes::texture::BRICK;
use topleft::{Attribute, Coord, Point, ShadedTriangle, point};

use crate::screen::Screen;

pub(crate) fn draw(screen: &mut Screen) -> Result<(), Infallible> {
    let at = |x: i32, y: i32| Point::new(black_box(Coord::from_bits(x)), black_box(Coord::from_bits(y)));
    // A float is let in here, as its bits only.
    let points = [at(-900, 20), at(5000, 4000), point(black_box(1.5), black_box(240.0))];
    let colours = black_box([Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE]);
    ShadedTriangle::flat(points, black_box(Rgb565::WHITE)).draw(screen)?;
    ShadedTriangle::new(points, colours).draw(screen)?;
    let texels = black_box([[Attribute::ZERO; 2], [Attribute::ONE; 2], [Attribute::ZERO, Attribute::ONE]]);
    ShadedTriangle::textured(points, texels, &black_box(BRICK)).draw(screen)
}

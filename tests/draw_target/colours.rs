//! Every RGB colour of embedded-graphics.

use std::fmt::Debug;

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use topleft::{
    Attribute, DrawList, Flat, Length, ListTriangle, Mesh, NoDepth, Orthographic, Pixel as Channels, Pose,
    ShadedTriangle, Strip, Texture, point,
};

use crate::support::counter::StrictDisplay;

/// Draws each way of shading in a colour, on a display and through a strip.
fn in_colour<C>(name: &str)
where
    C: Channels + PixelColor + RgbColor + Debug + PartialEq,
    Rgb888: From<C>,
{
    let area = Rectangle::new(Point::new(-2, 4), Size::new(9, 7));
    let [a, b, c] = [point(-9.0, -9.0), point(40.0, -9.0), point(-9.0, 40.0)];
    for colour in [C::RED, C::GREEN, C::BLUE, C::WHITE, C::BLACK, C::YELLOW, C::MAGENTA, C::CYAN] {
        let all = |display: StrictDisplay<C>| {
            assert!(
                display.pixels.iter().all(|&pixel| pixel == Some(colour)),
                "{name}: {:?}",
                display.pixels
            );
        };
        let mut display = StrictDisplay::new(area);
        ShadedTriangle::flat([a, b, c], colour).draw(&mut display).expect("this display does not fail");
        all(display);
        let mut display = StrictDisplay::new(area);
        ShadedTriangle::new([a, b, c], [colour; 3]).draw(&mut display).expect("this display does not fail");
        all(display);
        let mut display = StrictDisplay::new(area);
        let channel = |c: u8, least: u16| if c == 0 { 0 } else { least };
        let texels = [channel(colour.r(), 31 << 11) | channel(colour.g(), 63 << 5) | channel(colour.b(), 31)];
        let texture = Texture::new(1, 1, &texels).expect("one texel");
        let corners = [[Attribute::ZERO; 2]; 3];
        ShadedTriangle::textured([a, b, c], corners, &texture).draw(&mut display).expect("no failure");
        all(display);

        let mesh = Mesh::new(&[[-32767, 32767, 0], [-32767, -32767, 0], [32767, -32767, 0]], &[[0, 1, 2]]);
        let mesh = mesh.expect("one face").with_box([Length::ZERO; 3], Length::lit("9"));
        let camera = Orthographic::new(area.size, 2.0, -1.0..1.0);
        let (mut words, mut triangles) = ([0; 64], [ListTriangle::EMPTY; 8]);
        let mut list = DrawList::<C, NoDepth>::new(&mut words, &mut triangles);
        list.draw(&camera, &mesh, &Pose::new(), &Flat::new(colour)).expect("one triangle fits");
        let mut cells = [C::from_channels([0; 3]); 9 * 2];
        let mut strip = Strip::new(9, &mut cells).expect("two rows").with_background(colour);
        let mut display = StrictDisplay::new(area);
        list.present(&mut strip, &mut display).expect("this display does not fail");
        all(display);
    }
    // Between black and white each channel is the nearest to its share.
    let mut display = StrictDisplay::new(Rectangle::new(Point::zero(), Size::new(64, 1)));
    let ramp = [point(0.0, 0.0), point(64.0, 0.0), point(0.0, 64.0)];
    let drawn = ShadedTriangle::new(ramp, [C::BLACK, C::WHITE, C::BLACK]).draw(&mut display);
    drawn.expect("this display does not fail");
    let share = |i: u32| C::MAX.map(|most| ((u32::from(most) * (2 * i + 1) + 64) / 128) as u8);
    let ramp: Vec<[u8; 3]> = display.pixels.iter().flatten().map(|pixel| pixel.channels()).collect();
    assert_eq!(ramp, (0..63).map(share).collect::<Vec<_>>(), "{name}");
}

// Red when a colour's channels are mixed up, or its greatest is not reached: src/pixel.rs.
#[test]
fn all_rgb_colours_are_drawn() {
    in_colour::<Rgb555>("Rgb555");
    in_colour::<Rgb565>("Rgb565");
    in_colour::<Rgb666>("Rgb666");
    in_colour::<Rgb888>("Rgb888");
    in_colour::<Bgr555>("Bgr555");
    in_colour::<Bgr565>("Bgr565");
    in_colour::<Bgr666>("Bgr666");
    in_colour::<Bgr888>("Bgr888");
}

//! (a) Shaded triangles on any display: no camera, no buffer, no depth.
//!
//! `cargo run --example triangle` writes `target/triangle.png`.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use scenes::texture::TEST_CARD;
use topleft::{Attribute, ShadedTriangle, point};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(240, 240));

    // A colour at each corner.
    ShadedTriangle::new(
        [point(20.0, 12.5), point(220.25, 60.0), point(64.0, 130.0)],
        [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE],
    )
    .draw(&mut display)?;

    // Two triangles that share an edge turn and shear an image: no pixel is drawn twice, and none is left out.
    let [a, b, c, d] = [point(60.0, 140.0), point(190.0, 120.0), point(210.0, 210.0), point(40.0, 230.0)];
    let texel = |u: i32, v: i32| [Attribute::from_num(u), Attribute::from_num(v)];
    let [ta, tb, tc, td] = [texel(0, 0), texel(64, 0), texel(64, 64), texel(0, 64)];
    ShadedTriangle::textured([a, b, d], [ta, tb, td], &TEST_CARD).draw(&mut display)?;
    ShadedTriangle::textured([b, c, d], [tb, tc, td], &TEST_CARD).draw(&mut display)?;

    std::fs::create_dir_all("target")?;
    let path = "target/triangle.png";
    let settings = OutputSettingsBuilder::new().scale(2).build();
    display.to_rgb_output_image(&settings).save_png(path)?;
    println!("{path}");
    Ok(())
}

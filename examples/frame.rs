//! (c) A list into a whole frame in memory: a strip as tall as the target, here of bare RGB565 words without depth.
//!
//! `cargo run --example frame` writes `target/frame.png`.

use embedded_graphics::geometry::Size;
use scenes::mesh::CUBE;
use scenes::texture::BRICK;
use topleft::{
    DrawList, Length, ListTriangle, PerPixel, Perspective, Pixel, Pose, Strip, Sun, Textured, Turn,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let size = Size::new(240, 240);
    let camera = Perspective::new(size, Turn::from_degrees(45), 1.0..10.0).look_at([3.0, 2.5, 3.5], [0.0; 3]);
    let sun = Sun::new([Length::lit("0.3"), Length::lit("1"), Length::lit("0.8")]);
    let shader = Textured::new(&BRICK, PerPixel).lit_by(&sun);

    // A cube is convex: leaving out the faces that look away is all the hiding that it needs.
    let (mut vertices, mut triangles) = ([0; 6 * 24], [ListTriangle::EMPTY; 12]);
    let mut list = DrawList::new(&mut vertices, &mut triangles);
    list.draw(&camera, &CUBE, &Pose::new(), &shader)?;

    // What a DMA channel would send: 16 bits a pixel.
    let mut frame = [0_u16; 240 * 240];
    let mut strip = Strip::new(240, &mut frame)?;
    strip.clear();
    list.render(0..240, &mut strip);

    std::fs::create_dir_all("target")?;
    let path = "target/frame.png";
    let picture = image::RgbImage::from_fn(240, 240, |x, y| {
        let [r, g, b] = frame[(y * 240 + x) as usize].channels();
        image::Rgb([r << 3, g << 2, b << 3])
    });
    picture.save(path)?;
    println!("{path}");
    Ok(())
}

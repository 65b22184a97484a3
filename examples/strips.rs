//! (b) A mesh from flash through strips of 16 rows: 240x240 with depth in 40 KB, the list included.
//!
//! `cargo run --example strips` writes `target/strips.png`.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use scenes::mesh::TEAPOT;
use topleft::{Gouraud, Length, ListStorage, Material, Perspective, Pose, Strip, Sun, Turn};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // On a chip these are statics. A Gouraud vertex with depth takes 4 words.
    let mut storage: ListStorage<{ 4 * 762 }, 900> = ListStorage::new();
    let mut colours = [Rgb565::BLACK; 240 * 16];
    let mut depths = [0; 240 * 16];
    let memory = size_of_val(&storage) + size_of_val(&colours) + size_of_val(&depths);

    let size = Size::new(240, 240);
    let mut display = SimulatorDisplay::<Rgb565>::new(size);

    let sun = Sun::new([Length::lit("-0.5"), Length::lit("0.9"), Length::lit("0.7")]);
    let brass = Material::from(Rgb888::new(0xE0, 0xA8, 0x50));
    let pose = Pose::new().turned_y(Turn::from_degrees(30));
    let camera =
        Perspective::new(size, Turn::from_degrees(50), 0.5..6.0).look_at([0.0, 1.0, 2.2], [0.0, 0.0, 0.0]);

    let mut list = storage.list();
    list.draw(&camera, &TEAPOT, &pose, &Gouraud::new(&sun, &brass))?;
    let mut strip = Strip::new(240, &mut colours)?.with_depth(&mut depths)?;
    list.present(&mut strip, &mut display)?;

    println!("{} triangles from {memory} bytes", list.stats().drawn);
    std::fs::create_dir_all("target")?;
    let path = "target/strips.png";
    display.to_rgb_output_image(&OutputSettings::default()).save_png(path)?;
    println!("{path}");
    Ok(())
}

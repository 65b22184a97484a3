//! What the image must not do: compute a matrix from floats while it runs.

use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use scenes::mesh::CUBE;
use topleft::{DrawList, Flat, ListStorage, NoDepth, Perspective, Pose, Strip, Turn};

use crate::screen::{SIZE, Screen};

pub(crate) fn draw(screen: &mut Screen) -> Result<(), Infallible> {
    let camera = Perspective::new(black_box(SIZE), black_box(Turn::from_degrees(50)), black_box(0.5..9.0))
        .look_at(black_box([0.0, 2.0, 4.0]), black_box([0.0; 3]));
    let mut storage: ListStorage<60, 20> = ListStorage::new();
    let mut colours = [Rgb565::BLACK; SIZE.width as usize];
    let mut list: DrawList<'_, Rgb565, NoDepth> = storage.list();
    black_box(list.draw(&camera, &CUBE, &Pose::new(), &Flat::new(Rgb565::RED))).ok();
    if let Ok(mut strip) = Strip::new(SIZE.width as u16, &mut colours) {
        list.present(&mut strip, screen)?;
    }
    Ok(())
}

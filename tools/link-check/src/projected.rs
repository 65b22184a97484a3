//! Vertices that are on the screen already.

use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use scenes::texture::BRICK;
use topleft::stages::{FlatPixel, GouraudPixel};
use topleft::{
    Attribute, Depth16, DepthCode, DrawError, DrawList, Length, ListStorage, PerPixel, Point,
    ProjectedVertex, Strip, Textured, point,
};

use crate::screen::{SIZE, Screen};

/// Faces that may name vertices which are not there, and fewer colours.
static FACES: [[u16; 3]; 2] = [[0, 1, 2], [2, 1, 3]];
static COLOURS: [[u8; 3]; 1] = [[255, 0, 0]];

pub(crate) fn draw(screen: &mut Screen) -> Result<(), Infallible> {
    let mut storage: ListStorage<60, 6> = ListStorage::new();
    let mut list: DrawList<'_, Rgb565, Depth16> = storage.list();
    black_box(every_shader(&mut list)).ok();
    let (mut colours, mut depths) = ([Rgb565::BLACK; 240 * 8], [0; 240 * 8]);
    if let Ok(strip) = Strip::new(SIZE.width as u16, &mut colours)
        && let Ok(mut strip) = strip.with_depth(&mut depths)
    {
        list.present(&mut strip, screen)?;
    }
    Ok(())
}

fn every_shader(list: &mut DrawList<'_, Rgb565, Depth16>) -> Result<(), DrawError> {
    let (size, faces, colours) = (black_box(SIZE), black_box(&FACES[..]), black_box(&COLOURS[..]));
    let texture = Textured::new(&black_box(BRICK), PerPixel);
    list.draw_projected(size, vertices(()), faces, colours, &FlatPixel)?;
    list.draw_projected(size, vertices([9; 3]), faces, colours, &GouraudPixel)?;
    list.draw_projected(size, vertices([Attribute::ONE; 2]), faces, colours, &texture)
}

/// Four of any place, depth and distance.
fn vertices<A: Copy>(attributes: A) -> impl ExactSizeIterator<Item = ProjectedVertex<A>> {
    let points = black_box([point(1.5, 2.0), point(240.0, 7.0), point(f32::NAN, 0.0), point(9.0, 1e9)]);
    points.into_iter().map(move |at: Point| {
        ProjectedVertex::new(at, black_box(attributes))
            .with_depth(black_box(DepthCode::ONE))
            .with_w(black_box(Length::ONE))
    })
}

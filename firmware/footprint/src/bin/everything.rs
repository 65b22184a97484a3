//! Flat, Gouraud, affine and per-pixel textures, plain and under light, both cameras, with and without depth, a mesh from a
//! blob, and triangles without a list.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::prelude::*;
use footprint::{Memory, PANEL};
use topleft::{
    Affine, DrawList, Flat, Gouraud, Length, Material, Mesh, Orthographic, PerPixel, Perspective,
    ShadedTriangle, Strip, Sun, Textured, Turn, point,
};

footprint::image!(|memory| {
    let _ = with_depth(memory);
});

fn with_depth(memory: &'static mut Memory) -> Option<()> {
    let Memory { words, triangles, colours, depths } = memory;
    let mut strip = Strip::new(240, colours).ok()?.with_depth(depths).ok()?;
    let camera = Perspective::new(PANEL, Turn::from_degrees(45), 1.0..9.0)
        .look_at(black_box([1.0, 2.0, 4.0]), [0.0; 3]);
    let sun = Sun::new(black_box([Length::ONE; 3]));
    let material = Material::OfMesh;
    let texture = footprint::texture()?;
    let list = &mut DrawList::new(words, triangles);
    footprint::draw(list, &mut strip, &camera, &Flat::new(material).lit_by(&sun));
    footprint::draw(list, &mut strip, &camera, &Gouraud::new(&sun, &material));
    footprint::draw(list, &mut strip, &camera, &Textured::new(&texture, Affine));
    footprint::draw(list, &mut strip, &camera, &Textured::new(&texture, PerPixel));
    footprint::draw(list, &mut strip, &camera, &Textured::new(&texture, Affine).lit_by(&sun));
    footprint::draw(list, &mut strip, &camera, &Textured::new(&texture, PerPixel).lit_by(&sun));
    list.clear();
    let blob = Mesh::from_bytes(black_box(&[])).ok()?;
    let front = Orthographic::new(PANEL, black_box(4.0), -2.0..2.0);
    list.draw(&front, &blob, &topleft::Pose::new(), &Flat::new(material)).ok()?;
    let Ok(()) = without_list(&mut Nowhere);
    Some(())
}

fn without_list(display: &mut Nowhere) -> Result<(), Infallible> {
    let points = black_box([point(2.0, 1.25), point(60.25, 9.0), point(20.0, 50.5)]);
    ShadedTriangle::new(points, black_box([Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE])).draw(display)?;
    ShadedTriangle::flat(points, Rgb565::RED).draw(display)
}

/// A display that shows nothing.
struct Nowhere;

impl OriginDimensions for Nowhere {
    fn size(&self) -> Size {
        black_box(PANEL)
    }
}

impl DrawTarget for Nowhere {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|pixel| _ = black_box(pixel));
        Ok(())
    }
}

//! One after the other: flat and an affine texture without depth; flat, Gouraud, and a texture with a reciprocal a pixel with
//! depth.
#![cfg_attr(target_os = "none", no_std, no_main)]

use footprint::{EYE, FRONT, Memory};
use topleft::{Affine, DrawList, Flat, Gouraud, Material, PerPixel, Strip, Textured};

footprint::image!(|memory| {
    let Memory { words, triangles, colours, depths } = memory;
    let Some(texture) = footprint::texture() else { return };
    let flat = Flat::new(Material::OfMesh);
    let Ok(mut strip) = Strip::new(240, colours) else { return };
    let mut list = DrawList::new(words, triangles);
    footprint::draw(&mut list, &mut strip, &FRONT, &flat);
    footprint::draw(&mut list, &mut strip, &FRONT, &Textured::new(&texture, Affine));
    drop(list);
    let Ok(mut strip) = strip.with_depth(depths) else { return };
    let mut list = DrawList::new(words, triangles);
    footprint::draw(&mut list, &mut strip, &FRONT, &flat);
    footprint::draw(&mut list, &mut strip, &FRONT, &Gouraud::unlit(&Material::OfMesh));
    footprint::draw(&mut list, &mut strip, &EYE, &Textured::new(&texture, PerPixel));
});

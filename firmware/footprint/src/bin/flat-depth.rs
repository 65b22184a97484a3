//! A colour a face, with depth.
#![cfg_attr(target_os = "none", no_std, no_main)]

use topleft::{DrawList, Flat, Material, Strip};

footprint::image!(|memory| {
    let Ok(strip) = Strip::new(240, &mut memory.colours) else { return };
    let Ok(mut strip) = strip.with_depth(&mut memory.depths) else { return };
    let mut list = DrawList::new(&mut memory.words, &mut memory.triangles);
    footprint::draw(&mut list, &mut strip, &footprint::FRONT, &Flat::new(Material::OfMesh));
});

//! A scene as people ship it: flat and Gouraud under a sun, and an affine texture, with depth, before a camera in
//! perspective that is given in floats; in one list.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

use topleft::{Affine, DrawList, Flat, Gouraud, Length, Material, Perspective, Strip, Sun, Textured, Turn};

footprint::image!(|memory| {
    let Ok(strip) = Strip::new(240, &mut memory.colours) else { return };
    let Ok(mut strip) = strip.with_depth(&mut memory.depths) else { return };
    let Some(texture) = footprint::texture() else { return };
    let camera = Perspective::new(footprint::PANEL, Turn::from_degrees(45), 1.0..9.0)
        .look_at(black_box([1.0, 2.0, 4.0]), [0.0; 3]);
    let sun = Sun::new(black_box([Length::ONE; 3]));
    let list = &mut DrawList::new(&mut memory.words, &mut memory.triangles);
    let added = footprint::add(list, &camera, &Flat::new(Material::OfMesh).lit_by(&sun)).is_ok()
        && footprint::add(list, &camera, &Gouraud::new(&sun, &Material::OfMesh)).is_ok()
        && footprint::add(list, &camera, &Textured::new(&texture, Affine)).is_ok();
    if added {
        footprint::render(list, &mut strip);
    }
});

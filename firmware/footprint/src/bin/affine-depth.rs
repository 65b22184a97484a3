//! A texture without perspective, with depth.
#![cfg_attr(target_os = "none", no_std, no_main)]

use topleft::{Affine, DrawList, Strip, Textured};

footprint::image!(|memory| {
    let Ok(strip) = Strip::new(240, &mut memory.colours) else { return };
    let Ok(mut strip) = strip.with_depth(&mut memory.depths) else { return };
    let mut list = DrawList::new(&mut memory.words, &mut memory.triangles);
    let Some(texture) = footprint::texture() else { return };
    footprint::draw(&mut list, &mut strip, &footprint::FRONT, &Textured::new(&texture, Affine));
});

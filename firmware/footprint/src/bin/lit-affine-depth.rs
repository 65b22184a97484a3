//! A texture without perspective under light, with depth.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

use topleft::{Affine, DrawList, Length, Strip, Sun, Textured};

footprint::image!(|memory| {
    let Ok(strip) = Strip::new(240, &mut memory.colours) else { return };
    let Ok(mut strip) = strip.with_depth(&mut memory.depths) else { return };
    let mut list = DrawList::new(&mut memory.words, &mut memory.triangles);
    let Some(texture) = footprint::texture() else { return };
    let sun = Sun::new(black_box([Length::ONE; 3]));
    let shader = Textured::new(&texture, Affine).lit_by(&sun);
    footprint::draw(&mut list, &mut strip, &footprint::FRONT, &shader);
});

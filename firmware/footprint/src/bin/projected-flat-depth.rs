//! A colour a face, with depth, of vertices that are on the screen already: no mesh, camera, pose or clipper.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

use topleft::stages::FlatPixel;
use topleft::{Coord, DepthCode, DrawList, Point, ProjectedVertex, Strip};

footprint::image!(|memory| {
    let Ok(strip) = Strip::new(240, &mut memory.colours) else { return };
    let Ok(mut strip) = strip.with_depth(&mut memory.depths) else { return };
    let mut list = DrawList::new(&mut memory.words, &mut memory.triangles);
    // The same cube as the others', of which only the numbers are read.
    let cube = footprint::mesh();
    let vertices = cube.positions().iter().map(projected);
    if list
        .draw_projected(black_box(footprint::PANEL), vertices, cube.faces(), cube.face_colours(), &FlatPixel)
        .is_ok()
    {
        footprint::render(&mut list, &mut strip);
    }
});

/// A vertex stage: level, seen from a little above and from the right, half as large as the panel.
fn projected(&[x, y, z]: &[i16; 3]) -> ProjectedVertex {
    let (x, y, z) = (i32::from(x), i32::from(y), i32::from(z));
    let at = |offset: i32| Coord::from_bits((120 << 8) + offset);
    let place = Point::new(at(x / 2 - z / 8), at(z / 8 - y / 2));
    let towards = (1 << 18) + x + y + 4 * z;
    ProjectedVertex::new(place, ()).with_depth(DepthCode::from_bits(towards.cast_unsigned() << 12))
}

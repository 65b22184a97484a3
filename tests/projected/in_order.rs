//! Vertices on the screen in a list whose strips are rendered in order.

use embedded_graphics::prelude::Size;
use topleft::stages::FlatPixel;
use topleft::{Depth16, DepthCode, DrawList, ListTriangle, ProjectedVertex, Strip, point};

/// A square of two triangles, which leans from one depth at its top to another at its bottom.
fn square(list: &mut DrawList<'_, u16, Depth16>, [top, bottom]: [u16; 2], colour: [u8; 3]) {
    let corner = |x: f32, y: f32, depth: u16| {
        ProjectedVertex::new(point(x, y), ()).with_depth(DepthCode::from_num(depth))
    };
    let vertices = [
        corner(1.0, 1.0, top),
        corner(1.0, 15.0, bottom),
        corner(15.0, 15.0, bottom),
        corner(15.0, 1.0, top),
    ];
    list.draw_projected(Size::new(16, 16), vertices, &[[0, 1, 2], [0, 2, 3]], &[colour; 2], &FlatPixel)
        .expect("room for it");
}

// Red when `keep` in src/list/draw.rs leaves what is known of triangles from the strip above: their words are others then.
#[test]
fn what_is_drawn_between_strips_does_not_change_what_was_there() {
    let (mut words, mut triangles) = ([0; 64], [ListTriangle::EMPTY; 4]);
    let mut list = DrawList::new(&mut words, &mut triangles);
    square(&mut list, [60_000, 100], [255, 0, 0]);
    let strip = |render: &mut dyn FnMut(&mut Strip<'_, u16, Depth16>)| {
        let (mut colours, mut depths) = ([0; 16 * 8], [0; 16 * 8]);
        render(&mut Strip::new(16, &mut colours).unwrap().with_depth(&mut depths).unwrap());
        (colours, depths)
    };
    strip(&mut |strip| list.render_next(0..8, strip));
    square(&mut list, [0, 20_000], [0, 0, 255]);
    let next = strip(&mut |strip| list.render_next(8..16, strip));
    let alone = strip(&mut |strip| list.render(8..16, strip));
    let red = alone.0.iter().filter(|&&colour| colour == 0xF800).count();
    assert!((20..80).contains(&red), "{red} of them are behind the other");
    assert!(next == alone);
}

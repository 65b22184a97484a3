//! Triangles of any points against 128-bit integers: those inside the guard rectangle are exact, others are left out.

use std::cell::Cell;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use proptest::prelude::*;
use reference::raster::covers;
use topleft::stages::FlatPixel;
use topleft::{
    Coord, Cull, DrawList, ListTriangle, NoDepth, Point as Corner, ProjectedVertex, Strip, Viewport,
};

use crate::support::check;

/// A coordinate in 1/256 px, by the ends of the guard rectangle of a length: on it, a step beside it, near the frame, or any.
fn place((kind, any): (u8, i32), length: i32, margin: i32) -> i32 {
    let (low, high) = (-margin * 256, (length + margin) * 256);
    match kind % 8 {
        0 => low,
        1 => high,
        2 => low - 1,
        3 => high + 1,
        4 => any,
        5 => low + any.rem_euclid(high - low),
        6 => any.rem_euclid(length * 2 + 1) * 128,
        _ => any.rem_euclid(length * 512) - length * 128,
    }
}

// Red when a vertex a step beyond the guard rectangle is drawn, one on it is not, or a triangle with one beyond it counts as
// anything but outside.
#[test]
fn triangles_inside_the_guard_rectangle_are_exact_and_others_are_left_out() {
    let (drawn, beyond) = (Cell::new(0), Cell::new(0));
    let corner = || [any::<(u8, i32)>(), any::<(u8, i32)>()];
    let sizes = prop::sample::select(vec![[1, 1], [33, 21], [64, 64], [8190, 4], [3, 4094]]);
    check(20_000, &([corner(), corner(), corner()], sizes), |(corners, [width, height])| {
        let size = Size::new(width, height);
        let margin = i32::from(Viewport::new(size).expect("a size that is allowed").margin());
        let [w, h] = [width, height].map(u32::cast_signed);
        let triangle = corners.map(|[x, y]| [place(x, w, margin), place(y, h, margin)]);
        let inside = |length: i32, at: i32| (-margin * 256..=(length + margin) * 256).contains(&at);
        let exact = triangle.iter().all(|&[x, y]| inside(w, x) && inside(h, y));

        let vertices = triangle
            .map(|[x, y]| ProjectedVertex::new(Corner::new(Coord::from_bits(x), Coord::from_bits(y)), ()));
        let mut storage = ([0; 6], [ListTriangle::EMPTY; 1]);
        let mut list = DrawList::<Rgb565, NoDepth>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        list.draw_projected(size, vertices, &[[0, 1, 2]], &[], &FlatPixel)
            .map_err(|error| error.to_string())?;
        let stats = list.stats();
        if !exact && stats.outside != 1 {
            return Err(format!("{triangle:?} is not outside: {stats:?}"));
        }
        // Some of the frame: its ends, and its middle.
        let (columns, rows) = (w.min(40), h.min(30));
        for top in [0, (h - rows) / 2, h - rows] {
            let mut colours = [Rgb565::BLACK; 40 * 30];
            let mut strip =
                Strip::new(columns as u16, &mut colours[..(columns * rows) as usize]).expect("rows");
            list.render(top..top + rows, &mut strip);
            for (y, row) in (top..).zip(strip.colours().chunks(columns as usize)) {
                for (x, &colour) in row.iter().enumerate() {
                    let expected = exact && covers(triangle, x as i64, i64::from(y));
                    if (colour == Rgb565::WHITE) != expected {
                        return Err(format!("({x}, {y}) of {triangle:?}: {expected} is right"));
                    }
                    drawn.set(drawn.get() + usize::from(expected));
                }
            }
        }
        beyond.set(beyond.get() + usize::from(!exact));
        Ok(())
    });
    println!("{} pixels, {} triangles left out", drawn.get(), beyond.get());
    assert!(drawn.get() > 100_000 && beyond.get() > 5_000);
}

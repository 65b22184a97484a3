//! Lists, strip by strip to a display, and targets that are too large.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use topleft::{
    Depth16, DrawError, DrawList, Flat, ListTriangle, Mesh, NoDepth, Orthographic, Pose, ShadedTriangle,
    Strip, TooLarge, Viewport, point,
};

use crate::support::counter::{Refused, StrictDisplay};

/// A list with one large red triangle for a viewport of `size`.
fn red<R>(size: Size, with: impl FnOnce(&mut DrawList<'_, Rgb565, Depth16>) -> R) -> R {
    const POSITIONS: [[i16; 3]; 3] = [[-32767, 32767, 0], [-32767, -32767, 0], [32767, -32767, 0]];
    let mesh = Mesh::new(&POSITIONS, &[[0, 1, 2]]).expect("one face");
    let camera = Orthographic::new(size, 2.0, -1.0..1.0);
    let (mut words, mut triangles) = ([0; 32], [ListTriangle::EMPTY; 4]);
    let mut list = DrawList::new(&mut words, &mut triangles);
    list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED)).expect("one triangle fits");
    with(&mut list)
}

// Red when `present` sends a strip in more than one call, or forgets the last rows: src/list/render.rs, `send`.
#[test]
fn presenting_is_one_fill_for_each_strip() {
    for (width, height) in [(40, 30), (1, 30), (40, 1), (1, 1), (0, 30), (40, 0), (0, 0), (37, 29)] {
        for rows in [1, 2, 7, 16, 30, 64] {
            for columns in [1, 8, 40, 64] {
                let size = Size::new(width, height);
                let area = Rectangle::new(Point::new(-11, 8), size);
                let mut display = StrictDisplay::<Rgb565>::new(area);
                let mut cells = vec![Rgb565::BLACK; columns * rows];
                let mut depths = vec![0; columns * rows];
                let strip = Strip::new(columns as u16, &mut cells).expect("whole rows");
                let mut strip = strip.with_depth(&mut depths).expect("as many depths");
                red(size, |list| list.present(&mut strip, &mut display)).expect("this display does not fail");
                let strips = if width == 0 { 0 } else { (height as usize).div_ceil(rows) };
                assert_eq!(display.calls, [0, strips, 0, 0], "{width}x{height} by {columns}x{rows}");
                for (i, &writes) in display.writes.iter().enumerate() {
                    let sent = u32::from(i % (width as usize) < columns);
                    assert_eq!(writes, sent, "pixel {i} of {width}x{height} by {columns}x{rows}");
                }
            }
        }
    }
}

// Red when a target that is not as large as the camera's shows anything but the part from the top left, or background.
#[test]
fn presenting_to_a_target_of_another_size_shows_its_part() {
    let size = Size::new(40, 30);
    let mut expected = StrictDisplay::new(Rectangle::new(Point::zero(), size));
    let mut cells = vec![Rgb565::BLACK; 64 * 4];
    let mut depths = vec![0; 64 * 4];
    let strip = Strip::new(64, &mut cells).expect("whole rows").with_background(Rgb565::BLUE);
    let mut strip = strip.with_depth(&mut depths).expect("as many depths");
    red(size, |list| {
        list.present(&mut strip, &mut expected).expect("this display does not fail");
        assert!(expected.pixels.contains(&Some(Rgb565::RED)));
        for (width, height) in [(40, 30), (17, 30), (40, 11), (1, 1), (50, 33), (64, 64)] {
            let area = Rectangle::new(Point::new(3, -70), Size::new(width, height));
            let mut display = StrictDisplay::new(area);
            list.present(&mut strip, &mut display).expect("this display does not fail");
            for (i, pixel) in display.pixels.iter().enumerate() {
                let (x, y) = (i as u32 % width, i as u32 / width);
                let inside = x < size.width && y < size.height;
                let right = if inside { expected.pixels[(y * 40 + x) as usize] } else { Some(Rgb565::BLUE) };
                assert_eq!(*pixel, right, "column {x}, row {y} of {width}x{height}");
            }
        }
    });
}

// Red when `present` drops an error or goes on after one.
#[test]
fn presenting_returns_the_error_of_a_target_at_once() {
    let size = Size::new(20, 10);
    let mut cells = vec![Rgb565::BLACK; 20 * 3];
    let mut depths = vec![0; 20 * 3];
    let strip = Strip::new(20, &mut cells).expect("whole rows");
    let mut strip = strip.with_depth(&mut depths).expect("as many depths");
    red(size, |list| {
        for call in 0..4 {
            let mut display =
                StrictDisplay::<Rgb565>::new(Rectangle::new(Point::zero(), size)).failing_at(call);
            assert_eq!(list.present(&mut strip, &mut display), Err(Refused(call)));
            assert_eq!(display.all_calls(), call + 1);
        }
        let mut display = StrictDisplay::<Rgb565>::new(Rectangle::new(Point::zero(), size)).failing_at(4);
        assert_eq!(list.present(&mut strip, &mut display), Ok(()), "four strips are four calls");
    });
}

// Red when a strip's colour cannot differ from the display's: the bound of `present`.
#[test]
fn a_strip_of_rgb565_is_sent_to_a_display_of_rgb888() {
    let mut cells = vec![Rgb565::BLACK; 40 * 8];
    let mut depths = vec![0; 40 * 8];
    let strip = Strip::new(40, &mut cells).expect("whole rows").with_background(Rgb565::CYAN);
    let mut strip = strip.with_depth(&mut depths).expect("as many depths");
    let mut display = StrictDisplay::<Rgb888>::new(Rectangle::new(Point::zero(), Size::new(40, 30)));
    red(Size::new(40, 30), |list| list.present(&mut strip, &mut display))
        .expect("this display does not fail");
    assert!(display.pixels.iter().all(|pixel| [Some(Rgb888::CYAN), Some(Rgb888::RED)].contains(pixel)));
}

// Red when a target beyond the guard rectangle's limits is drawn to wrongly in place of being refused, or cut off.
#[test]
fn targets_that_are_too_large_are_refused_or_drawn_as_far_as_that() {
    let size = Size::new(9_000, 3);
    assert_eq!(Viewport::new(size), Err(TooLarge(size)));
    let mesh = Mesh::new(&[[0; 3]; 3], &[[0, 1, 2]]).expect("one face");
    let (mut words, mut triangles) = ([0; 32], [ListTriangle::EMPTY; 1]);
    let mut list = DrawList::<Rgb565, NoDepth>::new(&mut words, &mut triangles);
    let camera = Orthographic::new(size, 2.0, -1.0..1.0);
    let drawn = list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED));
    assert_eq!(drawn, Err(DrawError::TooLarge(size)));
    let mut display = StrictDisplay::new(Rectangle::new(Point::zero(), size));
    let [a, b, c] = [point(-1.0e6, 1.0), point(1.0e6, -1.0e6), point(1.0e6, 1.0e6)];
    ShadedTriangle::flat([a, b, c], Rgb565::RED).draw(&mut display).expect("this display does not fail");
    let far = |x: usize| display.pixels[9_000 + x];
    assert_eq!(
        [far(0), far(8_189), far(8_190), far(8_999)],
        [Some(Rgb565::RED), Some(Rgb565::RED), None, None]
    );
}

//! Single triangles, straight to a display.

use std::cell::Cell;

use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::prelude::*;
use scenes::texture::TEST_CARD;
use topleft::{
    Affine, Attribute, Coord, DrawList, Flat, Gouraud, Length, ListTriangle, Material, Mesh, NoDepth,
    Orthographic, Point as Corner, Pose, ShadedTriangle, Strip, Textured, point,
};

use crate::support::counter::{Refused, StrictDisplay};
use crate::support::{check, same};

/// A corner in 1/256 px with all that it can carry.
#[derive(Clone, Copy, Debug)]
struct Carried {
    at: [i32; 2],
    colour: [u8; 3],
    uv: [i16; 2],
}

fn corners(coordinate: impl Strategy<Value = i32> + Clone) -> impl Strategy<Value = [Carried; 3]> {
    let corner = ([coordinate.clone(), coordinate], any::<[u8; 3]>(), any::<[i16; 2]>());
    let corner = corner.prop_map(|(at, colour, uv)| Carried { at, colour, uv });
    [corner.clone(), corner.clone(), corner]
}

fn corner_at([x, y]: [i32; 2]) -> Corner {
    Corner::new(Coord::from_bits(x), Coord::from_bits(y))
}

fn rgb565([r, g, b]: [u8; 3]) -> Rgb565 {
    Rgb565::from(Rgb888::new(r, g, b))
}

/// The triangle in one of three ways of shading, its corners moved by whole pixels.
fn draw<D: DrawTarget<Color = Rgb565>>(
    corners: &[Carried; 3],
    way: u8,
    moved: Point,
    target: &mut D,
) -> Result<(), D::Error> {
    let points =
        corners.map(|corner| corner_at([corner.at[0] + moved.x * 256, corner.at[1] + moved.y * 256]));
    match way {
        0 => ShadedTriangle::flat(points, rgb565(corners[0].colour)).draw(target),
        1 => ShadedTriangle::new(points, corners.map(|corner| rgb565(corner.colour))).draw(target),
        _ => {
            let texels = corners.map(|corner| corner.uv.map(|c| Attribute::from_bits(i32::from(c) << 7)));
            ShadedTriangle::textured(points, texels, &TEST_CARD).draw(target)
        }
    }
}

/// Targets anywhere: empty, one pixel wide or high, and larger.
fn areas() -> impl Strategy<Value = Rectangle> {
    let length = || prop_oneof![Just(0_u32), Just(1), 2..40_u32];
    ([-300..300, -300..300], [length(), length()])
        .prop_map(|([x, y], [width, height])| Rectangle::new(Point::new(x, y), Size::new(width, height)))
}

// Red when the origin in src/target/display.rs is not the box's top left, or the window is not its size.
#[test]
fn a_triangle_counts_from_the_top_left_of_any_target() {
    let pixels = Cell::new(0);
    let near = corners(-20 * 256..50 * 256);
    check(20_000, &(near, areas(), 0..3_u8), |(corners, area, way)| {
        let mut display = StrictDisplay::new(area);
        let mut at_origin = StrictDisplay::new(Rectangle::new(Point::zero(), area.size));
        draw(&corners, way, Point::zero(), &mut display).map_err(|error| format!("{error:?}"))?;
        draw(&corners, way, Point::zero(), &mut at_origin).map_err(|error| format!("{error:?}"))?;
        same("elsewhere", area.size.width as usize, &display.pixels, &at_origin.pixels)?;
        // Each row is one call, and nothing is sent twice.
        let rows = display.writes.chunks(area.size.width.max(1) as usize);
        let rows = rows.filter(|row| row.iter().any(|&writes| writes != 0)).count();
        let expected = if way == 0 { [0, 0, rows, 0] } else { [0, rows, 0, 0] };
        if display.calls != expected || display.writes.iter().any(|&writes| writes > 1) {
            return Err(format!("{:?} calls for {rows} rows", display.calls));
        }
        pixels.set(pixels.get() + display.pixels.iter().flatten().count());
        Ok(())
    });
    println!("{} pixels", pixels.get());
    assert!(pixels.get() > 150_000);
}

// Red when coverage or a gradient depends on where a triangle is: an anchor that is not the first vertex's pixel.
#[test]
fn a_triangle_moved_by_whole_pixels_is_the_same_drawing_moved() {
    let near = corners(0..40 * 256);
    check(4_000, &(near, [-30..40, -30..40], 0..3_u8), |(corners, [x, y], way)| {
        let moved = Point::new(x, y);
        let mut here = StrictDisplay::new(Rectangle::new(Point::zero(), Size::new(120, 120)));
        let corners = corners.map(|c| Carried { at: c.at.map(|c| c + 30 * 256), ..c });
        draw(&corners, way, Point::zero(), &mut here).expect("this display does not fail");
        let mut there = StrictDisplay::new(Rectangle::new(Point::zero(), Size::new(120, 120)));
        draw(&corners, way, moved, &mut there).expect("this display does not fail");
        let place = |at: Point| (at.y * 120 + at.x) as usize;
        for at in Rectangle::new(Point::new(30, 30), Size::new(41, 41)).points() {
            if there.pixels[place(at + moved)] != here.pixels[place(at)] {
                return Err(format!("another colour at {at} after moving by {moved}"));
            }
        }
        Ok(())
    });
}

// Red when anything beyond the box is sent: `clamp`, the guard rectangle, the saturation of points.
#[test]
fn nothing_outside_a_target_is_ever_sent() {
    let coordinate = prop_oneof![
        any::<i32>(),
        -2_000_000..2_000_000_i32,
        -20 * 256..60 * 256,
        prop_oneof![Just(i32::MIN), Just(i32::MAX), Just(0)]
    ];
    let pixels = Cell::new(0);
    check(30_000, &(corners(coordinate), areas(), 0..3_u8), |(corners, area, way)| {
        let mut display = StrictDisplay::new(area);
        draw(&corners, way, Point::zero(), &mut display).map_err(|error| format!("{error:?}"))?;
        if display.writes.iter().any(|&writes| writes > 1) {
            return Err("a pixel is sent twice".into());
        }
        pixels.set(pixels.get() + display.pixels.iter().flatten().count());
        Ok(())
    });
    println!("{} pixels", pixels.get());
}

// Red when a point that is not finite is taken for a number: `finite` in src/point.rs.
#[test]
fn points_that_are_nowhere_draw_nothing() {
    let [a, b] = [point(0.0, 0.0), point(20.0, 0.0)];
    for c in [(f32::NAN, 9.0), (9.0, f32::INFINITY), (f32::NEG_INFINITY, 9.0)].map(|(x, y)| point(x, y)) {
        let mut display = StrictDisplay::new(Rectangle::new(Point::zero(), Size::new(30, 30)));
        for corners in [[a, b, c], [c, a, b], [a, c, b]] {
            ShadedTriangle::flat(corners, Rgb565::RED)
                .draw(&mut display)
                .expect("this display does not fail");
        }
        assert_eq!(display.all_calls(), 0);
    }
}

// Red when a target's error is dropped, or drawing goes on after it.
#[test]
fn the_error_of_a_target_is_returned_at_once() {
    let area = Rectangle::new(Point::new(5, -5), Size::new(20, 20));
    let corners = [[256, 256], [19 * 256, 4 * 256], [3 * 256, 18 * 256]];
    let corners = corners.map(|at| Carried { at, colour: [9, 90, 200], uv: [0, 0] });
    for way in 0..3 {
        let mut whole = StrictDisplay::new(area);
        draw(&corners, way, Point::zero(), &mut whole).expect("this display does not fail");
        assert_eq!(whole.all_calls(), 17, "a call for each row");
        for call in 0..17 {
            let mut display = StrictDisplay::new(area).failing_at(call);
            assert_eq!(draw(&corners, way, Point::zero(), &mut display), Err(Refused(call)));
            assert_eq!(display.all_calls(), call + 1, "no call after the one that failed");
        }
    }
}

// Red when the library counts on more than `DrawTarget` promises of embedded-graphics' own adapters.
#[test]
fn cropped_and_translated_targets_draw_like_any_other() {
    let [a, b, c] = [point(0.0, 0.0), point(8.0, 0.0), point(0.0, 8.0)];
    let triangle = ShadedTriangle::flat([a, b, c], Rgb565::GREEN);
    // The diagonal runs through centres, and is a right edge.
    let whole = ["GGGGGGG", "GGGGGG ", "GGGGG  ", "GGGG   ", "GGG    ", "GG     ", "G      "];
    let mut display = MockDisplay::new();
    let Ok(()) = triangle.draw(&mut display);
    display.assert_pattern(&whole);

    // Five columns and three rows from (4, 2) on: points count from there.
    let mut display = MockDisplay::new();
    let area = Rectangle::new(Point::new(4, 2), Size::new(5, 3));
    let Ok(()) = triangle.draw(&mut display.cropped(&area));
    display.assert_pattern(&["         ", "         ", "    GGGGG", "    GGGGG", "    GGGGG"]);

    // Translated: the box of the target starts at (-6, -1), and points count from there.
    let mut display = MockDisplay::new();
    let Ok(()) = triangle.draw(&mut display.translated(Point::new(6, 1)));
    display.assert_pattern(&whole);

    // Clipped: the box is the clipping area.
    let mut display = MockDisplay::new();
    let Ok(()) = triangle.draw(&mut display.clipped(&Rectangle::new(Point::new(1, 1), Size::new(3, 9))));
    display.assert_pattern(&["    ", " GGG", " GGG", " GGG", " GGG", " GGG", " GG ", " G  "]);

    // Two at once, and converted from another colour.
    let mut display = MockDisplay::<Rgb888>::new();
    let mut converted = display.color_converted::<Rgb565>();
    let Ok(()) = triangle.draw(&mut converted.cropped(&Rectangle::new(Point::new(1, 0), Size::new(1, 2))));
    display.assert_pattern(&[" G", " G"]);
}

/// The same triangle as a mesh of one face: positions in 1/256 px of a screen of 240 x 240.
fn through_a_list(corners: &[Carried; 3], way: u8, strip_rows: usize) -> Vec<Rgb565> {
    let at = |corner: &Carried| [(corner.at[0] - 120 * 256) as i16, (120 * 256 - corner.at[1]) as i16, 0];
    let positions = [0, 1, 2].map(|i| at(&corners[i]));
    let colours = corners.map(|corner| {
        let colour = Rgb888::from(rgb565(corner.colour));
        [colour.r(), colour.g(), colour.b()]
    });
    let uvs = corners.map(|corner| corner.uv);
    let face_colours = [colours[0]];
    let mesh = Mesh::new(&positions, &[[0, 1, 2]])
        .and_then(|mesh| mesh.with_vertex_colours(&colours))
        .and_then(|mesh| mesh.with_face_colours(&face_colours))
        .and_then(|mesh| mesh.with_uvs(&uvs, 0))
        .expect("three vertices, one face")
        .with_box([Length::ZERO; 3], Length::lit("128"));
    let camera = Orthographic::new(Size::new(240, 240), 240.0, -1.0..1.0);
    let (mut words, mut triangles) = ([0; 32], [ListTriangle::EMPTY; 1]);
    let mut list = DrawList::<Rgb565, NoDepth>::new(&mut words, &mut triangles);
    list.set_cull(topleft::Cull::None);
    let pose = Pose::new();
    match way {
        0 => list.draw(&camera, &mesh, &pose, &Flat::new(Material::OfMesh)),
        1 => list.draw(&camera, &mesh, &pose, &Gouraud::unlit(&Material::OfMesh)),
        _ => list.draw(&camera, &mesh, &pose, &Textured::new(&TEST_CARD, Affine)),
    }
    .expect("one triangle fits");
    let mut display = StrictDisplay::new(Rectangle::new(Point::zero(), Size::new(240, 240)));
    let mut cells = vec![Rgb565::BLACK; 240 * strip_rows];
    let mut strip = Strip::new(240, &mut cells).expect("whole rows").with_background(Rgb565::new(1, 2, 3));
    list.present(&mut strip, &mut display).expect("this display does not fail");
    assert_eq!(display.writes, [1; 240 * 240], "each pixel is sent once");
    display.pixels.into_iter().flatten().collect()
}

// Red when the two roads part: other rounding, other anchors or other spans in src/triangle.rs than in src/list/.
#[test]
fn a_triangle_on_a_display_is_the_same_through_a_list() {
    let pixels = Cell::new(0);
    check(400, &(corners(0..240 * 256), 0..3_u8, 20..=240_usize), |(corners, way, rows)| {
        let mut display = StrictDisplay::new(Rectangle::new(Point::new(1, 2), Size::new(240, 240)));
        draw(&corners, way, Point::zero(), &mut display).expect("this display does not fail");
        pixels.set(pixels.get() + display.pixels.iter().flatten().count());
        let direct: Vec<Rgb565> =
            display.pixels.iter().map(|pixel| pixel.unwrap_or(Rgb565::new(1, 2, 3))).collect();
        same("through a list", 240, &through_a_list(&corners, way, rows), &direct)
    });
    println!("{} pixels", pixels.get());
}

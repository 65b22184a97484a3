//! Row 30: coordinates left of the origin and above it.

use std::cell::Cell;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::prelude::*;
use reference::naive::snap;
use reference::raster::coverage_counts;
use reference::transform::Viewport;
use topleft::{Point as Corner, ShadedTriangle, point};

use crate::figure::grouped;
use crate::support::check;
use crate::support::counter::StrictDisplay;

const SIDE: u32 = 40;
const VIEW: Viewport = Viewport { width: SIDE, height: SIDE };

/// How often the pixels of an area are sent for one triangle; the display refuses what is outside, and what is sent twice
/// counts twice.
fn sent_to(area: Rectangle, corners: [Corner; 3]) -> Vec<u32> {
    let mut display = StrictDisplay::new(area);
    ShadedTriangle::flat(corners, Rgb565::RED).draw(&mut display).expect("this display does not fail");
    display.writes
}

/// Triangles moved left and up by whole pixels, so that parts of them stand left of 0 and above it: pixels that a cast
/// draws otherwise than where they were, and the library, on a target that begins anywhere.
pub(crate) fn moved_by_whole_pixels() -> [u64; 2] {
    let counts = [const { Cell::new(0) }; 2];
    let corners = prop::array::uniform3(prop::array::uniform2(0.0..40.0_f64));
    check(1_000, &(corners, [-30..0_i32, -30..0_i32]), |(corners, [dx, dy])| {
        // In 1/1024 px, so that an `f32` holds them wherever they are.
        let corners = corners.map(|corner| corner.map(|c| (c * 1024.0).round() / 1024.0));
        let moved = corners.map(|[x, y]| [x + f64::from(dx), y + f64::from(dy)]);
        // Pixels of the moved frame, against those of the other at the place that they came from.
        let differ = |before: &[u32], after: &[u32]| {
            let side = SIDE.cast_signed();
            let places = (0..side + dy).flat_map(|y| (0..side + dx).map(move |x| (x, y)));
            let at = |x: i32, y: i32| (y * side + x) as usize;
            places.filter(|&(x, y)| after[at(x, y)] != before[at(x - dx, y - dy)]).count() as u64
        };
        let cast = |corners: [[f64; 2]; 3]| {
            coverage_counts(&[corners.map(|corner| corner.map(|c| snap::cast(c, 0)))], VIEW)
        };
        let ours = |corners: [[f64; 2]; 3], [left, top]: [i32; 2]| {
            let area = Rectangle::new(Point::new(left, top), Size::new(SIDE, SIDE));
            sent_to(area, corners.map(|[x, y]| point(x as f32, y as f32)))
        };
        let naive = differ(&cast(corners), &cast(moved));
        let ours = differ(&ours(corners, [0, 0]), &ours(moved, [dx - 7, 3 - dy]));
        counts[0].set(counts[0].get() + naive);
        counts[1].set(counts[1].get() + ours);
        if ours == 0 { Ok(()) } else { Err(format!("{ours} px differ")) }
    });
    counts.map(|count| count.get())
}

// Red when coordinates are cut off towards 0, or relative to the target's corner in half pixels.
#[test]
fn row_30_floats_moved_across_the_origin_are_rounded_otherwise() {
    let [naive, ours] = moved_by_whole_pixels();
    println!(
        "row 30, `as i32` to whole pixels: {} px differ in 1 000 triangles moved by whole pixels; topleft {ours}",
        grouped(naive)
    );
    // A corner left of 0 or above it is rounded up where it was rounded down, by a whole pixel; an edge from there into the
    // target is off by a quarter of one on average, over 15 px or so, in half of the triangles: 2 px each.
    assert!(naive > 1_000);
    assert_eq!(ours, 0);
}

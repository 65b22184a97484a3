//! Rows 27 to 30: coordinates and targets at the ends of what there is.

use std::cell::Cell;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::prelude::*;
use reference::naive::{scanline, snap};
use reference::raster::{coverage_counts, covers};
use reference::setup::Triangle;
use reference::transform::Viewport;
use topleft::{Coord, Point as Corner, ShadedTriangle, point};

use crate::edges::to_edges;
use crate::figure::grouped;
use crate::support::check;
use crate::support::counter::StrictDisplay;
use crate::support::tolerance::FLAT_CLIPPED;

const SIDE: u32 = 40;
const VIEW: Viewport = Viewport { width: SIDE, height: SIDE };

/// How often the pixels of an area are sent for one triangle; the display refuses what is outside, and what is sent twice
/// counts twice.
fn sent_to(area: Rectangle, corners: [Corner; 3]) -> Vec<u32> {
    let mut display = StrictDisplay::new(area);
    ShadedTriangle::flat(corners, Rgb565::RED).draw(&mut display).expect("this display does not fail");
    display.writes
}

fn screen() -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(SIDE, SIDE))
}

/// Triangles with one coordinate that is no number: how many of them a cast draws, and pixels of the library.
pub(crate) fn not_a_number() -> [u64; 2] {
    let counts = [const { Cell::new(0) }; 2];
    let bad = prop::sample::select(vec![f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -f32::NAN]);
    // Large, so that the corner of the screen, or a far end, still makes a triangle over pixels.
    let corners = [[5.0..12.0_f32, 30.0..38.0], [28.0..38.0, 28.0..38.0], [20.0..35.0, 2.0..9.0]];
    check(1_000, &(corners, bad, 0..6_usize), |(mut corners, bad, which)| {
        corners[which / 2][which % 2] = bad;
        let cast: Triangle = corners.map(|corner| corner.map(|c| snap::cast(c.into(), 8)));
        let naive = coverage_counts(&[cast], VIEW).iter().any(|&hits| hits > 0);
        let ours = sent_to(screen(), corners.map(|[x, y]| point(x, y)));
        counts[0].set(counts[0].get() + u64::from(naive));
        counts[1].set(counts[1].get() + ours.iter().map(|&writes| u64::from(writes)).sum::<u64>());
        if counts[1].get() == 0 { Ok(()) } else { Err("pixels are drawn".into()) }
    });
    counts.map(|count| count.get())
}

// Red when `point` makes a number of what is none.
#[test]
fn row_27_a_cast_draws_triangles_whose_corners_are_no_numbers() {
    let [naive, ours] = not_a_number();
    println!("row 27, `as i32`: {} of 1 000 triangles drawn; topleft {ours} px", grouped(naive));
    // NaN becomes 0, infinity an end of the range: more often than not there is still a triangle over some pixels.
    assert!(naive > 500);
    assert_eq!(ours, 0);
}

/// Corners of any `i32`: triangles whose doubled area does not fit 32 bits, those that a shift by 16 moves, and pixels
/// where the library is wrong by more than where the guard rectangle cuts an edge.
pub(crate) fn any_i32() -> [u64; 3] {
    let counts = [const { Cell::new(0) }; 3];
    let add = |which: usize, more: u64| counts[which].set(counts[which].get() + more);
    let coordinate = || {
        prop_oneof![
            2 => any::<i32>(),
            1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 0, i32::MAX - 1, i32::MAX]),
            1 => -20_000..20_000_i32,
        ]
    };
    check(5_000, &prop::array::uniform3(prop::array::uniform2(coordinate())), |triangle: Triangle| {
        add(0, u64::from(snap::area2_in_32_bits(triangle).is_none()));
        let moved = triangle.iter().flatten().any(|&c| snap::shifted_by_16(c >> 8) >> 16 != c >> 8);
        add(1, u64::from(moved));
        let corners = triangle.map(|[x, y]| Corner::new(Coord::from_bits(x), Coord::from_bits(y)));
        let ours = sent_to(screen(), corners);
        for (index, &writes) in ours.iter().enumerate() {
            let (x, y) = (index as i64 % i64::from(SIDE), index as i64 / i64::from(SIDE));
            let right = writes == u32::from(covers(triangle, x, y));
            if writes > 1 || (!right && to_edges(triangle, x, y) > FLAT_CLIPPED) {
                add(2, 1);
            }
        }
        if counts[2].get() == 0 { Ok(()) } else { Err("a pixel is wrong".into()) }
    });
    counts.map(|count| count.get())
}

// Red when a difference of coordinates is taken in 32 bits before clipping.
#[test]
fn row_28_corners_at_the_ends_of_32_bits_overflow() {
    let [area, shifted, ours] = any_i32();
    println!(
        "row 28, of 5 000 triangles the area overflows 32 bits in {}, and a shift by 16 moves {}; topleft {ours} px wrong",
        grouped(area),
        grouped(shifted)
    );
    // Differences of two of any `i32` are 2^30 and more half of the time, and their products do not fit.
    assert!(area > 4_000 && shifted > 4_000);
    assert_eq!(ours, 0);
}

/// Targets with no pixel or one, that begin anywhere: boxes that naively reach beyond, and pixels where the library is
/// wrong.
pub(crate) fn smallest_targets() -> [u64; 2] {
    let counts = [const { Cell::new(0) }; 2];
    let sizes = prop::sample::select(vec![[0, 0], [0, 1], [1, 0], [0, 7], [7, 0], [1, 1]]);
    let corners = prop::array::uniform3(prop::array::uniform2(-40 * 256..40 * 256_i32));
    check(2_000, &(sizes, corners, [-9..9_i32, -9..9_i32]), |([width, height], triangle, [left, top])| {
        let view = Viewport { width, height };
        let naive = scanline::box_inside(triangle, view);
        let many = |range: &std::ops::RangeInclusive<u32>, size: u32| {
            u64::from(!range.is_empty() && *range.end() >= size)
        };
        counts[0].set(counts[0].get() + many(&naive[0], width).max(many(&naive[1], height)));
        let area = Rectangle::new(Point::new(left, top), Size::new(width, height));
        let corners = triangle.map(|[x, y]| Corner::new(Coord::from_bits(x), Coord::from_bits(y)));
        let exact = coverage_counts(&[triangle], view);
        let wrong = sent_to(area, corners).iter().zip(&exact).filter(|(a, b)| a != b).count() as u64;
        counts[1].set(counts[1].get() + wrong);
        if wrong == 0 { Ok(()) } else { Err(format!("{wrong} px are wrong")) }
    });
    counts.map(|count| count.get())
}

// Red when the last column is `width - 1` in unsigned numbers. (The display refuses what is outside of it.)
#[test]
fn row_29_an_empty_target_has_no_last_column() {
    let [naive, ours] = smallest_targets();
    println!(
        "row 29, `width - 1`: {} of 2 000 boxes reach beyond the target; topleft {ours} px wrong",
        grouped(naive)
    );
    // Five of six sizes have no column or no row; a triangle left of or above it all has an empty box.
    assert!(naive > 1_000);
    assert_eq!(ours, 0);
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
fn row_30_a_cast_moves_what_is_left_of_or_above_the_origin() {
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

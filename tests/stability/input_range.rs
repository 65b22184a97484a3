//! Rows 27 to 30: numbers that are none, or at the ends of their range, and targets of no size or beside the origin.

use std::cell::Cell;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::prelude::*;
use reference::naive::{edge_function, scanline, snap};
use reference::raster::{counts_by, coverage_counts};
use reference::setup::Triangle;
use reference::transform::Viewport;
use topleft::{
    Coord, Cull, Flat, ListTriangle, Mesh, NoDepth, Orthographic, Pose, ShadedTriangle, Strip, point,
};

use crate::coverage::sent;
use crate::edges::to_edges;
use crate::figure::{Tally, grouped};
use crate::support::check;
use crate::support::counter::{StrictDisplay, placed};
use crate::support::tolerance::FLAT_CLIPPED;

const PANEL: Size = Size::new(40, 40);
const VIEW: Viewport = Viewport { width: 40, height: 40 };

/// How often the pixels of a panel are sent for triangles of floats.
fn sent_floats(triangles: &[[[f32; 2]; 3]]) -> Vec<u32> {
    let mut display = StrictDisplay::new(Rectangle::new(Point::zero(), PANEL));
    for triangle in triangles {
        let corners = triangle.map(|[x, y]| point(x, y));
        ShadedTriangle::flat(corners, Rgb565::RED).draw(&mut display).expect("this display does not fail");
    }
    display.writes
}

/// Triangles with a corner that is not a number: pixels that a cast draws, the fewest of one triangle, and `topleft`;
/// and huge fans as 32-bit edge functions draw them, and `topleft`.
pub(crate) fn floats() -> (u64, u32, Tally, [Tally; 2]) {
    let (drawn, fewest, ours) = (Cell::new(0), Cell::new(u32::MAX), Tally::default());
    let corners = [30.0..40.0_f32, 0.0..10.0_f32];
    let bad = prop::sample::select(vec![f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY]);
    check(2_000, &(corners.clone(), corners, bad, 0..6_usize), |([ax, ay], [by, bx], bad, place)| {
        let nowhere = [[ax, ay], [bx, by], [f32::NAN; 2]];
        let cast = nowhere.map(|corner| corner.map(|c| snap::cast(f64::from(c), 8)));
        let pixels = coverage_counts(&[cast], VIEW).iter().sum();
        drawn.set(drawn.get() + u64::from(pixels));
        fewest.set(fewest.get().min(pixels));
        let mut one = [[ax, ay], [bx, by], [5.0, 5.0]];
        one[place / 2][place % 2] = bad;
        match ours.add(&sent_floats(&[nowhere]), &[0; 1600]) + ours.add(&sent_floats(&[one]), &[0; 1600]) {
            0 => Ok(()),
            wrong => Err(format!("{wrong} px are drawn of a triangle that is nowhere")),
        }
    });
    let huge = [Tally::default(), Tally::default()];
    let far = || (20..127_i32).prop_map(|exponent| 2.0_f32.powi(exponent));
    let reach = prop_oneof![Just(f32::MAX), far(), 1e7..1e30_f32];
    let fans =
        ([1.0..39.0_f32, 1.0..39.0_f32], prop::array::uniform4([reach.clone().boxed(), reach.boxed()]));
    check(500, &fans, |(hub, reaches)| {
        let signs = [[1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
        let ring: Vec<[f32; 2]> =
            signs.iter().zip(reaches).map(|(s, r)| [s[0] * r[0], s[1] * r[1]]).collect();
        let fan: Vec<[[f32; 2]; 3]> = (0..4).map(|i| [hub, ring[i], ring[(i + 1) % 4]]).collect();
        // A corner a quadrant, 2^20 px or more away on both axes: the fan covers the panel once.
        let cast: Vec<Triangle> =
            fan.iter().map(|t| t.map(|p| p.map(|c| snap::cast(f64::from(c), 8)))).collect();
        let right = [1; 1600];
        huge[0].add(&counts_by(edge_function::in_32_bits, &cast, VIEW), &right);
        match huge[1].add(&sent_floats(&fan), &right) {
            0 => Ok(()),
            wrong => Err(format!("{wrong} px are wrong")),
        }
    });
    (drawn.get(), fewest.get(), ours, huge)
}

// Red when a point that is not finite is drawn, or a float beyond the range wraps: `steps` and `snapped` in src/point.rs.
#[test]
fn row_27_what_is_not_a_number_moves_into_the_corner() {
    let (drawn, fewest, ours, [naive, huge]) = floats();
    println!(
        "row 27, `as i32`: {} px drawn of 2 000 triangles with a NaN, {fewest} or more each; topleft {}; up to 1e38 px in i32 edge functions {} of {} px wrong; topleft {}",
        grouped(drawn),
        ours.wrong(),
        grouped(naive.wrong()),
        grouped(naive.pixels()),
        huge.wrong()
    );
    // (0, 0), (30, 10) and (10, 30) are its least: (900 - 100) / 2 = 400 px², less its border, at most a pixel for each
    // of the 30 rows at either side.
    assert!(fewest >= 400 - 2 * 30);
    assert_eq!(ours.wrong(), 0);
    // Three edges of four leave the range everywhere: that all of a pixel's come out right is chance.
    assert!(naive.wrong() * 4 > naive.pixels());
    assert_eq!(huge.wrong(), 0);
}

/// Fans to the ends of the range: of how many triangles the area does not fit 32 bits, 32-bit edge functions, and
/// `topleft`; and the most hits of a pixel by any triangle of any numbers.
pub(crate) fn whole_range() -> (u64, Tally, Tally, u32) {
    let (overflows, naive, ours, most) = (Cell::new(0), Tally::default(), Tally::default(), Cell::new(0));
    let least = prop_oneof![Just(i32::MIN), i32::MIN..i32::MIN + 1000];
    let greatest = prop_oneof![Just(i32::MAX), i32::MAX - 1000..=i32::MAX];
    let place = 256..39 * 256_i32;
    let fans = ([place.clone(), place], least, greatest, prop::array::uniform6(any::<i32>()));
    check(1_000, &fans, |(hub, least, greatest, any)| {
        let ring = [[greatest, least], [least, least], [least, greatest], [greatest, greatest]];
        let fan: Vec<Triangle> = (0..4).map(|i| [hub, ring[i], ring[(i + 1) % 4]]).collect();
        let lost = fan.iter().filter(|&&triangle| snap::area2_in_32_bits(triangle).is_none()).count();
        overflows.set(overflows.get() + lost as u64);
        naive.add(&counts_by(edge_function::in_32_bits, &fan, VIEW), &[1; 1600]);
        let wrong = ours.add(&sent(&fan, PANEL), &[1; 1600]);
        let [a, b, c, d, e, f] = any;
        let triangle = [[a, b], [c, d], [e, f]];
        let hits = sent(&[triangle], PANEL);
        most.set(hits.iter().copied().fold(most.get(), u32::max));
        // A fan hides corners that are moved: neighbours share them. A triangle alone does not, but where the guard
        // rectangle cuts it.
        for (at, (&hits, right)) in hits.iter().zip(coverage_counts(&[triangle], VIEW)).enumerate() {
            let away = to_edges(triangle, at as i64 % 40, at as i64 / 40);
            if hits != right && away > FLAT_CLIPPED {
                return Err(format!("{hits} hits, {away} steps from the edges of {triangle:?}"));
            }
        }
        if wrong == 0 && most.get() <= 1 { Ok(()) } else { Err(format!("{wrong} px are wrong")) }
    });
    (overflows.get(), naive, ours, most.get())
}

// Red when a difference of coordinates is taken in 32 bits before the triangle is clipped: `guard_distances`, `crossing`.
#[test]
fn row_28_coordinates_at_the_ends_of_their_range_overflow() {
    let (overflows, naive, ours, most) = whole_range();
    println!(
        "row 28, areas in i32: {} of 4 000 overflow; wrapped edge functions {} of {} px wrong; topleft {}, {most} hit a px at most",
        grouped(overflows),
        grouped(naive.wrong()),
        grouped(naive.pixels()),
        ours.wrong()
    );
    // Each has a corner at the least end, and the hub is right of and below 0: their difference does not fit.
    assert_eq!(overflows, 4_000);
    assert!(naive.wrong() * 4 > naive.pixels());
    assert_eq!((ours.wrong(), most), (0, 1));
}

/// Targets without a column or a row: pixels in boxes that end at `size - 1`; pixels that `topleft` sends to them or
/// beyond a clipped part, or writes beside a strip.
pub(crate) fn empty_targets() -> (u64, u64) {
    let (naive, ours) = (Cell::new(0), Cell::new(0_u64));
    let corner = || [-20 * 256..60 * 256_i32, -20 * 256..60 * 256_i32];
    let sizes = prop::sample::select(vec![[0_u32, 0], [0, 7], [7, 0], [1, 1]]);
    let cases = ([corner(), corner(), corner()], sizes, [-50..50_i32, -50..50_i32]);
    check(2_000, &cases, |(triangle, [width, height], origin)| {
        let corners = triangle.map(|[x, y]| topleft::Point::new(Coord::from_bits(x), Coord::from_bits(y)));
        let shaded = ShadedTriangle::flat(corners, Rgb565::RED);
        let size = Size::new(width, height);
        if width * height == 0 {
            let [columns, rows] = scanline::box_inside(triangle, Viewport { width, height });
            naive.set(naive.get() + columns.count() as u64 * rows.count() as u64);
        }
        // The display panics at a pixel that is not its own.
        let mut display = StrictDisplay::new(Rectangle::new(Point::new(origin[0], origin[1]), size));
        shaded.draw(&mut display).map_err(|error| format!("{error:?}"))?;
        let sent: u32 = display.writes.iter().sum();
        let right: u32 = coverage_counts(&[triangle], Viewport { width, height }).iter().sum();
        // A scissor beside the display.
        let mut display = StrictDisplay::<Rgb565>::new(Rectangle::new(Point::zero(), PANEL));
        let beside = Rectangle::new(Point::new(40 + origin[0].abs(), -1), Size::new(9, 9));
        shaded.draw(&mut display.clipped(&beside)).map_err(|error| format!("{error:?}"))?;
        let beside: u32 = display.writes.iter().sum();
        // Rows of a list that no strip has, between guarded cells.
        let positions = [[-32_768, -32_768, 0], [32_767, -32_768, 0], [0, 32_767, 0]];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).expect("three vertices");
        let mut storage = ([0; 16], [ListTriangle::EMPTY; 4]);
        let mut list = topleft::DrawList::<u16, NoDepth>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        let camera = Orthographic::new(size, 2.0, -2.0..2.0);
        list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED))
            .map_err(|error| format!("{error:?}"))?;
        let mut cells = [GUARD; 7 * 9];
        if width > 0 {
            let within = &mut cells[7..7 * 8];
            let whole_rows = within.len() / width as usize * width as usize;
            let mut strip =
                Strip::new(width as u16, &mut within[..whole_rows]).map_err(|e| format!("{e:?}"))?;
            for rows in [0..0, std::ops::Range { start: 5, end: 2 }, 900..903, -8..-1] {
                list.render(rows, &mut strip);
            }
        }
        let beyond = cells[..7].iter().chain(&cells[7 * 8..]).filter(|&&cell| cell != GUARD).count();
        ours.set(ours.get() + u64::from(sent.abs_diff(right) + beside) + beyond as u64);
        if ours.get() == 0 { Ok(()) } else { Err("pixels are written where there are none".into()) }
    });
    (naive.get(), ours.get())
}

/// What stands beside a strip.
const GUARD: u16 = 0xA55A;

// Red when a window's last column or row is used as such, and not the one behind it: `Display`, `render`.
#[test]
fn row_29_a_target_without_pixels_has_no_last_one() {
    let (naive, ours) = empty_targets();
    println!("row 29, boxes to `size - 1`: {} px of targets without any; topleft {ours}", grouped(naive));
    // Each box has one column and one row at least, and three in four of 2 000 targets are empty, less 1 in 10 for chance.
    assert!(naive > 1_350);
    assert_eq!(ours, 0);
}

/// Triangles left of and above the origin moved by whole pixels: what a cast to whole pixels makes of it, and `topleft`;
/// and how far the centre of a target lies from where its half in whole pixels is, and from where `topleft` puts it.
pub(crate) fn origins() -> (Tally, Tally, [u64; 2]) {
    let (naive, ours, off) = (Tally::default(), Tally::default(), [Cell::new(0), Cell::new(0)]);
    let corner = || [-30 * 256..-256_i32, -30 * 256..-256_i32];
    let cases = ([corner(), corner(), corner()], [30..=34_i32, 30..=34_i32], [0..20_u32, 0..20_u32]);
    check(2_000, &cases, |(triangle, by, half)| {
        let moved: Triangle = triangle.map(|p| [0, 1].map(|k| p[k] + by[k] * 256));
        let floats = |t: Triangle| t.map(|p| p.map(|c| f64::from(c) / 256.0));
        let cast = |t: Triangle| floats(t).map(|p| p.map(|c| snap::cast(c, 0)));
        let cast_then_moved: Triangle = cast(triangle).map(|p| [0, 1].map(|k| p[k] + by[k] * 256));
        naive.add(&coverage_counts(&[cast_then_moved], VIEW), &coverage_counts(&[cast(moved)], VIEW));
        // A part of the display that lies `by` from its origin, and has the origin of the points at its own.
        let mut display = StrictDisplay::new(Rectangle::new(Point::new(-by[0], -by[1]), PANEL));
        let mut from_origin = display.translated(Point::zero());
        let points = floats(moved).map(|[x, y]| point(x as f32, y as f32));
        ShadedTriangle::flat(points, Rgb565::RED).draw(&mut from_origin).map_err(|e| format!("{e:?}"))?;
        let wrong = ours.add(&display.writes, &coverage_counts(&[moved], VIEW));
        // A target of an odd number of columns and rows: its centre is that of a pixel.
        let [width, height] = half.map(|half| 2 * half + 1);
        let camera = Orthographic::new(Size::new(width, height), 2.0, -2.0..2.0);
        let positions = [[0; 3], [9_000, 0, 0], [0, 9_000, 0]];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).expect("three vertices");
        let words = placed(&camera, &mesh, &Pose::new()).words;
        let centre = [width, height].map(|size| size * 128);
        let halves = [width, height].map(|size| size / 2 * 256);
        let away = |place: [u32; 2]| u64::from(place[0].abs_diff(centre[0]) + place[1].abs_diff(centre[1]));
        off[0].set(off[0].get() + away(halves));
        off[1].set(off[1].get() + away([words[0], words[1]]));
        if wrong == 0 && off[1].get() == 0 { Ok(()) } else { Err(format!("{wrong} px move, or the centre")) }
    });
    (naive, ours, off.map(Cell::into_inner))
}

// Red when the centre of a viewport is a whole pixel: `centred`.
#[test]
fn row_30_what_is_cut_to_whole_pixels_jumps_at_the_origin() {
    let (naive, ours, [halves, centre]) = origins();
    println!(
        "row 30, `as i32` left of the origin: {} px of 2 000 triangles change when moved by whole pixels; topleft {}; size / 2 is {halves} steps from the centres of 2 000 odd targets; topleft {centre}",
        grouped(naive.wrong()),
        ours.wrong()
    );
    // All corners but whole ones are cut to the right and down before, and to the left and up after: the triangle moves
    // by a pixel both ways, and changes a pixel at either end of its rows. Its height is 29 / 2 rows on average: three
    // points of a range are half of it apart. A quarter of those for edges that run along the move.
    assert!(naive.wrong() > 2_000 * 2 * 14 / 4);
    assert_eq!(ours.wrong(), 0);
    assert_eq!((halves, centre), (2_000 * 2 * 128, 0));
}

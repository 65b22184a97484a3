//! Rows 1, 2, 3, 4 and 13: pixels that two triangles take, or none.

use std::cell::Cell;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::prelude::*;
use reference::naive::{edge_function, scanline, screen_clip, triangles};
use reference::raster::{counts_by, coverage_counts};
use reference::setup::Triangle;
use reference::transform::Viewport;
use scenes::mesh::GRID240;
use topleft::{BoxWalk, Coord, Orthographic, Point as Corner, Pose, ShadedTriangle, Spans};

use crate::figure::{Tally, grouped, unsigned};
use crate::support::check;
use crate::support::counter::{ALL, StrictDisplay, draw};
use crate::support::winding::{Edge, hits, setup, winding_of};

/// The edges of a ring of points.
fn edges(ring: &[[i32; 2]]) -> Vec<Edge> {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(&from, &to)| [from, to]).collect()
}

/// Adds what both walks make of the triangles; an error where it is not right.
fn add_both_walks(triangles: &[Triangle], right: &[u32], width: usize, ours: &Tally) -> Result<(), String> {
    let height = right.len() / width;
    let spans = hits::<Spans>(triangles.iter().copied(), width, height);
    let boxes = hits::<BoxWalk>(triangles.iter().copied(), width, height);
    match ours.add(&unsigned(&spans.all), right) + ours.add(&unsigned(&boxes.all), right) {
        0 => Ok(()),
        wrong => Err(format!("{wrong} px are not hit as often as they should be")),
    }
}

/// How often a display's pixels are sent when triangles are drawn to it one by one.
pub(crate) fn sent(triangles: &[Triangle], size: Size) -> Vec<u32> {
    let mut display = StrictDisplay::new(Rectangle::new(Point::zero(), size));
    for triangle in triangles {
        let corners = triangle.map(|[x, y]| Corner::new(Coord::from_bits(x), Coord::from_bits(y)));
        ShadedTriangle::flat(corners, Rgb565::RED).draw(&mut display).expect("this display does not fail");
    }
    display.writes
}

pub(crate) fn common_divisor(a: i32, b: i32) -> i32 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

/// Rectangles whose corners are centres of pixels, split along either diagonal: the centres hit twice by inclusive
/// tests, those hit by no exclusive one, and what `topleft` does.
pub(crate) fn shared_edges_through_centres() -> (u64, u64, Tally) {
    const VIEW: Viewport = Viewport { width: 40, height: 40 };
    let (twice, never, ours) = (Cell::new(0), Cell::new(0), Tally::default());
    let rectangles = ([0..16_i32, 0..16_i32], [1..24_i32, 1..24_i32], any::<bool>());
    check(5_000, &rectangles, |(start, [width, height], rising)| {
        let pair = triangles::rectangle_on_centres(start, [width, height], rising);
        let [left, top] = start.map(|pixel| pixel * 256 + 128);
        let (right, bottom) = (left + width * 256, top + height * 256);
        let outline = [[left, top], [left, bottom], [right, bottom], [right, top]];
        let exact = unsigned(&winding_of(&edges(&outline), 40, 40));

        let on_the_edge = common_divisor(width, height) as u64 + 1;
        let inclusive = counts_by(edge_function::inclusive, &pair, VIEW);
        let doubles = inclusive.iter().filter(|&&hits| hits > 1).count() as u64;
        if doubles != on_the_edge {
            return Err(format!("{doubles} of {on_the_edge} centres on the edge are hit twice"));
        }
        // The ends of the edge are corners: they belong to others, if to any.
        let exclusive = counts_by(edge_function::exclusive, &pair, VIEW);
        let inside = (width as u64 - 1) * (height as u64 - 1);
        let holes = inside - exclusive.iter().map(|&hits| u64::from(hits)).sum::<u64>();
        if holes != on_the_edge - 2 {
            return Err(format!("{holes} of {} centres on the edge are not hit", on_the_edge - 2));
        }
        twice.set(twice.get() + doubles);
        never.set(never.get() + holes);
        add_both_walks(&pair, &exact, 40, &ours)
    });
    (twice.get(), never.get(), ours)
}

// Red when a centre on an edge belongs to both of its triangles, or to none: `first_centre`, `top_left`.
#[test]
fn row_1_a_shared_edge_through_pixel_centres_is_drawn_twice_or_not_at_all() {
    let (twice, never, ours) = shared_edges_through_centres();
    println!(
        "row 1, barycentrics in [0, 1]: {} px of 5 000 edges drawn twice; above 0: {} px not drawn; topleft {} of {} px wrong",
        grouped(twice),
        grouped(never),
        ours.wrong(),
        grouped(ours.pixels())
    );
    // Each edge has both its ends on centres.
    assert!(twice >= 2 * 5_000 && never > 0);
    assert_eq!(ours.wrong(), 0);
}

/// The mesh of peers' measurements as whole-pixel rows with both ends: pixels drawn more than once, and what `topleft` does.
pub(crate) fn inclusive_rows_of_a_grid() -> (u64, Tally) {
    let camera = Orthographic::new(Size::new(240, 240), 240.0, -1.0..1.0);
    let drawn = draw(&camera, &GRID240, &Pose::new(), ALL);
    let at = |vertex: u16| [0, 1].map(|axis| drawn.words[usize::from(vertex) * 2 + axis].cast_signed());
    let triangles: Vec<Triangle> = GRID240.faces().iter().map(|face| face.map(at)).collect();
    let inclusive = scanline::counts(&triangles, Viewport { width: 240, height: 240 });
    let ours = Tally::default();
    ours.add(&unsigned(&drawn.hits), &[1; 240 * 240]);
    (inclusive.iter().filter(|&&hits| hits > 1).count() as u64, ours)
}

// Red when one of the grid's edges is hit twice or not at all.
#[test]
fn row_1_rows_with_both_ends_draw_a_mesh_twice_along_its_edges() {
    let (twice, ours) = inclusive_rows_of_a_grid();
    println!(
        "row 1, whole pixels and rows with both ends, grid240: {} of 57 600 px drawn twice or more; topleft {}",
        grouped(twice),
        ours.wrong()
    );
    // 736 inner edges of 15 px or more share a pixel at least in every row that they cross: on average half of 15.
    assert!(twice > 5_000);
    assert_eq!(ours.wrong(), 0);
}

/// Fans of 24 round the centre of a pixel: the most hits of one pixel by inclusive tests, the hubs that no exclusive
/// test hits, and what `topleft` does.
pub(crate) fn fans_of_24() -> (u32, u64, Tally) {
    const VIEW: Viewport = Viewport { width: 40, height: 40 };
    let (most, never, ours) = (Cell::new(0), Cell::new(0), Tally::default());
    let fans = ([16..24_i32, 16..24_i32], 6.0..16.0, 0.0..1.0, prop_oneof![Just(128), Just(1)]);
    check(2_000, &fans, |(hub, radius, phase, lattice)| {
        let place = hub.map(|pixel| pixel * 256 + 128);
        let ring = triangles::ring(place, radius, 24, phase, lattice);
        let fan = triangles::fan(place, &ring);
        let exact = unsigned(&winding_of(&edges(&ring), 40, 40));
        if exact.iter().any(|&hits| hits > 1) {
            return Err("the fan is folded".into());
        }
        let at_hub = (hub[1] * 40 + hub[0]) as usize;
        let inclusive = counts_by(edge_function::inclusive, &fan, VIEW);
        most.set(most.get().max(inclusive[at_hub]));
        let exclusive = counts_by(edge_function::exclusive, &fan, VIEW);
        never.set(never.get() + u64::from(exclusive[at_hub] == 0));
        add_both_walks(&fan, &exact, 40, &ours)
    });
    (most.get(), never.get(), ours)
}

// Red as above, and when an edge is rounded differently for its two sides.
#[test]
fn row_2_the_hub_of_a_fan_is_drawn_by_all_its_triangles() {
    let (most, never, ours) = fans_of_24();
    println!(
        "row 2, barycentrics in [0, 1]: {most} hits on the hub of 24 triangles; above 0: {} of 2 000 hubs not drawn; topleft {} of {} px wrong",
        grouped(never),
        ours.wrong(),
        grouped(ours.pixels())
    );
    assert_eq!((most, never), (24, 2_000));
    assert_eq!(ours.wrong(), 0);
}

/// Fans that reach 1300 px over a panel of 320 x 240: 32-bit edge functions, and `topleft`.
pub(crate) fn large_fans() -> (Tally, Tally) {
    const VIEW: Viewport = Viewport { width: 320, height: 240 };
    let (naive, ours) = (Tally::default(), Tally::default());
    let fans = ([0..320 * 256_i32, 0..240 * 256_i32], 700.0..1300.0, 0.0..1.0);
    check(150, &fans, |(hub, radius, phase)| {
        let ring = triangles::ring(hub, radius, 8, phase, 1);
        let fan = triangles::fan(hub, &ring);
        let exact = unsigned(&winding_of(&edges(&ring), 320, 240));
        if exact.iter().any(|&hits| hits != 1) {
            return Err("the fan does not cover the panel once".into());
        }
        naive.add(&counts_by(edge_function::in_32_bits, &fan, VIEW), &exact);
        add_both_walks(&fan, &exact, 320, &ours)
    });
    (naive, ours)
}

// Red when `EdgeFunction` keeps all 8 sub-pixel bits in its `i32`, or `Edge::step` loses a remainder.
#[test]
fn row_3_edge_functions_of_32_bits_overflow_on_large_triangles() {
    let (naive, ours) = large_fans();
    println!(
        "row 3, i32 edge functions: {} of {} px wrong ({} missing, {} extra); topleft {} of {}",
        grouped(naive.wrong()),
        grouped(naive.pixels()),
        grouped(naive.missing()),
        grouped(naive.extra()),
        ours.wrong(),
        grouped(ours.pixels())
    );
    // An edge of 700 px or more does not fit beyond 47 px from it, 2^31 / (700 * 2^16), where it is as often negative
    // as not; the panel is wider. A quarter leaves room for pixels that are right by accident.
    assert!(naive.wrong() * 4 > naive.pixels());
    assert_eq!(ours.wrong(), 0);
}

/// Right-angled triangles of 3500 to 4000 px over all of a panel: what the steps of 2^-8 px² leave undrawn where nothing
/// guards their range, and what `topleft` does.
pub(crate) fn beyond_the_guard() -> (Tally, Tally) {
    const VIEW: Viewport = Viewport { width: 320, height: 240 };
    let (naive, ours) = (Tally::default(), Tally::default());
    let legs = [3500..=4000_i32, 3500..=4000_i32];
    check(100, &([1..50 * 256_i32, 1..50 * 256_i32], legs, any::<[bool; 2]>()), |(beside, legs, turned)| {
        let corner = [0, 1].map(|k| if turned[k] { [320, 240][k] * 256 + beside[k] } else { -beside[k] });
        let triangle =
            triangles::right_angle(corner, [0, 1].map(|k| if turned[k] { -legs[k] } else { legs[k] }));
        if setup(triangle).is_some() {
            return Err("set-up takes a triangle that its numbers cannot hold".into());
        }
        let exact = coverage_counts(&[triangle], VIEW);
        naive.add(&counts_by(edge_function::without_guard, &[triangle], VIEW), &exact);
        match ours.add(&sent(&[triangle], Size::new(320, 240)), &exact) {
            0 => Ok(()),
            wrong => Err(format!("{wrong} px are wrong")),
        }
    });
    (naive, ours)
}

// Red when `Setup::new` takes what is larger than the guard rectangle, or `ShadedTriangle` does not clip there.
#[test]
fn row_4_a_triangle_larger_than_its_numbers_vanishes_in_silence() {
    let (naive, ours) = beyond_the_guard();
    println!(
        "row 4, 2^-8 px² in i32 and no guard: {} of {} px missing; topleft {} wrong",
        grouped(naive.missing()),
        grouped(naive.pixels()),
        ours.wrong()
    );
    // Everywhere on the panel the third edge's value is from 2^23 up to 2^24 px²: at most 4000² = 0.95 * 2^24, at least
    // (3500² - 3500 (370 + 290)) = 1.18 * 2^23. In steps of 2^-8 that is a negative `i32`.
    assert_eq!(naive.missing(), naive.pixels());
    assert_eq!(ours.wrong(), 0);
}

/// Spokes in all four quadrants, and one beside the first, that reach 1100 to 1500 px from a hub on a centre, through
/// further centres: where the hub's triangles are clipped by size, and what `topleft` does; and how many fans are torn.
pub(crate) fn fans_across_the_guard() -> (Tally, Tally, u32) {
    const VIEW: Viewport = Viewport { width: 240, height: 240 };
    const GUARD: [i32; 4] = [-1024 * 256, -1024 * 256, (240 + 1024) * 256, (240 + 1024) * 256];
    let (naive, ours, torn) = (Tally::default(), Tally::default(), Cell::new(0));
    let slope = || prop::sample::select(vec![[3, 1], [5, 2], [4, 3], [7, 3], [1, 3], [2, 5]]);
    let lengths = prop::array::uniform5(1_100..1_500_i32);
    let fans = ([60..180_i32, 60..180_i32], [slope(), slope(), slope(), slope()], lengths);
    check(100, &fans, |(hub, slopes, lengths)| {
        let hub = hub.map(|pixel| pixel * 256 + 128);
        let signs = [[1, -1], [-1, -1], [-1, 1], [1, 1]];
        let mut directions: Vec<[i32; 2]> =
            signs.iter().zip(slopes).map(|(sign, slope)| [0, 1].map(|k| sign[k] * slope[k])).collect();
        directions.push([16, 1]);
        let ring: Vec<[i32; 2]> = directions
            .iter()
            .zip(lengths)
            .map(|([x, y], length)| {
                let times = length / x.abs().max(y.abs());
                [hub[0] + x * times * 256, hub[1] + y * times * 256]
            })
            .collect();
        let fan = triangles::fan(hub, &ring);
        let exact = unsigned(&winding_of(&edges(&ring), 240, 240));
        if exact.iter().any(|&hits| hits != 1) {
            return Err("the fan does not cover the panel once".into());
        }
        let parts = screen_clip::by_size(&fan, 2_048, GUARD);
        torn.set(torn.get() + u32::from(naive.add(&coverage_counts(&parts, VIEW), &exact) > 0));
        match ours.add(&sent(&fan, Size::new(240, 240)), &exact) {
            0 => Ok(()),
            wrong => Err(format!("{wrong} px are wrong")),
        }
    });
    (naive, ours, torn.get())
}

// Red when what is clipped at the guard rectangle is decided for a triangle, and not for a vertex and a plane: `cut`.
#[test]
fn row_13_clipping_by_size_tears_the_edge_of_the_neighbour() {
    let (naive, ours, torn) = fans_across_the_guard();
    println!(
        "row 13, clipped where wider than 2 048 px: {} px wrong in {torn} of 100 fans ({} missing, {} extra); topleft {}",
        grouped(naive.wrong()),
        grouped(naive.missing()),
        grouped(naive.extra()),
        ours.wrong()
    );
    assert!(torn >= 50 && naive.missing() > 0 && naive.extra() > 0);
    assert_eq!(ours.wrong(), 0);
}

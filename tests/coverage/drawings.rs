//! The fill rule as drawings. The mock display panics where a pixel is drawn twice or outside.

use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use topleft::{Point as Corner, ShadedTriangle, point};

const COLOURS: [Rgb888; 6] =
    [Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE, Rgb888::YELLOW, Rgb888::CYAN, Rgb888::MAGENTA];

/// Draws triangles in different colours, each pixel at most once.
fn drawn(triangles: &[[Corner; 3]]) -> MockDisplay<Rgb888> {
    let mut display = MockDisplay::new();
    for (triangle, &colour) in triangles.iter().zip(COLOURS.iter().cycle()) {
        let Ok(()) = ShadedTriangle::flat(*triangle, colour).draw(&mut display);
    }
    display
}

// Red when a centre on a right or bottom edge is covered, or one on a top or left edge is not: `first_centre`.
#[test]
fn top_and_left_edges_are_inside_right_and_bottom_edges_are_not() {
    // The square's corners are pixel centres: its first row and column are drawn, its last ones are not.
    let [a, b, c, d] = [point(1.5, 1.5), point(5.5, 1.5), point(5.5, 5.5), point(1.5, 5.5)];
    drawn(&[[a, b, c], [a, c, d]]).assert_pattern(&[
        "      ", //
        " RRRR ", //
        " GRRR ", //
        " GGRR ", //
        " GGGR ", //
        "      ",
    ]);
    drawn(&[[a, b, d], [b, c, d]]).assert_pattern(&[
        "      ", //
        " RRRR ", //
        " RRRG ", //
        " RRGG ", //
        " RGGG ", //
        "      ",
    ]);
}

// Red when the way a triangle turns decides on a pixel: the swap in `Spans` or in `BoxWalk` going missing.
#[test]
fn either_way_round_is_the_same_drawing() {
    let [a, b, c] = [point(0.5, 6.5), point(3.5, 0.5), point(7.5, 4.5)];
    for corners in [[a, b, c], [b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]] {
        drawn(&[corners])
            .assert_pattern(&["        ", "   R    ", "  RRR   ", "  RRRR  ", " RRRRRR ", " RRR    "]);
    }
}

// Red when a hub on a pixel centre is hit twice or never: `>= 0` and `> 0` in place of the top-left bias.
#[test]
fn a_hub_on_a_pixel_centre_belongs_to_one_triangle() {
    let hub = point(3.5, 3.5);
    let ring = [
        point(7.0, 3.5),
        point(5.25, 0.0),
        point(1.75, 0.0),
        point(0.0, 3.5),
        point(1.75, 7.0),
        point(5.25, 7.0),
    ];
    let fan: Vec<_> = (0..6).map(|i| [hub, ring[i], ring[(i + 1) % 6]]).collect();
    drawn(&fan).assert_pattern(&[
        " BGGG  ", //
        " BGGRR ", //
        "BBBGRR ", //
        "YYYMMMM", //
        "YYYCMM ", //
        " YCCMM ", //
        " YCCC  ",
    ]);
}

// Red when coverage is rounded up to what a triangle touches: `first_centre` adding 255 in place of 127.
#[test]
fn what_holds_no_centre_draws_nothing() {
    let mut display = MockDisplay::<Rgb888>::new();
    for corners in [
        // Inside one pixel, beside its centre.
        [point(2.0, 2.0), point(2.49, 2.0), point(2.0, 2.49)],
        // Between two rows of centres, between two columns of them.
        [point(0.0, 3.51), point(9.0, 3.51), point(4.0, 4.49)],
        [point(3.51, 0.0), point(3.51, 9.0), point(4.49, 4.0)],
        // A line, and a point.
        [point(0.5, 0.5), point(8.5, 8.5), point(4.5, 4.5)],
        [point(4.5, 4.5), point(4.5, 4.5), point(4.5, 4.5)],
        // Right and bottom edges alone touch centres.
        [point(1.75, 1.75), point(2.5, 2.5), point(1.75, 2.5)],
    ] {
        let Ok(()) = ShadedTriangle::flat(corners, Rgb888::RED).draw(&mut display);
    }
    assert!(display.affected_area().is_zero_sized(), "{display:?}");
}

// Red when a sliver's slope is rounded before it is added up: `Edge` without its remainder.
#[test]
fn a_needle_is_cut_out_of_a_square_without_a_gap() {
    let [a, b, c, d] = [point(0.0, 0.0), point(12.0, 0.0), point(12.0, 4.0), point(0.0, 4.0)];
    // Red above the diagonal, green the needle under it that ends at the tip, blue and yellow the rest.
    let tip = point(7.0, 3.0);
    drawn(&[[a, b, c], [a, c, tip], [a, tip, d], [d, tip, c]]).assert_pattern(&[
        "BRRRRRRRRRRR", //
        "BBBGRRRRRRRR", //
        "BBBBBBGRRRRR", //
        "BBBYYYYYYGRR",
    ]);
}

// Red when the part of a triangle beyond the target is drawn, or bends what is left of it: the window of `Display`.
#[test]
fn what_is_beyond_the_target_is_cut_off() {
    let mut display = MockDisplay::<Rgb888>::new();
    let [a, b, c] = [point(-40.0, -40.0), point(4000.0, -40.0), point(-40.0, 4000.0)];
    let Ok(()) = ShadedTriangle::flat([a, b, c], Rgb888::BLUE).draw(&mut display);
    let whole: Vec<String> = vec!["B".repeat(64); 64];
    display.assert_pattern(&whole.iter().map(String::as_str).collect::<Vec<_>>());
}

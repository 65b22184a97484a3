//! Spans of single triangles, row by row, against the crossings of edges in 128-bit integers.

use std::cell::Cell;

use topleft::stages::Window;
use topleft::{BoxWalk, BySize, Spans};

use crate::support::check;
use crate::support::exact::{compare, expected};
use crate::support::measured::{Row, hold};
use crate::support::strategies::{Case, guard_sized, near_ties, slivers};

/// That the spans of triangles are exact, in both traversals.
fn agree(name: &str, cases: u32, strategy: &impl proptest::strategy::Strategy<Value = Case>) -> Row {
    let (visible, pixels) = (Cell::new(0_u64), Cell::new(0_u64));
    check(cases, strategy, |Case { triangle, window }| {
        let spans = expected(triangle, &window);
        visible.set(visible.get() + u64::from(!spans.is_empty()));
        pixels.set(pixels.get() + spans.iter().map(|span| (span.end - span.start) as u64).sum::<u64>());
        compare::<Spans>(triangle, &window, &spans)?;
        compare::<BoxWalk>(triangle, &window, &spans)?;
        compare::<BySize>(triangle, &window, &spans)
    });
    assert!(visible.get() * 10 > u64::from(cases), "most of the triangles are not seen in their windows");
    Row::none_of(pixels.get(), &format!("px of {cases} triangles"), "coverage", name, "spans and box walk")
}

pub(crate) fn ties() -> Row {
    agree("triangles with many ties", 300_000, &near_ties(12, 12))
}

pub(crate) fn middle_sized() -> Row {
    agree("triangles up to 60x40 px", 150_000, &near_ties(60, 40))
}

pub(crate) fn needles() -> Row {
    agree("slivers", 300_000, &slivers(48, 48))
}

pub(crate) fn as_large_as_the_guard() -> Row {
    agree("guard-sized triangles", 300_000, &guard_sized())
}

// Red when `Edge::skip`, or the rounding up in `Edge::new`, of src/raster/spans.rs is off by one for ties.
#[test]
fn near_ties_are_exact() {
    hold(&[ties()]);
}

// Red when `top_left` in src/raster/box_walk.rs takes one of its edges the other way.
#[test]
fn middle_sized_triangles_are_exact() {
    hold(&[middle_sized()]);
}

// Red when `floor_divide` in src/raster/spans.rs rounds towards zero.
#[test]
fn slivers_are_exact() {
    hold(&[needles()]);
}

// Red when `EdgeFunction::new` keeps all 8 fraction bits in its `i32`, or `skip` multiplies in fewer than 32 bits.
#[test]
fn guard_sized_triangles_are_exact() {
    hold(&[as_large_as_the_guard()]);
}

// Red when `Edge::step` in src/raster/spans.rs loses a remainder once in thousands of rows.
#[test]
fn whole_guard_sized_triangles_are_exact() {
    let rows = Cell::new(0);
    check(300, &guard_sized(), |Case { triangle, .. }| {
        let window = Window { columns: -2048..10_240, rows: -2048..6144 };
        let spans = expected(triangle, &window);
        rows.set(rows.get() + spans.len());
        compare::<Spans>(triangle, &window, &spans)
    });
    println!("{} rows", rows.get());
}

// Red when `first_centre` in src/snapped.rs rounds a coordinate on a centre the other way.
#[test]
fn all_triangles_of_a_half_pixel_lattice_are_exact() {
    let lattice: Vec<[i32; 2]> = (0..81).map(|i| [i % 9 * 128, i / 9 * 128]).collect();
    let mut count = 0;
    // On the screen, and where the first columns and rows are left of it and above it.
    for offset in [0, -192] {
        let window = Window { columns: 0..5, rows: 0..5 };
        let at = |i: usize| lattice[i].map(|c| c + offset);
        for a in 0..81 {
            for b in a..81 {
                for c in b..81 {
                    let [a, b, c] = [a, b, c].map(at);
                    let spans = expected([a, b, c], &window);
                    for triangle in [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
                        count += 1;
                        compare::<Spans>(triangle, &window, &spans)
                            .and_then(|()| compare::<BoxWalk>(triangle, &window, &spans))
                            .and_then(|()| compare::<BySize>(triangle, &window, &spans))
                            .unwrap_or_else(|error| panic!("{triangle:?}: {error}"));
                    }
                }
            }
        }
    }
    println!("{count} triangles");
}

// Red when `ShortEdge::suits` in src/raster/edge/short.rs looks at columns that have wrapped: without `few`.
#[test]
fn no_pixel_lies_outside_of_a_window_whatever_its_columns() {
    let triangle = [[300, 300], [5_000, 900], [700, 4_700]];
    let ends = [i32::MIN, -1 << 24, -2_048, -1, 0, 3, 9, 2_047, 2_048, 1 << 23, 1 << 24, i32::MAX];
    for start in ends {
        for end in ends {
            let window = Window { columns: start..end, rows: 0..32 };
            let spans = expected(triangle, &window);
            assert_eq!(spans.is_empty(), start.max(1) >= end.min(20), "{window:?}");
            compare::<Spans>(triangle, &window, &spans)
                .and_then(|()| compare::<BoxWalk>(triangle, &window, &spans))
                .and_then(|()| compare::<BySize>(triangle, &window, &spans))
                .unwrap_or_else(|error| panic!("{window:?}: {error}"));
        }
    }
}

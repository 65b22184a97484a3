//! Rows 5 to 9: triangles with little or no area.

use std::cell::Cell;

use embedded_graphics::prelude::*;
use proptest::prelude::*;
use reference::naive::{edge_function, plane, snap, triangles};
use reference::raster::{counts_by, coverage_counts, winding_numbers};
use reference::setup::{self, Triangle};
use reference::transform::Viewport;
use reference::varying::linear;
use topleft::stages::Varying;
use topleft::{Attribute, BoxWalk, Spans};

use crate::coverage::sent;
use crate::figure::grouped;
use crate::probe::{Covered, range};
use crate::random::{Kind, Random};
use crate::support::check;
use crate::support::tolerance::interpolation;
use crate::support::winding::{Edge, hits, winding_of};

const VIEW: Viewport = Viewport { width: 40, height: 40 };

/// Triangles without an area, on a lattice of half pixels or of 1/256: pixels that a test of one sign gives them, and
/// those that the library does.
pub(crate) fn without_area() -> [u64; 2] {
    let counts = [const { Cell::new(0) }; 2];
    let lattice = prop_oneof![Just(128), Just(1)];
    let line = ([2..20_i32, 2..20_i32], [-4..5_i32, -4..5_i32], prop::array::uniform3(-3..4_i32), lattice);
    check(1_000, &line, |(from, along, parts, unit)| {
        // Three points on a line, often two or all of them the same.
        let corner = |part: i32| [0, 1].map(|axis| from[axis] * 256 + 128 + along[axis] * part * unit);
        let [a, b, c] = parts.map(corner);
        for order in [[a, b, c], [b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]] {
            let naive = counts_by(edge_function::one_sign, &[order], VIEW)
                .iter()
                .map(|&hits| u64::from(hits))
                .sum::<u64>();
            let ours = sent(&[order], Size::new(40, 40)).iter().map(|&hits| u64::from(hits)).sum::<u64>();
            counts[0].set(counts[0].get() + naive);
            counts[1].set(counts[1].get() + ours);
        }
        if counts[1].get() == 0 { Ok(()) } else { Err("a line is drawn".into()) }
    });
    counts.map(|count| count.get())
}

// Red when an area of 0 is not left out: `Setup::sorted`. (Its reciprocal counts 0 as 1.)
#[test]
fn row_5_triangles_without_an_area_are_drawn_as_lines() {
    let [naive, ours] = without_area();
    println!(
        "row 5, one sign or 0: {} px of 6 000 triangles without an area; topleft {ours}",
        grouped(naive)
    );
    // Each line begins on a pixel's centre.
    assert!(naive > 6_000);
    assert_eq!(ours, 0);
}

/// Slivers that rounding turns over, between two triangles: pixels, those whose front less back hits are wrong where the
/// side is decided before rounding, and by the library.
pub(crate) fn turned_over() -> [u64; 3] {
    let counts = [const { Cell::new(0) }; 3];
    check(500, &([2..10_u8, 11..25_u8], 12..28_u8, 0.3..0.6), |(place, length, part)| {
        let places = triangles::turned_over(place.map(f64::from), length.into(), part);
        let snapped: Vec<Triangle> = places
            .iter()
            .map(|one| one.map(|place| place.map(|c| setup::snap(c).expect("finite"))))
            .collect();
        let edges: Vec<Edge> =
            snapped.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).filter(|[a, b]| a != b).collect();
        let exact = winding_of(&edges, 40, 40);
        let mut naive = vec![0; exact.len()];
        for (before, &after) in places.iter().zip(&snapped) {
            let sign = if snap::area2_before(*before) < 0.0 { 1 } else { -1 };
            for (sum, hits) in naive.iter_mut().zip(coverage_counts(&[after], VIEW)) {
                *sum += sign * hits as i32;
            }
        }
        if exact != winding_numbers(&snapped, VIEW) {
            return Err("the winding of edges is not that of triangles".into());
        }
        let wrong = |found: &[i32]| found.iter().zip(&exact).filter(|(a, b)| a != b).count() as u64;
        let spans = hits::<Spans>(snapped.iter().copied(), 40, 40);
        let boxes = hits::<BoxWalk>(snapped.iter().copied(), 40, 40);
        let ours = wrong(&spans.signed) + wrong(&boxes.signed);
        let pixels = exact.iter().filter(|&&winding| winding != 0).count() as u64;
        for (count, more) in counts.iter().zip([pixels, wrong(&naive), ours]) {
            count.set(count.get() + more);
        }
        if ours == 0 { Ok(()) } else { Err(format!("{ours} px are wrong")) }
    });
    counts.map(|count| count.get())
}

// Red when facing is not that of the snapped corners.
#[test]
fn row_6_a_sliver_turned_over_by_rounding_is_counted_as_what_it_was() {
    let [pixels, naive, ours] = turned_over();
    println!(
        "row 6, facing before rounding: {} of {} px wrong in 500 meshes; topleft {ours}",
        grouped(naive),
        grouped(pixels)
    );
    // The turned sliver lies on the centres of a row for 0.4 of its 12 to 27 px at the least: 4 px in each mesh.
    assert!(naive >= 4 * 500);
    assert_eq!(ours, 0);
}

/// A naive method, of the form of `linear`.
type Method = fn(Triangle, [f64; 3], i64, i64) -> f64;

/// The worst errors over triangles of a kind with values of 0 to 255: of a naive method, of the library, and the
/// library's largest share of its bound.
pub(crate) fn interpolated(kind: Kind, count: u32, naive: Method) -> [f64; 3] {
    let (mut worst, mut random) = ([0.0_f64; 3], Random::new(7));
    for _ in 0..count {
        let covered = Covered::new(kind.triangle(&mut random));
        let values = [(); 3].map(|()| random.within(0, 255) as f64);
        let gradients = covered.setup.gradients();
        let plane = Attribute::plane(&gradients, values.map(Attribute::from_num));
        let [ax, ay] = gradients.anchor();
        for span in &covered.spans {
            for x in [span.start, (span.start + span.end) / 2, span.end - 1] {
                let (column, row) = (i64::from(x), i64::from(span.y));
                let exact = linear(covered.triangle, values, column, row);
                let ours: f64 = plane.at(x - ax, span.y - ay).to_num();
                let bound = interpolation(16, covered.steps(x, span.y), range(values));
                let errors = [
                    naive(covered.triangle, values, column, row) - exact,
                    ours - exact,
                    (ours - exact) / bound,
                ];
                worst = [0, 1, 2].map(|i| worst[i].max(errors[i].abs()));
            }
        }
    }
    worst
}

fn print(row: u32, method: &str, [naive, ours, share]: [f64; 3]) {
    println!(
        "row {row}, {method}: {naive:.1} of 255 codes off at worst; topleft {ours:.5}, {share:.2} of its bound"
    );
}

// Red when gradients saturate, or their product with steps does not wrap: `Varying::times`.
#[test]
fn row_7_saturated_gradients_lose_slivers_of_a_256th_of_a_pixel() {
    let worst = interpolated(Kind::Needle, 20_000, plane::saturated);
    print(7, "saturated gradients", worst);
    // Saturated at 32 768 a pixel, where a needle of 1/256 px has up to 255 * 256 = 65 280: half of a gradient is missing,
    // times hundreds of pixels.
    assert!(worst[0] > 32_768.0);
    assert!(worst[2] <= 1.0);
}

// Red when the two gradients and the start are not made by one reciprocal: `Gradients`.
#[test]
fn row_8_planes_from_the_screens_corner_cancel_on_needles() {
    let worst = interpolated(Kind::Needle, 20_000, plane::from_the_corner);
    print(8, "f32 from the corner", worst);
    // Terms of 65 280 codes a pixel over 100 px and more have steps of 2^-1 and more in 24 bits.
    assert!(worst[0] > 0.5);
    assert!(worst[2] <= 1.0);
}

// Red when the area's reciprocal is not normalised: `recip::area`.
#[test]
fn row_8_a_reciprocal_of_32_bits_has_none_left_on_large_triangles() {
    let worst = interpolated(Kind::FullScreen, 500, plane::reciprocal_of_32_bits);
    print(8, "2^32 / area", worst);
    // An area of 300 x 200 px is 2^32 in 1/65536 px²: the reciprocal is 1 or 0, and up to all of a value is lost.
    assert!(worst[0] > 60.0);
    assert!(worst[2] <= 1.0);
}

/// T-junctions by vertices rounded to `bits` sub-pixel bits: pixels of the edges that are hit twice or not at all, those
/// that the needle in the gap covers, and those where the library is not exact.
pub(crate) fn t_junctions(bits: u32) -> [u64; 3] {
    const VIEW: Viewport = Viewport { width: 200, height: 200 };
    let counts = [const { Cell::new(0) }; 3];
    let ends = [[20.0..40.0, 80.0..120.0], [150.0..180.0, 80.0..120.0]];
    check(200, &(ends, 0.2..0.8), |(ends, part)| {
        let (three, needle) = triangles::t_junction(ends, part, bits);
        let exact = coverage_counts(&three, VIEW);
        let ours = sent(&three, Size::new(200, 200));
        // Outside of the outline, which the needle completes, no pixel counts.
        let [[p, q, over], [_, under, _], _] = three;
        let outline = winding_of(&[[p, under], [under, q], [q, over], [over, p]], 200, 200);
        let torn = ours.iter().zip(&outline).filter(|&(&hits, &once)| once != 0 && hits != 1).count() as u64;
        let gap = coverage_counts(&[needle], VIEW).iter().map(|&hits| u64::from(hits)).sum::<u64>();
        let inexact = ours.iter().zip(&exact).filter(|(a, b)| a != b).count() as u64;
        for (count, more) in counts.iter().zip([torn, gap, inexact]) {
            count.set(count.get() + more);
        }
        if inexact == 0 && torn <= gap { Ok(()) } else { Err(format!("{torn} px torn, {gap} in the gap")) }
    });
    counts.map(|count| count.get())
}

// A T-junction is an error of the mesh. Red when more is torn than what lies between the two edges as they were given.
#[test]
fn row_9_a_t_junction_tears_and_less_with_more_sub_pixel_bits() {
    let ([whole, gap_of_whole, _], [ours, gap, inexact]) = (t_junctions(0), t_junctions(8));
    println!(
        "row 9, whole pixels: {} px torn of 200 T-junctions ({} in the gap); topleft {ours} ({gap} in the gap), {inexact} not exact",
        grouped(whole),
        grouped(gap_of_whole)
    );
    assert!(whole > 200 && whole > 32 * ours.max(1));
    assert!(ours <= gap);
    assert_eq!(inexact, 0);
}

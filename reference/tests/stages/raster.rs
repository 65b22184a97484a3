use proptest::prelude::*;
use reference::raster::{coverage_counts, covers, pixel_box, row_span, winding_numbers};
use reference::setup::{Cull, Triangle, area2, facing};
use reference::transform::Viewport;

/// Corners in half pixels, drawn into 4 rows of 6.
fn drawing(corners: [[i32; 2]; 3]) -> [String; 4] {
    let triangle = corners.map(|corner| corner.map(|half_pixels| half_pixels * 128));
    [0, 1, 2, 3].map(|y| (0..6).map(|x| if covers(triangle, x, y) { '#' } else { '.' }).collect())
}

#[test]
fn left_and_top_edges_are_in_and_right_and_bottom_edges_are_out() {
    // Corners on pixel centres. The top left half of a square: its diagonal is a right edge.
    assert_eq!(drawing([[1, 1], [1, 7], [7, 1]]), ["###...", "##....", "#.....", "......"]);
    // The bottom right half: its diagonal is a left edge, so it has the centres on it, but not the bottom right ones.
    assert_eq!(drawing([[7, 1], [1, 7], [7, 7]]), ["......", "..#...", ".##...", "......"]);
    // The top right half and the bottom left half share a diagonal that belongs to the right one.
    assert_eq!(drawing([[1, 1], [7, 7], [7, 1]]), ["###...", ".##...", "..#...", "......"]);
    assert_eq!(drawing([[1, 1], [1, 7], [7, 7]]), ["......", "#.....", "##....", "......"]);
    // A tip up and a tip down, on centres: neither tip is drawn.
    assert_eq!(drawing([[5, 1], [1, 5], [9, 5]]), ["......", ".##...", "......", "......"]);
    assert_eq!(drawing([[1, 1], [9, 1], [5, 5]]), ["####..", ".##...", "......", "......"]);
}

/// Either side of every answer of `row_span`, against `covers`.
fn check_row(triangle: Triangle, y: i64) {
    let span = row_span(triangle, y);
    let mut columns: Vec<i64> = (-3..12).collect();
    columns.extend(triangle.iter().flat_map(|c| (-2..3).map(|d| i64::from(c[0] >> 8) + d)));
    if let Some((first, last)) = span {
        assert!(first < last, "empty span {span:?} of {triangle:?} in row {y}");
        columns.extend([first - 1, first, (first + last) / 2, last - 1, last]);
    }
    for x in columns {
        let wanted = span.is_some_and(|(first, last)| first <= x && x < last);
        assert_eq!(covers(triangle, x, y), wanted, "{triangle:?} at {x}, {y}: span {span:?}");
    }
}

fn check_rows(triangle: Triangle) {
    let rows = triangle.iter().flat_map(|c| (-1..2).map(|d| i64::from(c[1] >> 8) + d)).chain(0..10);
    rows.for_each(|y| check_row(triangle, y));
}

/// A coordinate near others: on the half-pixel lattice, a step beside it, anywhere near, or far out.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => (-4..20_i32).prop_map(|k| k * 128),
        2 => (-4..20_i32, -1..=1_i32).prop_map(|(k, d)| k * 128 + d),
        2 => -600..2_600_i32,
        1 => -400_000..400_000_i32,
        1 => any::<i32>(),
    ]
}

fn corner() -> impl Strategy<Value = [i32; 2]> {
    [coordinate(), coordinate()]
}

fn any_triangle() -> impl Strategy<Value = Triangle> {
    prop_oneof![
        [corner(), corner(), corner()],
        // Slivers: the third corner is a few steps beside the line through the others.
        (corner(), corner(), -64..320_i64, -2..=2_i32, -2..=2_i32).prop_map(|(a, b, t, dx, dy)| {
            let along = |i: usize| {
                let at = i64::from(a[i]) + (i64::from(b[i]) - i64::from(a[i])) * t / 256;
                at.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
            };
            [a, b, [along(0).saturating_add(dx), along(1).saturating_add(dy)]]
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100_000))]

    #[test]
    fn spans_are_what_the_edge_functions_cover(triangle in any_triangle()) {
        check_rows(triangle);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    /// A fan round any point of a rectangle covers every pixel centre of the rectangle once: the ones on its left and
    /// top edges, and not those on its right and bottom edges.
    #[test]
    fn a_fan_hits_every_pixel_of_its_rectangle_once(
        (left, right) in (0..900_i32, 1_000..2_048_i32),
        (top, bottom) in (0..900_i32, 1_000..2_048_i32),
        on_lattice: bool,
        hub in (0.0..1.0_f64, 0.0..1.0_f64),
        mut places in prop::collection::vec(0.0..4.0_f64, 0..20),
    ) {
        let grid = if on_lattice { 128 } else { 1 };
        let [left, right, top, bottom] = [left, right, top, bottom].map(|value| value / grid * grid);
        let between = |low: i32, high: i32, t: f64| low + (f64::from(high - low) * t) as i32 / grid * grid;
        // Round the border: along the top, down the right, and back.
        places.extend([0.0, 1.0, 2.0, 3.0]);
        places.sort_by(f64::total_cmp);
        let border: Vec<[i32; 2]> = places
            .iter()
            .map(|place| match (place.floor() as i32, place.fract()) {
                (0, t) => [between(left, right, t), top],
                (1, t) => [right, between(top, bottom, t)],
                (2, t) => [between(left, right, 1.0 - t), bottom],
                (_, t) => [left, between(top, bottom, 1.0 - t)],
            })
            .collect();
        let hub = [between(left, right, hub.0), between(top, bottom, hub.1)];
        let fan: Vec<Triangle> =
            (0..border.len()).map(|i| [hub, border[i], border[(i + 1) % border.len()]]).collect();
        let counts = coverage_counts(&fan, Viewport { width: 8, height: 8 });
        for (index, &count) in counts.iter().enumerate() {
            let centre = [index % 8, index / 8].map(|pixel| pixel as i32 * 256 + 128);
            let in_range = left <= centre[0] && centre[0] < right && top <= centre[1] && centre[1] < bottom;
            prop_assert_eq!(count, u32::from(in_range), "pixel {} of {:?}", index, fan);
        }
    }

    /// An octahedron round the eye's axis, its corners anywhere: closed, so every pixel's winding number is 0.
    #[test]
    fn a_closed_mesh_winds_round_nothing(corners in prop::array::uniform6([0..2_000_i32, 0..2_000_i32])) {
        let faces = [[4, 0, 1], [4, 1, 2], [4, 2, 3], [4, 3, 0], [5, 1, 0], [5, 2, 1], [5, 3, 2], [5, 0, 3]];
        let triangles = faces.map(|face| face.map(|i: usize| corners[i]));
        let viewport = Viewport { width: 8, height: 8 };
        prop_assert!(winding_numbers(&triangles, viewport).iter().all(|&winding| winding == 0));
    }

    /// The bounding box leaves out nothing.
    #[test]
    fn counting_in_the_box_is_counting_everywhere(triangle in any_triangle()) {
        let viewport = Viewport { width: 7, height: 5 };
        let everywhere: Vec<u32> = (0..35).map(|i| u32::from(covers(triangle, i % 7, i / 7))).collect();
        prop_assert_eq!(coverage_counts(&[triangle], viewport), everywhere);
    }
}

/// All triangles on a 5x5 lattice of half pixels: in any order of the corners the same pixels, and all 15 625 spans.
#[test]
fn all_small_lattice_triangles() {
    let corner = |code: i32| [code % 5 * 128, code / 5 * 128];
    let pixels = |triangle: Triangle| (-1..4).flat_map(move |y| (-1..4).map(move |x| covers(triangle, x, y)));
    for code in 0..25 * 25 * 25 {
        let triangle = [code % 25, code / 25 % 25, code / 625].map(corner);
        (-1..4).for_each(|y| check_row(triangle, y));
        let [a, b, c] = triangle;
        assert!(pixels(triangle).eq(pixels([b, c, a])) && pixels(triangle).eq(pixels([a, c, b])));
    }
}

#[test]
fn fronts_wind_forwards_and_a_convex_mesh_with_culling_is_hit_once() {
    // A square pyramid seen from above: four sides in front, two base triangles behind.
    let (base, tip) = ([[0, 0], [0, 1024], [1024, 1024], [1024, 0]], [384, 640]);
    let mut triangles: Vec<Triangle> = (0..4).map(|i| [base[i], base[(i + 1) % 4], tip]).collect();
    triangles.extend([[base[0], base[2], base[1]], [base[0], base[3], base[2]]]);
    let viewport = Viewport { width: 4, height: 4 };
    assert!(triangles[..4].iter().all(|&triangle| area2(triangle) < 0));
    assert_eq!(winding_numbers(&triangles[..4], viewport), [1; 16]);
    assert_eq!(winding_numbers(&triangles[4..], viewport), [-1; 16]);
    assert_eq!(coverage_counts(&triangles, viewport), [2; 16]);
    let seen: Vec<Triangle> = triangles.into_iter().filter(|&t| Cull::Back.keeps(facing(t))).collect();
    assert_eq!(coverage_counts(&seen, viewport), [1; 16]);
}

#[test]
fn the_box_ends_at_the_viewport() {
    let viewport = Viewport { width: 4, height: 3 };
    assert_eq!(pixel_box([[-500, 300], [300, 300], [0, 5_000]], viewport), (0..2, 1..3));
    assert!(pixel_box([[-500, 0], [-300, 0], [-1, 5_000]], viewport).0.is_empty());
}

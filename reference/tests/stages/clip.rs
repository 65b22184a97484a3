use crate::assert_near;
use proptest::prelude::*;
use reference::clip::{ClipVertex, FAR, NEAR, Plane, clip, guard};
use reference::transform::Viewport;

/// A triangle that carries the share of each of its corners.
fn triangle(positions: [[f64; 4]; 3]) -> [ClipVertex<3>; 3] {
    let shares = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    [0, 1, 2].map(|k| ClipVertex { position: positions[k], varyings: shares[k] })
}

fn blend(positions: [[f64; 4]; 3], shares: [f64; 3]) -> [f64; 4] {
    std::array::from_fn(|i| (0..3).map(|k| positions[k][i] * shares[k]).sum())
}

/// How far inside a convex polygon of shares a point is; negative outside.
fn inside(polygon: &[ClipVertex<3>], point: [f64; 3]) -> f64 {
    if polygon.is_empty() {
        return f64::NEG_INFINITY;
    }
    let side = |i: usize| {
        let (a, b) = (polygon[i].varyings, polygon[(i + 1) % polygon.len()].varyings);
        (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
    };
    (0..polygon.len()).map(side).fold(f64::INFINITY, f64::min)
}

fn position() -> impl Strategy<Value = [f64; 4]> {
    prop::array::uniform4(-4.0..4.0_f64)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5_000))]

    /// A point of the triangle is in the polygon exactly if it is on the inner side of all planes, and what is carried
    /// belongs to the place.
    #[test]
    fn the_polygon_is_what_the_planes_leave(
        corners in prop::array::uniform3(position()),
        points in prop::collection::vec(prop::array::uniform3(0.001..1.0_f64), 40),
        guarded: bool,
    ) {
        let more: &[Plane] = if guarded { &guard(Viewport { width: 10, height: 20 }, 5.0) } else { &[] };
        let polygon = clip(triangle(corners), more);
        for vertex in &polygon {
            assert_near(vertex.position, blend(corners, vertex.varyings), 1e-12);
        }
        for point in points {
            let sum: f64 = point.iter().sum();
            let shares = point.map(|share| share / sum);
            let place = blend(corners, shares);
            let distance = [NEAR, FAR]
                .iter()
                .chain(more)
                .map(|plane| plane.distance(place))
                .chain([place[3]])
                .fold(f64::INFINITY, f64::min);
            // On a border either answer is right; a polygon thinner than this is left out.
            let within = inside(&polygon, shares);
            if distance > 1e-6 {
                prop_assert!(within > -1e-9, "{shares:?} is missing from {polygon:?}");
            } else if distance < -1e-6 {
                prop_assert!(within < 1e-9, "{shares:?} is too much in {polygon:?}");
            }
        }
    }
}

#[test]
fn the_guard_rectangle_is_its_margin_larger_than_the_target() {
    // 10 pixels wide and 5 more on each side: x/w from -2 to 2. 20 rows: y/w from -1.5 to 1.5.
    let planes = guard(Viewport { width: 10, height: 20 }, 5.0);
    let distances = |x: f64, y: f64| planes.map(|plane| plane.distance([x, y, 0.0, 1.0]));
    assert_eq!(distances(2.0, 1.5), [4.0, 0.0, 3.0, 0.0]);
    assert_eq!(distances(-2.0, -1.5), [0.0, 4.0, 0.0, 3.0]);
}

#[test]
fn a_triangle_inside_is_untouched_and_one_outside_is_gone() {
    let whole = triangle([[0.0, 0.0, 0.0, 1.0], [9.0, 0.0, 2.0, 2.0], [0.0, -9.0, 0.5, 1.0]]);
    assert_eq!(clip(whole, &[]), whole);
    let before_near = triangle([[0.0, 0.0, -0.1, 1.0], [1.0, 0.0, -0.2, 1.0], [0.0, 1.0, 0.0, 1.0]]);
    assert_eq!(clip(before_near, &[]), []);
    let behind_far = triangle([[0.0, 0.0, 1.1, 1.0], [1.0, 0.0, 1.2, 1.0], [0.0, 1.0, 3.1, 3.0]]);
    assert_eq!(clip(behind_far, &[]), []);
    // No direction from the eye: z = w = 0 is neither before near nor behind far.
    let at_the_eye = triangle([[0.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.5, 1.0]]);
    assert!(clip(at_the_eye, &[]).iter().all(|vertex| vertex.position[3] > 0.0));
}

#[test]
fn both_triangles_of_an_edge_are_cut_at_the_same_bits() {
    let (inside, outside) = ([0.1, 0.7, 0.3, 1.1], [0.9, -0.3, -0.7, 0.2]);
    let other = [0.4, 0.4, 0.2, 0.9];
    let one = clip(triangle([inside, outside, other]), &[]);
    let two = clip(triangle([outside, inside, other]), &[]);
    let shared = |polygon: &[ClipVertex<3>]| {
        let on_edge = |vertex: &&ClipVertex<3>| vertex.varyings[2] == 0.0 && vertex.position != inside;
        polygon.iter().find(on_edge).unwrap().position.map(f64::to_bits)
    };
    assert_eq!(shared(&one), shared(&two));
}

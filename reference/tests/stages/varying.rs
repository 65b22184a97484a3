use proptest::prelude::*;
use reference::matrix::{cross, dot, sub};
use reference::raster::{covers, pixel_box};
use reference::setup::{Triangle, area2};
use reference::transform::{Viewport, perspective as camera};
use reference::varying::{Method, barycentrics, carry, linear, perspective};

const VIEWPORT: Viewport = Viewport { width: 64, height: 48 };

fn corner() -> impl Strategy<Value = [i32; 2]> {
    [-6_000..22_000_i32, -6_000..18_000_i32]
}

/// Any triangles, and needles whose third corner is a step or two beside an edge.
fn triangle() -> impl Strategy<Value = Triangle> {
    prop_oneof![
        [corner(), corner(), corner()],
        (corner(), corner(), 0..=256_i32, -2..=2_i32).prop_map(|(a, b, t, d)| {
            [a, b, [a[0] + (b[0] - a[0]) * t / 256 + d, a[1] + (b[1] - a[1]) * t / 256]]
        }),
    ]
}

fn covered(triangle: Triangle) -> impl Iterator<Item = (i64, i64)> {
    let (columns, rows) = pixel_box(triangle, VIEWPORT);
    rows.flat_map(move |y| columns.clone().map(move |x| (x, y))).filter(move |&(x, y)| covers(triangle, x, y))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    /// A plane over the screen with integer coefficients, known exactly everywhere: each covered pixel has its value.
    #[test]
    fn linear_is_the_plane(triangle in triangle(), plane in prop::array::uniform3(-1_000..1_000_i64)) {
        let at = |x: i64, y: i64| (plane[0] + plane[1] * x + plane[2] * y) as f64;
        let values = triangle.map(|[x, y]| at(i64::from(x), i64::from(y)));
        let largest = values.iter().fold(1.0, |most: f64, value| most.max(value.abs()));
        for (x, y) in covered(triangle) {
            let wanted = at(x * 256 + 128, y * 256 + 128);
            // Inside, no sum is larger than four times the largest value: a few roundings of that.
            let tolerance = 8.0 * f64::EPSILON * largest;
            let got = linear(triangle, values, x, y);
            prop_assert!((got - wanted).abs() <= tolerance, "{got} for {wanted}, {triangle:?} at {x}, {y}");
            let shares = barycentrics(triangle, x, y);
            let blended: f64 = (0..3).map(|k| shares[k] * values[k]).sum();
            prop_assert!((blended - wanted).abs() <= tolerance);
            prop_assert!(shares.iter().all(|&share| (0.0..=1.0).contains(&share)));
        }
    }

    /// The corners are put back into the view, and a ray through each pixel's centre meets their plane.
    #[test]
    fn perspective_is_what_a_ray_meets(
        triangle in triangle().prop_filter("an area of a pixel", |&t| area2(t).abs() > 65_536),
        w in prop::array::uniform3(0.5..32.0_f64),
        u in prop::array::uniform3(-256.0..256.0_f64),
    ) {
        let scales = camera(1.2, 64.0 / 48.0, 0.1, 100.0).0;
        // The direction, one unit along the line of sight, to a place on the screen in pixels.
        let direction = |x: f64, y: f64| [(x / 32.0 - 1.0) / scales[0][0], (1.0 - y / 24.0) / scales[1][1], -1.0];
        let corners = [0, 1, 2].map(|k| {
            let [x, y] = triangle[k].map(|value| f64::from(value) / 256.0);
            direction(x, y).map(|component| component * w[k])
        });
        let (b, c) = (sub(corners[1], corners[0]), sub(corners[2], corners[0]));
        for (x, y) in covered(triangle) {
            let ray = direction(x as f64 + 0.5, y as f64 + 0.5);
            // corners[0] + s b + t c = r ray, by Cramer's rule.
            let scale = dot(cross(b, c), ray);
            let from = corners[0].map(|component| -component);
            let (s, t) = (dot(cross(from, c), ray) / scale, dot(cross(b, from), ray) / scale);
            let wanted = u[0] + s * (u[1] - u[0]) + t * (u[2] - u[0]);
            let got = perspective(triangle, u, w.map(|w| 1.0 / w), x, y);
            prop_assert!((got - wanted).abs() < 1e-7, "{got} for {wanted}, {triangle:?} at {x}, {y}");
        }
    }
}

#[test]
fn a_constant_stays_what_it_is() {
    let triangle = [[100, 37], [5_001, 900], [-811, 7_777]];
    let q = [0.3, 0.7, 0.011];
    for (x, y) in covered(triangle) {
        assert_eq!(linear(triangle, [100.1; 3], x, y), 100.1);
        assert_eq!(perspective(triangle, [100.1; 3], q, x, y), 100.1);
    }
}

#[test]
fn a_worked_case() {
    // 8 pixels wide, a centre at 1.5 of 8: a share of 3/16 of the right corner. At w = 1 left and 4 right, the point
    // has 3/16 * 1/4 of 13/16 + 3/64.
    let triangle = [[0, 128], [2048, 128], [0, 2176]];
    let (values, q) = ([0.0, 1.0, 0.0], [1.0, 0.25, 1.0]);
    assert_eq!(barycentrics(triangle, 1, 0), [13.0 / 16.0, 3.0 / 16.0, 0.0]);
    assert_eq!(carry(Method::Affine, triangle, values, q, 1, 0), 3.0 / 16.0);
    assert_eq!(carry(Method::Perspective, triangle, values, q, 1, 0), 3.0 / 55.0);
}

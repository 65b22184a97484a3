use proptest::prelude::*;
use reference::setup::{Cull, Facing, area2, facing, fan, snap};

#[test]
fn snapping_rounds_to_nearest_with_ties_up() {
    let step = 1.0 / 256.0;
    let cases = [
        (0.0, 0),
        (10.5, 2688),
        (1.49 * step, 1),
        (1.5 * step, 2),
        (-1.5 * step, -1),
        (-1.51 * step, -2),
        (-0.5 * step, 0),
        // The largest number below half a step: half a step more would round up to a whole one.
        (0.499_999_999_999_999_94 * step, 0),
        (1e12, i32::MAX),
        (-1e300, i32::MIN),
    ];
    for (pixels, wanted) in cases {
        assert_eq!(snap(pixels), Some(wanted), "{pixels}");
    }
    assert_eq!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(snap), [None; 3]);
}

#[test]
fn counter_clockwise_as_seen_is_the_front() {
    // Top, bottom left, bottom right, with y down: counter-clockwise for who looks at the screen.
    let front = [[128, 0], [0, 256], [256, 256]];
    assert_eq!(area2(front), -65_536);
    assert_eq!(facing(front), Facing::Front);
    assert_eq!(facing([front[1], front[0], front[2]]), Facing::Back);
    assert_eq!(facing([[0, 0], [300, 100], [600, 200]]), Facing::Edge);
    let (least, most) = (i32::MIN, i32::MAX);
    assert_eq!(area2([[least, least], [most, least], [least, most]]), 0xFFFF_FFFF * 0xFFFF_FFFF);
    let kept = |cull: Cull| [Facing::Front, Facing::Back, Facing::Edge].map(|facing| cull.keeps(facing));
    assert_eq!(kept(Cull::Back), [true, false, false]);
    assert_eq!(kept(Cull::Front), [false, true, false]);
    assert_eq!(kept(Cull::None), [true, true, false]);
}

#[test]
fn a_fan_starts_at_the_least_corner() {
    assert_eq!(fan(&[[5, 9], [9, 2], [1, 2], [0, 8]]), [[2, 3, 0], [2, 0, 1]]);
    assert_eq!(fan(&[[1, 2], [1, 2], [0, 8]]), [[0, 1, 2]]);
    assert_eq!(fan(&[]), [[0; 3]; 0]);
    assert_eq!(fan(&[[0, 0], [1, 1]]), [[0; 3]; 0]);
}

proptest! {
    /// Shoelace's area of a polygon is the sum of its fan's, whatever its shape.
    #[test]
    fn a_fan_has_the_polygons_area(corners in prop::collection::vec(any::<[i32; 2]>(), 3..9)) {
        let sum: i128 = fan(&corners).iter().map(|t| area2(t.map(|i| corners[i]))).sum();
        let wide: Vec<[i128; 2]> = corners.iter().map(|corner| corner.map(i128::from)).collect();
        let shoelace: i128 = (0..wide.len())
            .map(|i| (wide[i], wide[(i + 1) % wide.len()]))
            .map(|(a, b)| a[0] * b[1] - b[0] * a[1])
            .sum();
        prop_assert_eq!(sum, shoelace);
    }
}

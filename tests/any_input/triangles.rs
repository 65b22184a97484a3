//! Single triangles of any points, on any target.

use proptest::prelude::*;
use topleft::{Coord, Point, point};

use crate::counting::targets;
use crate::flat::{compare, draw_all_ways};
use crate::support::check;
use crate::texture;

/// Any coordinate in steps, often near a target, near its guard rectangle, or at an end of the range.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        any::<i32>(),
        -2000..20_000_i32,
        -300_000..300_000_i32,
        prop::sample::select(vec![
            i32::MIN,
            i32::MIN + 1,
            -262_144,
            -1,
            0,
            128,
            262_144,
            i32::MAX - 1,
            i32::MAX
        ]),
    ]
}

/// Turned red by: no clipping at the guard rectangle, distances to it in 32 bits, 12 bits of t, a fan without its last
/// triangle, a run that is one too long.
#[test]
fn a_shaded_triangle_takes_any_point() {
    let points = prop::array::uniform3(prop::array::uniform2(coordinate()));
    let texels = prop::array::uniform3(prop::array::uniform2(any::<i32>()));
    check(3000, &(points, texels), |(points, texels)| {
        for mut target in targets() {
            compare(points, texels, &texture(), &mut target)?;
        }
        Ok(())
    });
}

/// Turned red by: a point that is not finite and drawn all the same.
#[test]
fn a_shaded_triangle_takes_any_float() {
    let bits = prop_oneof![
        any::<u32>(),
        (-50.0..90.0_f32).prop_map(f32::to_bits),
        prop::sample::select(vec![
            f32::NAN.to_bits(),
            f32::INFINITY.to_bits(),
            f32::NEG_INFINITY.to_bits(),
            f32::MAX.to_bits(),
            f32::MIN.to_bits(),
            1,
            0x8000_0000,
        ]),
    ];
    check(3000, &prop::array::uniform6(bits), |bits| {
        let [a, b, c, d, e, f] = bits.map(f32::from_bits);
        for mut target in targets() {
            let points = [point(a, b), point(c, d), point(e, f)];
            draw_all_ways(points, [[0, 1], [2, 3], [4, 5]], &texture(), &mut target);
            if [a, b, c, d, e, f].iter().any(|c| !c.is_finite()) && target.hits.iter().any(|&hits| hits != 0)
            {
                return Err("a corner that is nowhere was drawn".into());
            }
        }
        Ok(())
    });
}

/// A triangle with an area of nothing, and one that is nowhere near.
///
/// Turned red by: a run that is one too long, a fan without its last triangle, 12 bits of t.
#[test]
fn nothing_is_drawn_of_what_has_no_area_or_is_elsewhere() {
    let far = 1 << 24;
    for corners in [
        [[10, 10]; 3],
        [[0, 0], [2560, 2560], [5120, 5120]],
        [[i32::MIN, 7], [0, 7], [i32::MAX, 7]],
        [[far, far], [far + 900, far], [far, far + 900]],
        [[-900, -900], [-100, -900], [-900, -100]],
        [[i32::MIN, i32::MIN], [i32::MIN, -1], [-1, i32::MIN]],
    ] {
        for mut target in targets() {
            let points = corners.map(|[x, y]| Point::new(Coord::from_bits(x), Coord::from_bits(y)));
            draw_all_ways(points, [[0; 2]; 3], &texture(), &mut target);
            assert!(target.hits.iter().all(|&hits| hits == 0), "{corners:?}");
        }
    }
    // One that is larger than anything covers everything.
    let largest = [[i32::MIN, i32::MIN], [i32::MAX, i32::MIN], [0, i32::MAX]];
    for mut target in targets() {
        let points = largest.map(|[x, y]| Point::new(Coord::from_bits(x), Coord::from_bits(y)));
        draw_all_ways(points, [[i32::MIN, i32::MAX]; 3], &texture(), &mut target);
        assert!(target.hits.iter().all(|&hits| hits == 1));
    }
}

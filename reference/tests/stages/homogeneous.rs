use proptest::prelude::*;
use reference::clip::{ClipVertex, clip};
use reference::homogeneous::{Face, Sure};
use reference::raster::covers;
use reference::setup::{Facing, facing, fan, snap};
use reference::transform::Viewport;
use std::cell::Cell;

const VIEW: Viewport = Viewport { width: 48, height: 32 };
/// A step of a coordinate: all numbers below are exact in `f64`.
const STEP: f64 = 1.0 / (1_u64 << 28) as f64;

fn corners() -> impl Strategy<Value = [[i64; 4]; 3]> {
    // Seen from near by: w of all signs, and z often between the planes.
    let corner = ([-4_i64..4, -4_i64..4, -2_i64..4, -2_i64..4], prop::array::uniform4(0_i64..1 << 28));
    let corner = corner.prop_map(|(whole, part)| [0, 1, 2, 3].map(|k| (whole[k] << 28) + part[k]));
    prop::array::uniform3(corner)
}

/// What is sure agrees with the triangle cut in `f64` and rounded to 1/256 px, and hardly a pixel is not sure.
///
/// Red when a plane is left out, or one's sign is the other way; when a centre is not the middle of its pixel; when front
/// and back change places. And, by the last line, when nothing is sure.
#[test]
fn what_is_sure_is_so_when_the_face_is_cut() {
    let (sure, drawn) = (Cell::new(0_u64), [const { Cell::new(0_u64) }; 2]);
    let pixels = VIEW.width * VIEW.height;
    let config = ProptestConfig::with_cases(2_000);
    let mut runner = proptest::test_runner::TestRunner::new_with_rng(
        ProptestConfig { failure_persistence: None, ..config },
        proptest::test_runner::TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::ChaCha),
    );
    let result = runner.run(&corners(), |corners| {
        let exact = corners.map(|c| ClipVertex { position: c.map(|c| c as f64 * STEP), varyings: [] });
        // A corner of the cut triangle, which is off by some 2^-50, is off by less than a step from w = 2^-30 on.
        let polygon = clip(exact, &[]);
        prop_assume!(polygon.iter().all(|corner| corner.position[3] > 1e-9));
        let places = polygon.iter().map(|corner| VIEW.to_screen(corner.position));
        let places: Vec<_> = places.map(|place| place.map(|c| snap(c).expect("finite"))).collect();
        // Where rounding to 24 bits before the point holds a corner, the triangle is another one.
        prop_assume!(places.iter().flatten().all(|c| c.unsigned_abs() < 1 << 30));
        let parts: Vec<_> = fan(&places).into_iter().map(|part| part.map(|i| places[i])).collect();
        let face = Face::new(corners, 0).expect("31 bits");
        for (x, y) in (0..VIEW.height).flat_map(|y| (0..VIEW.width).map(move |x| (x, y))) {
            let side = |wanted| {
                let on = parts.iter().filter(|&&part| covers(part, x.into(), y.into()));
                on.filter(|&&part| facing(part) == wanted).count() as i64
            };
            let [front, back] = [side(Facing::Front), side(Facing::Back)];
            let right = match face.at(VIEW, [x, y], 1) {
                Some(Sure::Inside(Facing::Front)) => front - back == 1,
                Some(Sure::Inside(_)) => back - front == 1,
                Some(Sure::Outside) => front + back == 0,
                None => {
                    sure.set(sure.get() + 1);
                    true
                }
            };
            prop_assert!(right, "{front} fronts and {back} backs at {x}, {y}");
            drawn[0].set(drawn[0].get() + front.unsigned_abs());
            drawn[1].set(drawn[1].get() + back.unsigned_abs());
        }
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    let [front, back] = drawn.map(|count| count.get());
    println!("{front} px of fronts, {back} of backs, {} not sure", sure.get());
    assert!(front > 50_000 && back > 50_000);
    // Five lines of a row's and a column's length: of 80 centres beside each, one in 128 is within a step, 3 of 1536; the
    // errors of products, which are those of the worst corner, may add as much four times.
    assert!(sure.get() * 100 < u64::from(pixels) * 2_000);
}

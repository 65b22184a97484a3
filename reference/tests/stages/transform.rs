use crate::assert_near;
use reference::matrix::{Matrix, Vec4, rotation};
use reference::transform::{
    Pose, Viewport, depth, length, look_at, model_position, normal, orthographic, perspective,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};
use topleft::{Length, Mesh};

const EXACT: f64 = 1e-14;

#[test]
fn a_models_position_is_exact() {
    let positions = [[-32768, 32767, 1]];
    let (centre, half) = ([-1_966_081, 3, i32::MAX], 2_147_483_645);
    let mesh =
        Mesh::new(&positions, &[]).unwrap().with_box(centre.map(Length::from_bits), Length::from_bits(half));
    let got = model_position(&mesh, 0);
    for axis in 0..3 {
        // In steps of 2^-31 of the scene's unit everything is an integer.
        let wanted = i128::from(centre[axis]) * (1 << 15) + i128::from(positions[0][axis]) * i128::from(half);
        let steps = got[axis] * f64::from(1_u32 << 31);
        assert_eq!(steps as i128, wanted);
        assert_eq!(steps.fract(), 0.0);
    }
    assert_eq!(length(Length::from_bits(-98_304)), -1.5);
    assert_eq!(normal([127, -127, 0]), [1.0, -1.0, 0.0]);
}

#[test]
fn looking_puts_the_eye_at_the_origin_and_the_target_ahead() {
    let view = look_at([3.0, 4.0, 5.0], [1.0, 2.0, 4.0], [0.0, 1.0, 0.0]);
    assert_near(view.apply_point([3.0, 4.0, 5.0]), [0.0, 0.0, 0.0, 1.0], EXACT);
    assert_near(view.apply_point([1.0, 2.0, 4.0]), [0.0, 0.0, -3.0, 1.0], EXACT);
    // Up stays in the plane of y and z, and points up.
    let up = view.apply([0.0, 1.0, 0.0, 0.0]);
    assert_near([up[0], up[1] * up[1] + up[2] * up[2]], [0.0, 1.0], EXACT);
    assert!(up[1] > 0.0);
    // From +Z, the world is seen as it is written.
    let front = look_at([0.0, 0.0, 2.0], [0.0; 3], [0.0, 1.0, 0.0]);
    assert_near(front.apply([1.0, 2.0, 3.0, 0.0]), [1.0, 2.0, 3.0, 0.0], EXACT);
}

#[test]
#[should_panic(expected = "no direction")]
fn looking_along_up_is_refused() {
    look_at([0.0, 3.0, 0.0], [0.0; 3], [0.0, 1.0, 0.0]);
}

#[test]
fn perspective_maps_the_frustum_to_the_clip_volume() {
    let matrix = perspective(FRAC_PI_3, 1.5, 0.5, 20.0);
    let at = |x: f64, y: f64, distance: f64| matrix.apply_point([x, y, -distance]);
    for distance in [0.5_f64, 3.0, 20.0] {
        let top = distance * (FRAC_PI_3 / 2.0).tan();
        let corner = at(1.5 * top, top, distance);
        assert_near([corner[0], corner[1], corner[3]], [distance; 3], 1e-13);
    }
    assert_near([at(0.0, 0.0, 0.5)[2], at(0.0, 0.0, 20.0)[2]], [0.0, 20.0], EXACT);
    // z/w grows with the distance, as 1 / distance does: half way between 1/0.5 and 1/20.
    let middle = at(0.0, 0.0, 2.0 / (2.0 + 0.05));
    assert_near([middle[2] / middle[3]], [0.5], EXACT);
}

#[test]
fn orthographic_maps_the_box_to_the_clip_volume() {
    let matrix = orthographic(4.0, 2.0, 1.0, 9.0);
    assert_near(matrix.apply_point([4.0, 2.0, -1.0]), [1.0, 1.0, 0.0, 1.0], EXACT);
    assert_near(matrix.apply_point([-4.0, -2.0, -9.0]), [-1.0, -1.0, 1.0, 1.0], EXACT);
    assert_near(matrix.apply_point([0.0, 1.0, -5.0]), [0.0, 0.5, 0.5, 1.0], EXACT);
}

#[test]
fn a_pose_scales_turns_and_moves_in_this_order() {
    let pose =
        Pose { rotation: rotation([0.0, 2.0, 0.0], FRAC_PI_2), scale: 3.0, translation: [10.0, 20.0, 30.0] };
    // A quarter turn about +Y takes +Z to +X and +X to -Z.
    assert_near(pose.matrix().apply_point([0.0, 0.0, 1.0]), [13.0, 20.0, 30.0, 1.0], EXACT);
    assert_near(pose.matrix().apply_point([1.0, 1.0, 0.0]), [10.0, 23.0, 27.0, 1.0], EXACT);
    assert_near(pose.direction_to_model([1.0, 0.0, 0.0]), [0.0, 0.0, 1.0], EXACT);
    // About a skew axis: the axis stays, and the three rows stay orthonormal and right-handed.
    let turn = rotation([1.0, 2.0, -2.0], 0.7);
    let matrix = Pose { rotation: turn, ..Pose::IDENTITY }.matrix();
    assert_near(matrix.apply_point([1.0, 2.0, -2.0]), [1.0, 2.0, -2.0, 1.0], EXACT);
    assert_near(reference::matrix::cross(turn[0], turn[1]), turn[2], EXACT);
    // A third of a turn about the diagonal takes x to y.
    let third = rotation([1.0; 3], 2.0 * FRAC_PI_3);
    assert_near(third.map(|row| row[0]), [0.0, 1.0, 0.0], EXACT);
}

#[test]
fn matrices_are_applied_in_the_order_they_are_named() {
    let pose =
        Pose { rotation: rotation([1.0, 0.0, 0.0], 0.3), scale: 2.0, translation: [1.0, 2.0, 3.0] }.matrix();
    let camera = perspective(1.0, 1.25, 1.0, 10.0);
    let point: Vec4 = [0.3, -0.4, 0.5, 1.0];
    assert_near(pose.then(&camera).apply(point), camera.apply(pose.apply(point)), EXACT);
    assert_eq!(pose.then(&Matrix::IDENTITY), pose);
}

#[test]
fn the_screen_starts_top_left_and_depth_falls_with_distance() {
    let viewport = Viewport { width: 320, height: 200 };
    assert_eq!(viewport.to_screen([-2.0, 2.0, 1.0, 2.0]), [0.0, 0.0]);
    assert_eq!(viewport.to_screen([2.0, -2.0, 1.0, 2.0]), [320.0, 200.0]);
    assert_eq!(viewport.to_screen([1.0, 0.5, 1.0, 2.0]), [240.0, 75.0]);
    assert_eq!([0.0, 3.0, 1.5].map(|z| depth([0.0, 0.0, z, 3.0])), [65_532.0, 4.0, 32_768.0]);
}

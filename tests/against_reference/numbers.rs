//! Angles, matrices and cameras.

use embedded_graphics_core::geometry::Size;
use reference::matrix::{Matrix, dot};
use reference::transform::{length, look_at, orthographic, perspective};
use topleft::{
    Camera, DrawList, Flat, Length, ListTriangle, Material, Mesh, NoDepth, Orthographic, Perspective, Pose,
    Strip, Turn,
};

use crate::measured::{Errors, Row, hold};
use crate::probe::exact;
use crate::random::Random;
use crate::tolerance::{CAMERA, REACHED, SINE, half};

/// Every angle's sine and cosine.
pub(crate) fn sines() -> Row {
    let mut errors = Errors::default();
    let far = Length::from_num(32_767);
    for steps in 0..=u16::MAX {
        let turned = Pose::new().turned_z(Turn::new(steps)).apply([far, Length::ZERO, Length::ZERO]);
        let (sin, cos) = (f64::from(steps) / 65_536.0 * core::f64::consts::TAU).sin_cos();
        for (ours, exact) in [(turned[0], cos), (turned[1], sin)] {
            // What `apply` rounds: half a step of 2^-16 in 32767.
            errors.add(length(ours) / 32_767.0 - exact, SINE + half(31), || format!("{steps} steps"));
        }
        assert_eq!(turned[2], Length::ZERO);
    }
    Row::new("camera", "every angle of 16 bits", "sine and cosine", ["value", "1"], &errors).reaching(REACHED)
}

/// Turned red by: a table without interpolation.
#[test]
fn sines_are_within_the_tables_bound() {
    hold(&[sines()]);
}

/// Adds the errors of all elements of `ours` as shares of what each row adds up to, with what is allowed of it.
fn add_elements(
    errors: &mut Errors,
    ours: &Matrix,
    wanted: &Matrix,
    sums: [f64; 4],
    allowed: impl Fn(usize) -> f64,
    what: impl Fn() -> String,
) {
    for (row, column) in (0..16).map(|i| (i / 4, i % 4)) {
        let error = ours.0[row][column] - wanted.0[row][column];
        errors.add(error / sums[row], allowed(row) / sums[row], &what);
    }
}

/// Random cameras on and off the axes.
fn places(random: &mut Random) -> ([f32; 3], [f32; 3]) {
    let mut place = |size: f64| [(); 3].map(|()| ((random.unit() - 0.5) * size) as f32);
    loop {
        let (eye, target) = (place(20.0), place(6.0));
        let far = |axis: usize| (eye[axis] - target[axis]).abs() > 0.5;
        // From straight above, the cross product with "up" loses as many bits as the angle is small.
        if far(0) || far(2) {
            return (eye, target);
        }
    }
}

/// The elements of cameras' matrices.
pub(crate) fn matrices() -> Vec<Row> {
    const UP: [f64; 3] = [0.0, 1.0, 0.0];
    let mut random = Random::new(41);
    let [mut tapered, mut level] = [(); 2].map(|()| Errors::default());
    for _ in 0..20_000 {
        let (eye, target) = places(&mut random);
        let size = Size::new(random.within(1, 800) as u32, random.within(1, 600) as u32);
        let aspect = f64::from(size.width) / f64::from(size.height);
        let field = Turn::new(random.within(2000, 30_000) as u16);
        let near = (0.05 + random.unit()) as f32;
        let far = near * (1.5 + random.unit() * 100.0) as f32;
        let view = look_at(eye.map(f64::from), target.map(f64::from), UP);
        // One row of the view: a unit vector, and its product with the eye.
        let across = [eye[0] - target[0], eye[2] - target[2]].map(f64::from);
        let steep = eye.iter().zip(target).map(|(a, b)| f64::from(a - b).abs()).fold(0.0, f64::max)
            / across[0].hypot(across[1]);
        let of_view = (1.0 + dot(eye.map(f64::from).map(f64::abs), [1.0; 3])) * (1.0 + steep);

        let radians = f64::from(field.steps()) / 65_536.0 * core::f64::consts::TAU;
        // The library halves the field in whole steps.
        let radians = radians - f64::from(field.steps() % 2) / 65_536.0 * core::f64::consts::TAU;
        let lens = perspective(radians, aspect, f64::from(near), f64::from(far));
        let ours = exact(Perspective::new(size, field, near..far).look_at(eye, target).matrix());
        let wanted = view.then(&lens);
        let largest = wanted.0.iter().flatten().fold(0.0_f64, |most, e| most.max(e.abs()));
        let (sin, cos) = (radians / 2.0).sin_cos();
        let of_lens = [0, 1, 2, 3].map(|row| lens.0[row].iter().map(|e| e.abs()).sum::<f64>());
        let sine = |row: usize| if row < 2 { SINE * (1.0 / sin + 1.0 / cos) } else { 0.0 };
        // z = far / (far - near) has a difference of two floats in it.
        let depth = f64::from(far / (far - near)) + 1.0;
        let allowed = |row: usize| {
            (CAMERA * depth + sine(row)) * of_lens[row] * of_view
                + 4.0 * half(29) * largest.max(of_view * of_lens[1])
        };
        let what = || format!("from {eye:?} to {target:?}, {size:?}, {field:?}, {near}..{far}");
        let sums = of_lens.map(|sum| sum * of_view);
        add_elements(&mut tapered, &ours, &wanted, sums, allowed, what);

        let lens = orthographic(f64::from(far), aspect, f64::from(-near), f64::from(far));
        let ours = exact(Orthographic::new(size, far, -near..far).look_at(eye, target).matrix());
        let of_lens = [0, 1, 2, 3].map(|row| lens.0[row].iter().map(|e| e.abs()).sum::<f64>());
        let allowed = |row: usize| {
            CAMERA * of_lens[row] * of_view
                + 4.0 * half(29) * of_view * of_lens.into_iter().fold(0.0, f64::max)
        };
        let sums = of_lens.map(|sum| sum * of_view);
        add_elements(&mut level, &ours, &view.then(&lens), sums, allowed, what);
    }
    [("perspective", tapered), ("orthographic", level)]
        .map(|(method, errors)| {
            Row::new("camera", "random cameras", method, ["matrix element", "of its row"], &errors)
        })
        .into()
}

/// Turned red by: an inverse root with one Newton step, width over height.
#[test]
fn camera_matrices_are_those_of_the_reference() {
    hold(&matrices());
}

/// How far the axes of a camera are from a rotation's.
pub(crate) fn rotations() -> Row {
    let mut random = Random::new(42);
    let mut errors = Errors::default();
    for round in 0..50_000 {
        let (eye, target) = places(&mut random);
        // Near by and far away: no square overflows or vanishes.
        let scale = [1.0, 1e-18, 1e15][round % 3];
        // From where the target is, so that the place of the eye does not take the mantissas' bits.
        let eye = [0, 1, 2].map(|axis| (eye[axis] - target[axis]) * scale);
        let view = Orthographic::new(Size::new(2, 2), 2.0, 0.0..1.0).look_at(eye, [0.0; 3]);
        assert!(view.is_valid());
        if scale > 1.0 {
            continue;
        }
        let rows = exact(view.matrix()).0;
        let axis = |row: usize| [rows[row][0], rows[row][1], rows[row][2]];
        for (row, other) in [(0, 1), (1, 2), (2, 0)] {
            let (square, across) = (dot(axis(row), axis(row)), dot(axis(row), axis(other)));
            for error in [square - 1.0, across] {
                errors.add(error, 4.0 * CAMERA, || format!("row {row}, from {eye:?}"));
            }
        }
    }
    Row::new("camera", "random cameras", "look_at", ["from a rotation", "1"], &errors)
}

/// Turned red by: an inverse root with one Newton step.
#[test]
fn looking_at_something_is_a_rotation() {
    hold(&[rotations()]);
}

/// Turned red by: a near plane beyond the far one that is let through, a zero matrix that is shifted by -1.
#[test]
fn cameras_that_cannot_exist_draw_nothing() {
    let (nan, inf) = (f32::NAN, f32::INFINITY);
    let size = Size::new(8, 8);
    let field = Turn::from_degrees(60);
    let lens = |field, depth| Perspective::new(size, field, depth);
    let valid = lens(field, 0.1..10.0).look_at([0.0, 0.0, 3.0], [0.0; 3]);
    let flat = |height, depth| Orthographic::new(size, height, depth).look_at([0.0, 0.0, 3.0], [0.0; 3]);
    let depths = [1.0..1.0, 2.0..1.0, nan..1.0, 0.5..nan, 0.5..inf, -inf..1.0, nan..nan];
    let perspectives = depths
        .clone()
        .map(|depth| lens(field, depth))
        .into_iter()
        .chain([0.0..1.0, -1.0..1.0, inf..inf].map(|depth| lens(field, depth)))
        .chain([0, 1, 0x8000, 0xFFFF].map(|steps| lens(Turn::new(steps), 0.1..10.0)))
        .chain([
            valid.look_at([nan, 0.0, 0.0], [0.0; 3]),
            valid.look_at([0.0; 3], [0.0, inf, 0.0]),
            valid.look_at([1.0, 2.0, 3.0], [1.0, 2.0, 3.0]),
            valid.look_at([inf; 3], [inf; 3]),
        ]);
    for camera in perspectives {
        assert!(!camera.is_valid(), "{camera:?}");
        assert_eq!(drawn(&camera, 8), 0, "{camera:?}");
    }
    let orthographics = depths
        .map(|depth| flat(4.0, depth))
        .into_iter()
        .chain([0.0, -1.0, nan].map(|height| flat(height, 0.0..9.0)));
    for camera in orthographics {
        assert!(!camera.is_valid(), "{camera:?}");
        assert_eq!(drawn(&camera, 8), 0, "{camera:?}");
    }
    assert!(valid.is_valid() && drawn(&valid, 8) > 0 && drawn(&flat(4.0, 0.0..9.0), 8) > 0);
    // An empty target shows nothing, and is drawn to without harm.
    for size in [Size::zero(), Size::new(0, 9), Size::new(9, 0)] {
        let camera = Perspective::new(size, field, 0.1..10.0).look_at([0.0, 0.0, 3.0], [0.0; 3]);
        assert_eq!(drawn(&camera, 8), 0, "{size:?}");
    }
}

/// Pixels that a large triangle at the origin gets on a strip of `width` squared.
fn drawn<C: Camera>(camera: &C, width: u16) -> usize {
    let positions = [[-30_000, -30_000, 0], [30_000, -30_000, 0], [0, 30_000, 0]];
    let mesh = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 1]]).unwrap();
    let mut storage = ([0; 100], [ListTriangle::EMPTY; 20]);
    let mut list = DrawList::<u16, NoDepth>::new(&mut storage.0, &mut storage.1);
    list.draw(camera, &mesh, &Pose::new(), &Flat::new(Material::Colour([255; 3]))).unwrap();
    let mut cells = vec![0_u16; usize::from(width).pow(2)];
    let mut strip = Strip::new(width, &mut cells).unwrap();
    list.render(0..width.into(), &mut strip);
    cells.iter().filter(|&&cell| cell != 0).count()
}

/// What the cameras compute is pinned to the bit: on another chip, or in a host build where a feature elsewhere has
/// turned `std` on in a dependency, these must be the same.
///
/// Turned red by: any change to the float work of a camera, however small.
#[test]
fn the_bits_of_three_cameras_are_pinned() {
    let size = Size::new(240, 240);
    let near = Perspective::new(size, Turn::from_degrees(50), 0.1..20.0).look_at([0.0, 2.0, 5.0], [0.0; 3]);
    let odd = Perspective::new(Size::new(320, 170), Turn::new(9001), 0.37..91.3)
        .look_at([-3.7, 11.3, 0.019], [0.2, -1.1, 0.7]);
    let level =
        Orthographic::new(Size::new(128, 160), 3.3, -1.7..8.9).look_at([3.0, 3.1, -2.9], [0.1, 0.2, 0.3]);
    for (matrix, exponent, rows) in [
        (
            near.matrix(),
            27,
            [
                [287_838_319, 0, 0, 0],
                [0, 267_251_186, -106_900_473, 0],
                [0, -50_097_706, -125_244_264, 712_927_521],
                [0, -49_847_216, -124_618_040, 722_784_640],
            ],
        ),
        (
            odd.matrix(),
            26,
            [
                [-13_321_092, 0, 76_288_202, -50_737_518],
                [136_798_139, 44_337_086, 23_887_056, 4_690_203],
                [20_188_691, -64_189_683, 3_525_255, 775_043_333],
                [20_106_874, -63_929_548, 3_510_969, 796_732_672],
            ],
        ),
        (
            level.matrix(),
            29,
            [
                [-301_374_494, 0, -273_120_628, 112_073_696],
                [-121_808_789, 270_122_946, 134_409_701, -82_166_655],
                [-28_235_671, -28_235_671, 31_156_604, 348_693_706],
                [0, 0, 0, 536_870_912],
            ],
        ),
    ] {
        assert_eq!([0, 1, 2, 3].map(|row| matrix.row(row)), rows);
        assert_eq!(matrix.exponent(), exponent);
    }
}

//! Newell's teapot.
//!
//! Martin Newell published the teapot in 1975 as Bézier patches, and the bottom was added later. The patches of the
//! pot, the lid and the bottom are turned profiles, and those of handle and spout are mirrored rows, so their numbers
//! are kept in that shorter form, in Newell's unit and axes, z up.
//!
//! Three flat pieces are added so that the surface is closed: a seat between the lid and the rim, the ends of the
//! handle and of the spout inside the pot, and the spout's hole. The pot, the handle and the spout still cross each
//! other, as they always did.

use super::surface::{Point, bezier, cap, corner, pack, sheet};
use crate::model::Welder;
use crate::quantise::Packed;

/// A point of a turned profile: radius, the inner control points' distance from the axes, and height.
type Turned = [f64; 3];

/// The profile from the knob down to the middle of the bottom, and the rows that each part gets.
const PROFILE: [(usize, [Turned; 4]); 6] = [
    (4, [[0.0, 0.0, 3.15], [0.8, 0.45, 3.15], [0.0, 0.0, 2.85], [0.2, 0.112, 2.7]]),
    (3, [[0.2, 0.112, 2.7], [0.4, 0.224, 2.55], [1.3, 0.728, 2.55], [1.3, 0.728, 2.4]]),
    (3, [[1.4, 0.784, 2.4], [1.3375, 0.749, 2.53125], [1.4375, 0.805, 2.53125], [1.5, 0.84, 2.4]]),
    (4, [[1.5, 0.84, 2.4], [1.75, 0.98, 1.875], [2.0, 1.12, 1.35], [2.0, 1.12, 0.9]]),
    (4, [[2.0, 1.12, 0.9], [2.0, 1.12, 0.45], [1.5, 0.84, 0.225], [1.5, 0.84, 0.15]]),
    (3, [[1.5, 0.84, 0.15], [1.5, 0.84, 0.075], [1.425, 0.798, 0.0], [0.0, 0.0, 0.0]]),
];

/// The flat seat between the lid's edge and the rim.
const SEAT: [Turned; 2] = [[1.3, 0.728, 2.4], [1.4, 0.784, 2.4]];

/// A row of a tube: x and z of its inner side, x and z of its outer side, and half its width.
type Ring = [f64; 5];

/// The handle, from the pot's upper end to its lower end.
const HANDLE: [[Ring; 4]; 2] = [
    [
        [-1.6, 2.025, -1.5, 2.25, 0.3],
        [-2.3, 2.025, -2.5, 2.25, 0.3],
        [-2.7, 2.025, -3.0, 2.25, 0.3],
        [-2.7, 1.8, -3.0, 1.8, 0.3],
    ],
    [
        [-2.7, 1.8, -3.0, 1.8, 0.3],
        [-2.7, 1.575, -3.0, 1.35, 0.3],
        [-2.5, 1.125, -2.65, 0.9375, 0.3],
        [-2.0, 0.9, -1.9, 0.6, 0.3],
    ],
];

/// The spout, from the pot to its lip and over it.
const SPOUT: [[Ring; 4]; 2] = [
    [
        [1.7, 1.425, 1.7, 0.6, 0.66],
        [2.6, 1.425, 3.1, 0.825, 0.66],
        [2.3, 2.1, 2.4, 2.025, 0.25],
        [2.7, 2.4, 3.3, 2.4, 0.25],
    ],
    [
        [2.7, 2.4, 3.3, 2.4, 0.25],
        [2.8, 2.475, 3.525, 2.49375, 0.25],
        [2.9, 2.475, 3.45, 2.5125, 0.15],
        [2.8, 2.4, 3.2, 2.4, 0.15],
    ],
];

/// Columns of a quarter turn of the pot, and of half a tube.
const QUARTER: usize = 5;
const HALF_TUBE: usize = 4;

/// Repeats of a texture to Newell's unit: four round the pot.
const REPEATS: f64 = 0.32;

/// The whole teapot at a third of Newell's unit, its middle height at y = 0.
pub(super) fn make() -> Packed {
    let mut welder = Welder::default();
    pot(&mut welder);
    tube(&mut welder, HANDLE, [6, 5]);
    tube(&mut welder, SPOUT, [6, 4]);
    pack(welder, |mut model| {
        for [_, y, _] in &mut model.positions {
            *y -= 3.15 / 2.0;
        }
        model.scale(1.0 / 3.0)
    })
}

fn pot(welder: &mut Welder) {
    let columns = 4 * QUARTER;
    let mut length = 0.0;
    for (part, (rows, points)) in PROFILE.into_iter().enumerate() {
        if part == 2 {
            length =
                turn(welder, columns, &[(SEAT[0], [0.1, 0.056, 0.0]), (SEAT[1], [0.1, 0.056, 0.0])], length);
        }
        let rows: Vec<_> = (0..=rows).map(|row| bezier(points, row as f64 / rows as f64)).collect();
        length = turn(welder, columns, &rows, length);
    }
}

/// Turns a row of profile points, each with its direction, round the axis. Takes and gives the profile's length so far.
fn turn(welder: &mut Welder, columns: usize, rows: &[(Turned, Turned)], start: f64) -> f64 {
    let mut lengths = vec![start];
    for pair in rows.windows(2) {
        let [(a, _), (b, _)] = [pair[0], pair[1]];
        lengths.push(lengths[lengths.len() - 1] + (a[0] - b[0]).hypot(a[2] - b[2]));
    }
    sheet(welder, rows.len() - 1, columns, |row, column| {
        let (place, slope) = rows[row];
        let ([x, z], right) = around(place, column % columns);
        let ([slope_x, slope_z], _) = around(slope, column % columns);
        let point = Point {
            position: [x, place[2], z],
            right: [right[0], 0.0, right[1]],
            down: [slope_x, slope[2], slope_z],
            uv: [column as f64 / columns as f64 * 4.0, lengths[row] * REPEATS],
        };
        point.corner([0.0, if place[2] > 1.0 { 1.0 } else { -1.0 }, 0.0])
    });
    lengths[lengths.len() - 1]
}

/// Newell's circle of four curves at a column, as x and z, and its direction: from +z to the right as seen from
/// outside.
fn around([radius, inner, _]: Turned, column: usize) -> ([f64; 2], [f64; 2]) {
    let quarter = [[0.0, radius], [inner, radius], [radius, inner], [radius, 0.0]];
    let (mut point, mut right) = bezier(quarter, (column % QUARTER) as f64 / QUARTER as f64);
    for _ in 0..column / QUARTER {
        (point, right) = ([point[1], -point[0]], [right[1], -right[0]]);
    }
    (point, right)
}

fn tube(welder: &mut Welder, patches: [[Ring; 4]; 2], rows: [usize; 2]) {
    let columns = 2 * HALF_TUBE;
    let mut length = 0.0;
    for (patch, rows) in patches.into_iter().zip(rows) {
        let rings: Vec<_> = (0..=rows).map(|row| bezier(patch, row as f64 / rows as f64)).collect();
        let mut lengths = vec![length];
        for pair in rings.windows(2) {
            let [(a, _), (b, _)] = [pair[0], pair[1]];
            length += ((a[0] + a[2] - b[0] - b[2]) / 2.0).hypot((a[1] + a[3] - b[1] - b[3]) / 2.0);
            lengths.push(length);
        }
        sheet(welder, rows, columns, |row, column| {
            let (ring, slope) = rings[row];
            let (position, right) = across(ring, column % columns);
            let (down, _) = across(slope, column % columns);
            let uv = [column as f64 / columns as f64 * 0.5, lengths[row] * REPEATS];
            Point { position, right, down, uv }.corner([0.0; 3])
        });
    }
    let ring =
        |ring: Ring| (0..columns).map(move |column| corner(across(ring, column).0, [0.0; 3], None).position);
    cap(welder, &ring(patches[0][0]).collect::<Vec<_>>(), REPEATS);
    cap(welder, &ring(patches[1][3]).rev().collect::<Vec<_>>(), REPEATS);
}

/// A column of a ring, y up, and the direction to the right as seen from outside: from the inner side by -z to the
/// outer side, and back by +z.
fn across([inner_x, inner_y, outer_x, outer_y, width]: Ring, column: usize) -> ([f64; 3], [f64; 3]) {
    let (inner, outer) = ([inner_x, inner_y, 0.0], [outer_x, outer_y, 0.0]);
    let beside = |[x, y, _]: [f64; 3], z| [x, y, z];
    let half = if column < HALF_TUBE {
        [inner, beside(inner, -width), beside(outer, -width), outer]
    } else {
        [outer, beside(outer, width), beside(inner, width), inner]
    };
    bezier(half, (column % HALF_TUBE) as f64 / HALF_TUBE as f64)
}

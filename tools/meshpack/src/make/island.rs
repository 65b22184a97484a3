//! An island on a round board: its land, the sea round it, and a watchtower.

use super::surface::{Point, corner, pack, sheet};
use crate::model::{Corner, Welder};
use crate::quantise::Packed;
use std::f64::consts::TAU;

/// Rings of the land round its middle: the nth has 6n points.
const RINGS: usize = 13;
/// Radii of the land, most of whose outermost ring lies under the sea, and of the sea, which is of 1.
const LAND: f64 = 0.9;
const INNER_SEA: f64 = 0.4;
/// Segments of the sea round the board, and rings of it.
const SEGMENTS: usize = 36;
const SEA_RINGS: usize = 3;
/// Repeats of a texture to the unit, on the sea.
const WAVES: f64 = 4.0;
/// Depth of the board below the sea.
const BOARD: f64 = 0.07;
/// Where the watchtower stands.
const TOWER: [f64; 2] = [0.24, 0.3];
/// The watchtower's sides, and its outline: heights above its foot, radii, and the texture's rows.
const SIDES: usize = 10;
const OUTLINE: [[f64; 3]; 5] =
    [[0.44, 0.0, -0.25], [0.33, 0.1, 0.25], [0.32, 0.075, 0.25], [0.2, 0.065, 1.0], [-0.06, 0.085, 2.5]];

/// Hills: where they are, how wide and how high.
const HILLS: [([f64; 2], f64, f64); 7] = [
    ([-0.22, -0.12], 0.5, 0.44),
    ([0.1, -0.3], 0.36, 0.24),
    ([-0.35, 0.3], 0.42, 0.16),
    ([0.35, -0.05], 0.5, 0.13),
    ([0.22, 0.28], 0.34, 0.14),
    ([-0.05, 0.55], 0.36, 0.06),
    ([-0.6, -0.3], 0.34, 0.07),
];

/// The land: rings of small triangles, each vertex in the colour of its height.
pub(super) fn land() -> Packed {
    let mut welder = Welder::default();
    for ring in 0..RINGS {
        for sector in 0..6 {
            let inner = |along: usize| ground(ring, sector * ring + along);
            let outer = |along: usize| ground(ring + 1, sector * (ring + 1) + along);
            for along in 0..=ring {
                welder.face([inner(along), outer(along), outer(along + 1)], None);
                if along < ring {
                    welder.face([inner(along), outer(along + 1), inner(along + 1)], None);
                }
            }
        }
    }
    pack(welder, |model| model)
}

/// The nth point of a ring, counter-clockwise as seen from above, moved a little from its place.
fn ground(ring: usize, place: usize) -> Corner {
    let points = (6 * ring).max(1);
    let place = place % points;
    let moved = |salt: usize| noise(ring * 97 + place, salt) * 0.22 / RINGS as f64;
    let angle = -TAU * place as f64 / points as f64;
    let radius = ring as f64 / RINGS as f64;
    let [x, z] = if ring == RINGS {
        [angle.cos(), angle.sin()]
    } else {
        [radius * angle.cos() + moved(1), radius * angle.sin() + moved(2)]
    };
    let [x, z] = [x * LAND, z * LAND];
    let rough = if ring == RINGS { 0.0 } else { noise(ring * 97 + place, 3) };
    let height = height([x, z]) * (1.0 + rough * 0.16) + rough * 0.008;
    Corner { normal: None, colour: Some(colour(height, rough)), ..corner([x, height, z], [0.0; 3], None) }
}

/// The land above the sea, before it is roughened: hills on a shelf that slopes down to all sides.
fn height([x, z]: [f64; 2]) -> f64 {
    let square = x * x + z * z;
    let hills: f64 = HILLS
        .iter()
        .map(|([at_x, at_z], width, height)| {
            let square = ((x - at_x).powi(2) + (z - at_z).powi(2)) / (width * width);
            height * (1.0 - square).max(0.0).powi(2)
        })
        .sum();
    hills + 0.035 - 0.1 * square
}

/// Sand, grass, woods, rock and snow.
fn colour(height: f64, rough: f64) -> [u8; 3] {
    const STEPS: [(f64, [f64; 3]); 6] = [
        (-0.02, [206.0, 196.0, 150.0]),
        (0.025, [236.0, 216.0, 150.0]),
        (0.055, [120.0, 180.0, 70.0]),
        (0.18, [52.0, 120.0, 56.0]),
        (0.3, [136.0, 124.0, 112.0]),
        (0.4, [250.0, 250.0, 255.0]),
    ];
    let height = height + rough * 0.012;
    let next = STEPS.iter().position(|(top, _)| height < *top).unwrap_or(STEPS.len() - 1).max(1);
    let ((low, from), (high, to)) = (STEPS[next - 1], STEPS[next]);
    let share = ((height - low) / (high - low)).clamp(0.0, 1.0);
    std::array::from_fn(|channel| (from[channel] + (to[channel] - from[channel]) * share).round() as u8)
}

/// A number from -1 to 1 without a pattern that the eye would find.
fn noise(place: usize, salt: usize) -> f64 {
    let mixed = (place as u32).wrapping_mul(0x9E37_79B1) ^ (salt as u32).wrapping_mul(0x85EB_CA77);
    let value = (mixed ^ mixed >> 15).wrapping_mul(0x2C1B_3C6D);
    f64::from(value >> 16) / 32_768.0 - 1.0
}

/// The sea: a level ring, whose hole the land covers, and the board's edge below it.
pub(super) fn sea() -> Packed {
    let mut welder = Welder::default();
    // Rows go outwards and columns clockwise, which is to the right as seen from the middle.
    let around = |segment: usize| {
        let angle = -TAU * (segment % SEGMENTS) as f64 / SEGMENTS as f64;
        [angle.cos(), angle.sin()]
    };
    sheet(&mut welder, SEA_RINGS, SEGMENTS, |ring, segment| {
        let radius = INNER_SEA + (1.0 - INNER_SEA) * ring as f64 / SEA_RINGS as f64;
        let [x, z] = around(segment).map(|c| c * radius);
        corner([x, 0.0, z], [0.0, 1.0, 0.0], Some([x * WAVES, z * WAVES]))
    });
    sheet(&mut welder, 1, SEGMENTS, |row, segment| {
        let [x, z] = around(segment);
        let down = row as f64 * BOARD;
        let u = segment as f64 / SEGMENTS as f64 * TAU * WAVES;
        corner([x, -down, z], [x, 0.0, z], Some([(u * 64.0).round() / 64.0, down * WAVES]))
    });
    pack(welder, |model| model)
}

/// The watchtower, on a hill of the land: a slim tower under a pointed roof.
pub(super) fn tower() -> Packed {
    let mut welder = Welder::default();
    let foot = height(TOWER);
    sheet(&mut welder, OUTLINE.len() - 1, SIDES, |row, side| {
        let angle = -TAU * (side % SIDES) as f64 / SIDES as f64;
        let [height, radius, v] = OUTLINE[row];
        let (sin, cos) = angle.sin_cos();
        let point = Point {
            position: [TOWER[0] + radius * cos, foot + height, TOWER[1] + radius * sin],
            right: [sin, 0.0, -cos],
            down: [0.0, -1.0, 0.0],
            uv: [side as f64 / SIDES as f64 * 2.0, v],
        };
        point.corner([0.0, 1.0, 0.0])
    });
    pack(welder, |model| model)
}

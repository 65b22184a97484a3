//! The land: rings of small triangles that follow the coast, vertices and faces in the colours of their height.

use std::f64::consts::TAU;

use super::super::surface::{corner, pack};
use super::{blend, noise};
use crate::model::{Corner, Welder};
use crate::quantise::Packed;

/// Rings of the land round its middle: the nth has 6n points.
const RINGS: usize = 12;
/// The outermost ring, of which the sea hides all, in parts of the way to the coast.
const BEYOND: f64 = 1.03;

/// Hills: where they are, how wide and how high.
const HILLS: [([f64; 2], f64, f64); 6] = [
    ([-0.18, -0.13], 0.45, 0.37),
    ([0.12, -0.29], 0.34, 0.17),
    ([-0.38, 0.16], 0.30, 0.11),
    // Under the lighthouse.
    ([0.40, 0.22], 0.24, 0.11),
    ([0.05, 0.42], 0.30, 0.05),
    ([0.42, -0.20], 0.24, 0.07),
];

/// How far the coast is from the middle, in a direction.
pub(super) fn coast(angle: f64) -> f64 {
    0.66 + 0.055 * (3.0 * angle + 0.6).sin() + 0.035 * (5.0 * angle + 2.0).sin()
}

/// The land above the sea, before it is roughened: hills on a shelf that ends at the coast.
pub(super) fn height([x, z]: [f64; 2]) -> f64 {
    let hills: f64 = HILLS
        .iter()
        .map(|([at_x, at_z], width, height)| {
            let square = ((x - at_x).powi(2) + (z - at_z).powi(2)) / (width * width);
            height * (1.0 - square).max(0.0).powi(2)
        })
        .sum();
    let way = x.hypot(z) / coast(z.atan2(x));
    hills + 0.07 * (1.0 - way * way)
}

pub(in super::super) fn make() -> Packed {
    let mut welder = Welder::default();
    for ring in 0..RINGS {
        for sector in 0..6 {
            let inner = |along: usize| ground(ring, sector * ring + along);
            let outer = |along: usize| ground(ring + 1, sector * (ring + 1) + along);
            for along in 0..=ring {
                face(&mut welder, [inner(along), outer(along), outer(along + 1)]);
                if along < ring {
                    face(&mut welder, [inner(along), outer(along + 1), inner(along + 1)]);
                }
            }
        }
    }
    pack(welder, |model| model)
}

/// A face in the colour of its middle.
fn face(welder: &mut Welder, corners: [Corner; 3]) {
    let height = corners.iter().map(|corner| corner.position[1]).sum::<f64>() / 3.0;
    welder.face(corners, Some(colour(height, 0.0)));
}

/// The nth point of a ring, counter-clockwise as seen from above, moved a little from its place.
fn ground(ring: usize, place: usize) -> Corner {
    let points = (6 * ring).max(1);
    let place = place % points;
    let id = ring * 97 + place;
    let inside = ring < RINGS;
    let moved = |salt: usize| if inside { noise(id, salt) } else { 0.0 };
    let angle = -TAU * (place as f64 + moved(1) * 0.2) / points as f64;
    let way = (ring as f64 + moved(2) * 0.2) / RINGS as f64 * BEYOND;
    let radius = way * coast(angle);
    let [x, z] = [radius * angle.cos(), radius * angle.sin()];
    let rough = moved(3);
    // Above the shelf only: the coast stays where the sea is told that it is.
    let height = height([x, z]) * (1.0 + rough * 0.1);
    Corner { normal: None, colour: Some(colour(height, rough)), ..corner([x, height, z], [0.0; 3], None) }
}

/// Sand, grass, woods, rock and snow.
fn colour(height: f64, rough: f64) -> [u8; 3] {
    const STEPS: [(f64, [u8; 3]); 7] = [
        (-0.02, [214, 190, 140]),
        (0.018, [250, 226, 160]),
        (0.04, [140, 196, 84]),
        (0.14, [74, 148, 66]),
        (0.22, [130, 118, 104]),
        (0.30, [150, 142, 136]),
        (0.34, [250, 250, 255]),
    ];
    blend(&STEPS, height + rough * 0.012)
}

//! What stands on the land, and the edge of the board: one colour a face.

use std::f64::consts::TAU;

use super::super::surface::pack;
use super::land::{coast, height};
use super::sea::SEGMENTS;
use super::{face, noise, quad};
use crate::model::Welder;
use crate::quantise::Packed;

/// Trees, and the sides of each.
const TREES: usize = 22;
const SIDES: usize = 4;
/// Where houses stand, and how they are turned.
const HOUSES: [([f64; 2], f64); 5] = [
    ([0.10, 0.34], 0.3),
    ([-0.04, 0.42], 1.4),
    ([0.20, 0.48], 2.2),
    ([0.22, 0.20], 0.9),
    ([-0.16, 0.36], 2.8),
];
/// Depth of the board below the sea.
const BOARD: f64 = 0.09;

pub(in super::super) fn make() -> Packed {
    let mut welder = Welder::default();
    for (number, (at, turn)) in HOUSES.into_iter().enumerate() {
        house(&mut welder, at, turn, number);
    }
    let mut planted = 0;
    for number in 0.. {
        if planted == TREES {
            break;
        }
        let angle = noise(number, 11) * TAU / 2.0;
        let radius = coast(angle) * 0.85 * ((noise(number, 12) + 1.0) / 2.0).sqrt();
        let at = [radius * angle.cos(), radius * angle.sin()];
        if grows(at) {
            tree(&mut welder, at, 1.0 + noise(number, 13) * 0.25, number);
            planted += 1;
        }
    }
    edge(&mut welder);
    pack(welder, |model| model)
}

/// Trees grow on grass, and leave room for houses and the lighthouse.
fn grows(at: [f64; 2]) -> bool {
    let free = |other: [f64; 2], room: f64| (at[0] - other[0]).hypot(at[1] - other[1]) > room;
    let buildings = HOUSES.iter().all(|(place, _)| free(*place, 0.11)) && free([0.40, 0.22], 0.14);
    (0.03..0.2).contains(&height(at)) && buildings
}

/// A pyramid, as slim as a fir; the ground hides its foot.
fn tree(welder: &mut Welder, [x, z]: [f64; 2], size: f64, number: usize) {
    const HIGH: f64 = 0.15;
    const RADIUS: f64 = 0.045;
    let foot = height([x, z]) - 0.01;
    let green = [[46, 110, 62], [58, 128, 58], [38, 96, 66]][number % 3];
    let rim = |side: usize| {
        let angle = TAU * ((side % SIDES) as f64 + number as f64 * 0.3) / SIDES as f64;
        [x + RADIUS * size * angle.cos(), foot, z + RADIUS * size * angle.sin()]
    };
    for side in 0..SIDES {
        face(welder, [[x, foot + HIGH * size, z], rim(side + 1), rim(side)], green);
    }
}

/// Four walls, two of them with a gable, under a roof.
fn house(welder: &mut Welder, at: [f64; 2], turn: f64, number: usize) {
    // From the middle to a gable and to a long wall; up to the eaves and to the ridge.
    const LONG: f64 = 0.062;
    const WIDE: f64 = 0.045;
    const WALL: f64 = 0.075;
    const RIDGE: f64 = 0.125;
    let wall = [[244, 232, 208], [236, 214, 190], [226, 230, 236]][number % 3];
    let roof = [[198, 84, 58], [176, 70, 62], [90, 96, 130]][number % 3];
    let foot = height(at);
    let (sin, cos) = turn.sin_cos();
    // Along the ridge, across it, and up.
    let place = |along: f64, across: f64, up: f64| {
        [at[0] + along * cos - across * sin, foot + up, at[1] + along * sin + across * cos]
    };
    for end in [1.0, -1.0] {
        // Counter-clockwise as seen from outside, at both ends and on both sides.
        let (l, w) = (LONG * end, WIDE * end);
        let low = -0.05;
        quad(welder, [place(l, w, WALL), place(l, w, low), place(l, -w, low), place(l, -w, WALL)], wall);
        face(welder, [place(l, 0.0, RIDGE), place(l, w, WALL), place(l, -w, WALL)], wall);
        quad(welder, [place(-l, w, WALL), place(-l, w, low), place(l, w, low), place(l, w, WALL)], wall);
        quad(
            welder,
            [place(-l, 0.0, RIDGE), place(-l, w, WALL), place(l, w, WALL), place(l, 0.0, RIDGE)],
            roof,
        );
    }
}

/// The board's edge, from the sea down.
fn edge(welder: &mut Welder) {
    let point = |segment: usize, down: f64| {
        let angle = TAU * (segment % SEGMENTS) as f64 / SEGMENTS as f64;
        [angle.cos(), -down, angle.sin()]
    };
    for segment in 0..SEGMENTS {
        let corners = [(segment + 1, 0.0), (segment + 1, BOARD), (segment, BOARD), (segment, 0.0)];
        quad(welder, corners.map(|(segment, down)| point(segment, down)), [44, 92, 148]);
    }
}

//! The mesh that all draw: 512 triangles that cover 240x240 pixels exactly once, already on the screen.

use std::ops::Range;

/// Pixels in a row, and rows.
pub(crate) const SIZE: usize = 240;

/// `v x y` lines in 1/16 px with y down, and `t a b c` lines.
const TEXT: &str = include_str!("../../../scenes/grid240.txt");

/// A corner on the screen: pixels, and a depth from 0 at the eye to 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    pub(crate) x: f32,
    pub(crate) y: f32,
    pub(crate) z: f32,
}

/// A triangle and its colour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Face {
    pub(crate) corners: [Corner; 3],
    /// RGB565, and another one for each face: never 0.
    pub(crate) colour: u16,
}

/// Its faces.
pub(crate) fn faces() -> Vec<Face> {
    let numbers = |keyword: &'static str| {
        TEXT.lines().filter_map(move |line| line.strip_prefix(keyword)).map(|rest| {
            rest.split_whitespace().map(|word| word.parse().expect("a number")).collect::<Vec<usize>>()
        })
    };
    let corners: Vec<Corner> = numbers("v ")
        .map(|at| {
            let [x, y] = [at[0], at[1]].map(|c| c as f32 / 16.0);
            // A plane that slants both ways, as nothing is drawn level.
            Corner { x, y, z: 0.5 + (x - 120.0) / 960.0 - (y - 120.0) / 480.0 }
        })
        .collect();
    numbers("t ")
        .enumerate()
        .map(|(face, at)| Face {
            corners: [corners[at[0]], corners[at[1]], corners[at[2]]],
            colour: (face as u16 + 1).wrapping_mul(0x2545) | 1,
        })
        .collect()
}

/// How often each pixel is drawn, a triangle at a time: what is missing, and what is drawn more than once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Coverage {
    pub(crate) missing: usize,
    pub(crate) doubled: usize,
}

/// Counts the pixels that `draw` makes differ from 0, for each face alone.
pub(crate) fn coverage(faces: usize, mut draw: impl FnMut(Range<usize>) -> Vec<u16>) -> Coverage {
    let mut hits = vec![0_u32; SIZE * SIZE];
    for face in 0..faces {
        for (hits, pixel) in hits.iter_mut().zip(draw(face..face + 1)) {
            *hits += u32::from(pixel != 0);
        }
    }
    let count = |wanted: fn(u32) -> bool| hits.iter().filter(|&&hits| wanted(hits)).count();
    Coverage { missing: count(|hits| hits == 0), doubled: count(|hits| hits > 1) }
}

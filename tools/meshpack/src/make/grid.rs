//! The grid that other rasterizers were measured on.

use crate::quantise::{Packed, QuantisationError};
use topleft::Length;

/// `v x y` and `t a b c` lines; the file says more.
const TEXT: &str = include_str!("../../../../scenes/grid240.txt");

/// The screen's edge in the file's 1/16 px.
const EDGE: i32 = 240 * 16;

/// Triangles in a row of the grid.
const ROW: usize = 32;

/// A step of a position is 1/16 px, as in the file, so nothing is rounded: with a half edge of 2048 px, a position `p`
/// stands at `p / 32768 * 2048` = `p / 16` px from the screen's centre. In the file y grows down and triangles are
/// clockwise; here x is `x - 1920`, y is `1920 - y` and two corners change places, so that with one pixel to the unit,
/// y up, and the origin in the middle of the screen, every triangle is where the file has it and shows its front.
pub(super) fn make() -> Packed {
    let lines = |keyword: &'static str| {
        TEXT.lines().filter_map(move |line| line.strip_prefix(keyword)).map(|rest| {
            rest.split_whitespace()
                .map(|word| word.parse::<i32>().expect("the grid is numbers"))
                .collect::<Vec<_>>()
        })
    };
    let points: Vec<[i32; 2]> = lines("v ").map(|numbers| [numbers[0], numbers[1]]).collect();
    let faces: Vec<[u16; 3]> =
        lines("t ").map(|numbers| [numbers[0], numbers[2], numbers[1]].map(|index| index as u16)).collect();
    let uv = |value: i32| {
        // The exponent is 1, so that 1.0 is exact: 16 384 steps to the edge, rounded to nearest.
        ((value * 2 * 16_384 + EDGE) / (2 * EDGE)) as i16
    };
    let uv_error =
        |value: i32| (f64::from(uv(value)) / 16_384.0 - f64::from(value) / f64::from(EDGE)).abs() * 256.0;
    Packed {
        positions: points.iter().map(|&[x, y]| [(x - EDGE / 2) as i16, (EDGE / 2 - y) as i16, 0]).collect(),
        normals: vec![[0, 0, 127]; points.len()],
        face_normals: vec![[0, 0, 127]; faces.len()],
        uvs: points.iter().map(|&[x, y]| [uv(x), uv(y)]).collect(),
        uv_exponent: 1,
        vertex_colours: Vec::new(),
        face_colours: (0..faces.len()).map(colour).collect(),
        faces,
        centre: [Length::ZERO; 3],
        half: Length::lit("2048"),
        error: QuantisationError {
            uv_texels: points.as_flattened().iter().map(|&value| uv_error(value)).fold(0.0, f64::max),
            ..QuantisationError::default()
        },
    }
}

/// A colour that no other face has, not even in RGB565: red by column, green by row, blue by half of the square.
fn colour(face: usize) -> [u8; 3] {
    let (row, column, half) = (face / ROW, face % ROW / 2, face % 2);
    [16 * column as u8, 16 * row as u8, if half == 0 { 96 } else { 224 }]
}

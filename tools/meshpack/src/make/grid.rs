//! The grid that other rasterizers were measured on, upright and tilted.

use crate::quantise::{Packed, QuantisationError};
use topleft::Length;

/// `v x y` and `t a b c` lines; the file says more.
const TEXT: &str = include_str!("../../../../scenes/grid240.txt");

/// The screen's edge in the file's 1/16 px.
const EDGE: i32 = 240 * 16;

/// Triangles in a row of the grid.
const ROW: usize = 32;

/// What the file says: points in 1/16 px, y down, and faces with their corners counter-clockwise as they are seen.
struct Grid {
    points: Vec<[i32; 2]>,
    faces: Vec<[u16; 3]>,
}

/// In the file triangles are clockwise: two corners change places.
fn grid() -> Grid {
    let lines = |keyword: &'static str| {
        TEXT.lines().filter_map(move |line| line.strip_prefix(keyword)).map(|rest| {
            rest.split_whitespace()
                .map(|word| word.parse::<i32>().expect("the grid is numbers"))
                .collect::<Vec<_>>()
        })
    };
    Grid {
        points: lines("v ").map(|numbers| [numbers[0], numbers[1]]).collect(),
        faces: lines("t ")
            .map(|numbers| [numbers[0], numbers[2], numbers[1]].map(|index| index as u16))
            .collect(),
    }
}

/// A step of a position is 1/16 px, as in the file, so nothing is rounded: with a half edge of 2048 px, a position `p`
/// stands at `p / 32768 * 2048` = `p / 16` px from the screen's centre. In the file y grows down; here x is `x - 1920`
/// and y is `1920 - y`, so that with one pixel to the unit, y up, and the origin in the middle of the screen, every
/// triangle is where the file has it and shows its front.
pub(super) fn make() -> Packed {
    let Grid { points, faces } = grid();
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

/// Pixels from the screen's centre to its edge, and so the distance of what has a w of 1 under a right angle of view.
const MIDDLE: f64 = 120.0;

/// The same triangles on a plane that recedes, for a camera at the origin that sees 90 degrees: a point that is `(x, y)`
/// pixels from the screen's centre stands at `(x w, y w, -120 w)`, and 1/w is 1 at the bottom edge and 1/4 at the top.
///
/// The screen positions are off by what rounding to 1/64 of the unit makes of them; neighbours share their vertices, so
/// that every pixel is still covered once.
pub(super) fn tilted() -> Packed {
    const STEPS: f64 = 64.0;
    const UV_STEPS: f64 = 16_384.0;
    let Grid { points, faces } = grid();
    let exact: Vec<[f64; 3]> = points
        .iter()
        .map(|point| {
            let [right, down] = point.map(|value| f64::from(value) / 16.0 - MIDDLE);
            let w = 1.0 / (0.625 + 0.375 * down / MIDDLE);
            [right * w, -down * w, -MIDDLE * w]
        })
        .collect();
    // 1 is four repeats: 256 texels of a texture of 64. Linear on the plane, as on any floor.
    let across: Vec<[f64; 2]> =
        exact.iter().map(|[x, _, z]| [x / (8.0 * MIDDLE) + 0.5, (4.0 + z / MIDDLE) / 3.0]).collect();
    let step = |c: f64| (c * STEPS).round();
    let uv = |part: f64| (part * UV_STEPS).round();
    let distances: Vec<_> =
        exact.iter().map(|at| at.iter().map(|c| (step(*c) / STEPS - c).powi(2)).sum::<f64>()).collect();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let repeats = across.as_flattened().iter().map(|c| (uv(*c) / UV_STEPS - c).abs() * 4.0);
    Packed {
        // The plane is y / 320 + z / 192 = -1, seen from the origin.
        normals: vec![[0, 65, 109]; points.len()],
        face_normals: vec![[0, 65, 109]; faces.len()],
        positions: exact.iter().map(|at| at.map(|c| step(c) as i16)).collect(),
        uvs: across.iter().map(|at| at.map(|c| uv(c) as i16)).collect(),
        uv_exponent: 3,
        vertex_colours: Vec::new(),
        face_colours: (0..faces.len()).map(colour).collect(),
        faces,
        centre: [Length::ZERO; 3],
        half: Length::lit("512"),
        error: QuantisationError {
            position_max: largest(&mut distances.iter().map(|square| square.sqrt())),
            position_rms: (distances.iter().sum::<f64>() / distances.len() as f64).sqrt(),
            // Between 65 : 109 and 3 : 5.
            normal_degrees: (65.0_f64.atan2(109.0) - 3.0_f64.atan2(5.0)).abs().to_degrees(),
            uv_texels: largest(&mut repeats.map(|repeats| repeats * 256.0)),
        },
    }
}

/// A colour that no other face has, not even in RGB565: red by column, green by row, blue by half of the square.
fn colour(face: usize) -> [u8; 3] {
    let (row, column, half) = (face / ROW, face % ROW / 2, face % 2);
    [16 * column as u8, 16 * row as u8, if half == 0 { 96 } else { 224 }]
}

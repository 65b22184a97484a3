//! Which share of pixels is decided wrongly by edge functions in 32 bits, by the size of triangles and how finely their
//! corners are snapped.

use crate::axis::{Axis, Bar, Scale, powers, ticks};
use crate::canvas::Canvas;
use crate::map::{Map, Panel};
use crate::random::Random;

const TRIANGLES: u32 = 40;
const PIXELS: u32 = 50;

/// A corner in units of the snapping.
type Corner = [i32; 2];

/// Whether a pixel's centre is inside of the edge from one corner to another, with so many sub-pixel bits.
type Inside = fn(Corner, Corner, [i32; 2], u32) -> bool;

/// The top-left rule for an edge that has the inside on its right, as it is walked with y down.
fn bias([dx, dy]: [i32; 2]) -> i32 {
    i32::from(!(dy < 0 || (dy == 0 && dx > 0)))
}

fn along(from: Corner, to: Corner) -> [i32; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

/// In 128 bits.
fn exact(from: Corner, to: Corner, pixel: [i32; 2], bits: u32) -> bool {
    let [dx, dy] = along(from, to).map(i128::from);
    let centre = |axis: usize| (i128::from(pixel[axis]) * 2 + 1) * (1_i128 << bits) / 2;
    let value = dx * (centre(1) - i128::from(from[1])) - dy * (centre(0) - i128::from(from[0]));
    value >= i128::from(bias(along(from, to)))
}

/// The product as it is, in 32 bits.
fn raw(from: Corner, to: Corner, pixel: [i32; 2], bits: u32) -> bool {
    let edge @ [dx, dy] = along(from, to);
    let centre = |axis: usize| (pixel[axis] * 2 + 1) * (1 << bits) / 2;
    let value = dx.wrapping_mul(centre(1) - from[1]).wrapping_sub(dy.wrapping_mul(centre(0) - from[0]));
    value.wrapping_sub(bias(edge)) >= 0
}

/// Without the bits that all pixel centres have alike: the start from within the corner's pixel, then whole pixels.
fn scaled(from: Corner, to: Corner, pixel: [i32; 2], bits: u32) -> bool {
    let edge @ [dx, dy] = along(from, to);
    let whole = |axis: usize| pixel[axis] - (from[axis] >> bits);
    let within = |axis: usize| (1 << bits) / 2 - (from[axis] & ((1 << bits) - 1));
    let start = dx.wrapping_mul(within(1)).wrapping_sub(dy.wrapping_mul(within(0))).wrapping_sub(bias(edge));
    let steps = dx.wrapping_mul(whole(1)).wrapping_sub(dy.wrapping_mul(whole(0)));
    steps.wrapping_add(start >> bits) >= 0
}

/// The share of pixels that a method decides wrongly, of triangles that fill a box.
fn wrong(inside: Inside, side: f64, bits: u32) -> f64 {
    let mut random = Random::new(side as u64 * 64 + u64::from(bits));
    let most = (side as i64) << bits;
    let mut count = 0;
    for _ in 0..TRIANGLES {
        let mut at = || random.within(0, most) as i32;
        // From one corner of the box to the other sides.
        let mut corners = [[0, 0], [most as i32, at()], [at(), most as i32]];
        if random.next().is_multiple_of(2) {
            corners = corners.map(|[x, y]| [most as i32 - x, y]);
            corners.swap(1, 2);
        }
        for _ in 0..PIXELS {
            let pixel = [(); 2].map(|()| random.within(0, side as i64 - 1) as i32);
            let edges = [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (corners[from], corners[to]));
            let covered = |inside: Inside| edges.iter().all(|&(from, to)| inside(from, to, pixel, bits));
            count += u32::from(covered(inside) != covered(exact));
        }
    }
    f64::from(count) / f64::from(TRIANGLES * PIXELS)
}

pub(crate) fn map() -> Canvas {
    let x = Axis {
        name: "side of the triangle's box in px",
        scale: Scale::Log,
        ends: [16.0, 65_536.0],
        cells: 48,
        ticks: powers([4, 6, 8, 10, 12, 14, 16]),
    };
    let y = Axis {
        name: "sub-pixel bits",
        scale: Scale::Linear,
        ends: [-0.5, 12.5],
        cells: 13,
        ticks: ticks(&[0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0]),
    };
    let panel = |title: &str, inside: Inside, label: &str, most: fn(f64) -> f64| Panel {
        title: title.into(),
        values: Map::cells(&x, &y, |side, bits| wrong(inside, side, bits.round() as u32)),
        line: (label.into(), Box::new(move |side: f64, bits: f64| side > most(bits))),
    };
    let panels = vec![
        panel("naive: E in i32", raw, "bound: side = 2^((31 - 2s) / 2)", |bits| {
            ((31.0 - 2.0 * bits) / 2.0).exp2()
        }),
        panel(
            "topleft's: floor((E - bias) / 2^s) in i32",
            scaled,
            "bound: side = least of 2^((31 - s) / 2), 2^(30 - 2s)",
            |bits| ((31.0 - bits) / 2.0).min(30.0 - 2.0 * bits).exp2(),
        ),
    ];
    let bar = Bar { name: "wrong px", ends: [1e-3, 1.0], ticks: ticks(&[0.001, 0.01, 0.1, 1.0]) };
    let notes = vec![
        "Share of pixels in the box that are decided otherwise than in 128 bits. topleft has 8 sub-pixel bits and a guard".into(),
        "rectangle of less than 2^23 px (2896 x 2896), so that no triangle crosses the line.".into(),
    ];
    Map {
        title: "Where 32-bit edge functions break: wrong pixels by the size of triangles and sub-pixel bits",
        x,
        y,
        cell: [7, 16],
        bar,
        allowed: 0.0,
        panels,
        notes,
    }
    .draw()
}

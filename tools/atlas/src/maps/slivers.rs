//! How far values are off that planes carry over slivers, by their width and length.

use reference::naive::plane;
use reference::setup::Triangle;
use reference::varying::linear;
use topleft::stages::Window;

use crate::axis::{Axis, Bar, Scale, powers, ticks};
use crate::canvas::Canvas;
use crate::drawn;
use crate::map::{Map, Panel};
use crate::random::Random;

/// What a value may be off, in codes.
const ALLOWED: f64 = 0.5;
/// The largest difference between corners, in codes.
const RANGE: f64 = 255.0;
/// Slivers for each cell, and how often one that covers no pixel is thrown away.
const CASES: u32 = 6;
const ATTEMPTS: u32 = 40;
/// Pixels of a sliver that are looked at, about.
const PIXELS: f64 = 300.0;

/// A plane over a triangle: its value at a pixel.
type Method = fn(Triangle, [f64; 3], i64, i64) -> f64;

struct Case {
    triangle: Triangle,
    values: [f64; 3],
    /// Some of the pixels that it covers, and what the library has there.
    pixels: Vec<([i64; 2], f64)>,
}

/// (u, v) with `a v - b u = 1`, for numbers without a common divisor.
fn bezout(a: i64, b: i64) -> Option<[i64; 2]> {
    let ([mut r, mut next_r], [mut s, mut next_s], [mut t, mut next_t]) = ([a, b], [1, 0], [0, 1]);
    while next_r != 0 {
        let quotient = r / next_r;
        (r, next_r) = (next_r, r - quotient * next_r);
        (s, next_s) = (next_s, s - quotient * next_s);
        (t, next_t) = (next_t, t - quotient * next_t);
    }
    (r == 1).then_some([-t, s])
}

/// A triangle as long and as wide as that, to one step of its area, with the centre of a pixel in it or on its edge.
///
/// Its longest side has no point of the lattice within; then each line beside it, a step of the area further, has one
/// point for each length of that side.
fn sliver(width: f64, length: f64, random: &mut Random) -> Option<Triangle> {
    let area = (width * length * 65_536.0).round() as i64;
    let (sin, cos) = (random.unit() * std::f64::consts::FRAC_PI_2).sin_cos();
    let along @ [dx, dy] = [cos, sin].map(|c| (c * length * 256.0).round() as i64);
    let beside = bezout(dx, dy)?;
    if area < 3 {
        return None;
    }
    let square = (dx * dx + dy * dy) as f64;
    let at = |line: i64, part: f64| {
        let from = beside.map(|c| c * line);
        let there = from[0] as f64 * (dx as f64 / square) + from[1] as f64 * (dy as f64 / square);
        let times = (part - there).round() as i64;
        [0, 1].map(|k| from[k] + along[k] * times)
    };
    let apex = at(area, 0.5);
    let line = random.within(1, area - 1);
    let share = line as f64 / area as f64;
    let apex_part = (apex[0] * dx + apex[1] * dy) as f64 / square;
    let inside = at(line, share * apex_part + (1.0 - share) / 2.0);
    let corners = [[0, 0], along, apex];
    let moved = [0, 1].map(|k| {
        let least = corners.iter().map(|corner| corner[k]).min().unwrap_or(0);
        let to_centre = (128 - inside[k]).rem_euclid(256);
        to_centre - (least + to_centre).div_euclid(256) * 256
    });
    let mut triangle = corners.map(|corner| [0, 1].map(|k| (corner[k] + moved[k]) as i32));
    triangle.rotate_left(random.within(0, 2) as usize);
    Some(triangle)
}

impl Case {
    fn new(width: f64, length: f64, random: &mut Random) -> Option<Self> {
        let triangle = sliver(width, length, random)?;
        let mut values = [0.0, RANGE, random.within(0, RANGE as i64) as f64];
        values.rotate_left(random.within(0, 2) as usize);
        let end = |axis: usize| triangle.iter().map(|corner| corner[axis] / 256 + 1).max().unwrap_or(0);
        let window = Window { columns: 0..end(0), rows: 0..end(1) };
        let every = (width * length / 2.0 / PIXELS).max(1.0) as usize;
        let (mut pixels, mut count) = (Vec::new(), 0);
        drawn::values(triangle, values, &window, |x, y, value| {
            count += 1;
            if count % every == 0 {
                pixels.push(([x, y].map(i64::from), value));
            }
        });
        (!pixels.is_empty()).then_some(Self { triangle, values, pixels })
    }

    /// The largest error of a method, or of the library.
    fn error(&self, method: Option<Method>) -> f64 {
        let Self { triangle, values, .. } = *self;
        let off = |&([x, y], ours): &([i64; 2], f64)| {
            let shown = method.map_or(ours, |method| method(triangle, values, x, y));
            (shown - linear(triangle, values, x, y)).abs()
        };
        self.pixels.iter().map(off).fold(0.0, f64::max)
    }
}

/// The largest error in some slivers, where there are any.
fn error(method: Option<Method>, length: f64, width: f64) -> Option<f64> {
    // Whole numbers, so that the last bit of a system's `log2` does not matter.
    let [l, w] = [length, width].map(|c| (c.log2() * 1000.0).round() as i64 as u64);
    let mut random = Random::new(l ^ w.rotate_left(17));
    let mut one = || (0..ATTEMPTS).find_map(|_| Case::new(width, length, &mut random));
    let cases: Vec<Case> = (0..CASES).filter_map(|_| one()).collect();
    cases.iter().map(|case| case.error(method)).reduce(f64::max)
}

/// `(n + m + 2) 2^-17 + D 2^-30`, n and m up to the length.
fn of_library(length: f64, _: f64) -> f64 {
    (2.0 * length + 2.0) * 2.0_f64.powi(-17) + RANGE * 2.0_f64.powi(-30)
}

pub(crate) fn map() -> Canvas {
    let x = Axis {
        name: "length of the sliver in px",
        scale: Scale::Log,
        ends: [4.0, 2048.0],
        cells: 27,
        ticks: powers([2, 5, 8, 11]),
    };
    let y = Axis {
        name: "width of the sliver in px",
        scale: Scale::Log,
        ends: [2.0_f64.powi(-14), 64.0],
        cells: 40,
        ticks: powers([-14, -12, -10, -8, -6, -4, -2, 0, 2, 4, 6]),
    };
    let panel = |title: &str, method: Option<Method>, label: &str, bound: fn(f64, f64) -> f64| Panel {
        title: title.into(),
        values: Map::cells(&x, &y, |length, width| error(method, length, width)),
        line: (label.into(), Box::new(move |length, width| bound(length, width) > ALLOWED)),
    };
    let panels = vec![
        panel("Q16.16, saturating", Some(plane::saturated), "D / width = 2^15", |_, width| {
            // From there on every error is possible.
            if RANGE / width > 32_768.0 { RANGE } else { 0.0 }
        }),
        panel("2^32 / area", Some(plane::reciprocal_of_32_bits), "D l w 2^-16 = 1/2", |length, width| {
            RANGE * length * width / 65_536.0
        }),
        panel(
            "A x + B y + C in f32",
            Some(plane::from_the_corner),
            "13 D l/w 2^-24 = 1/2",
            |length, width| 13.0 * RANGE * length / width * 2.0_f64.powi(-24),
        ),
        panel("topleft: Q16.16, wrapping", None, "bound = 1/2: nowhere", of_library),
    ];
    let bar =
        Bar { name: "codes", ends: [1e-6, 1000.0], ticks: ticks(&[1e-6, 1e-4, 0.01, 0.5, 10.0, 1000.0]) };
    let notes = vec![
        "Largest error of a value of 0 to 255 codes (D = 255) at the pixels of slivers in all directions. Lines: where the"
            .into(),
        "bound of each method passes half a code. Bounds: a gradient beyond 2^15 does not fit; a reciprocal of the area in"
            .into(),
        "2^-32 that is off by one (l: length, w: width); 13 roundings of f32, of terms of D l/w; (n + m + 2) 2^-17 + D 2^-30."
            .into(),
    ];
    Map {
        title: "Where interpolation breaks: error by the width and the length of slivers",
        x,
        y,
        cell: [6, 5],
        bar,
        allowed: ALLOWED,
        panels,
        notes,
    }
    .draw()
}

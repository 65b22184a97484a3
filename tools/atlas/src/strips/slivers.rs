//! Slivers: what is interpolated over triangles that are hardly there.

use reference::naive::plane;
use reference::setup::{Triangle, area2};
use reference::varying::linear;

use crate::canvas::Canvas;
use crate::drawn;
use crate::random::Random;
use crate::strip::{Picture, Strip};

pub(crate) const SIDE: i32 = 66;

/// A triangle with a grey at each corner.
type Shaded = (Triangle, [f64; 3]);

/// Greys over triangles, where `value` says what each pixel gets; later ones over earlier ones.
pub(crate) fn greys(shaded: &[Shaded], value: impl Fn(Triangle, [f64; 3], i64, i64) -> f64) -> Picture {
    let mut pixels = vec![drawn::BACKGROUND; (SIDE * SIDE) as usize];
    for &(triangle, values) in shaded {
        for (index, _) in
            drawn::hits(&[triangle], SIDE, SIDE).iter().enumerate().filter(|(_, hits)| **hits > 0)
        {
            let (x, y) = (index as i64 % i64::from(SIDE), index as i64 / i64::from(SIDE));
            pixels[index] = [value(triangle, values, x, y).round().clamp(0.0, 255.0) as u8; 3];
        }
    }
    Picture::new(SIDE as usize, pixels)
}

/// Row 7: needles a few 1/256 px wide.
pub(crate) fn needles() -> Canvas {
    let mut random = Random::new(7);
    let mut shaded = Vec::new();
    while shaded.len() < 30_000 {
        let mut at = || [(); 2].map(|()| random.within(0, i64::from(SIDE) * 256) as i32);
        let (a, b) = (at(), at());
        let part = random.within(0, 256) as i32;
        let c = [0, 1].map(|k| a[k] + (((b[k] - a[k]) * part) >> 8) + random.within(-1, 1) as i32);
        let values = [32.0, 224.0, 224.0];
        if area2([a, b, c]) != 0 {
            shaded.push(([a, b, c], values));
        }
    }
    Strip {
        title: "7  Gradients of needles 1/256 px wide do not fit their format",
        naive_method: "gradients saturate",
        naive: greys(&shaded, plane::saturated),
        topleft: drawn::greys(&shaded, SIDE),
        reference: greys(&shaded, linear),
        zoom: 3,
        times: 2,
        unit: "code",
        notes: vec!["30 000 needles from dark to light; each shows few pixels or none. Gradients that wrap are right where it counts.".into()],
    }
    .draw()
}

/// Row 8: an area whose reciprocal has no bit left.
pub(crate) fn large() -> Canvas {
    let steps = |pixels: i32| pixels * 256;
    let shaded = [
        ([[steps(-20), steps(-30)], [steps(300), steps(40)], [steps(10), steps(260)]], [24.0, 200.0, 255.0]),
        ([[steps(2), steps(62)], [steps(64), steps(8)], [steps(64), steps(8) + 60]], [255.0, 64.0, 64.0]),
    ];
    Strip {
        title: "8  The reciprocal of a large area, taken as 2^32 / area",
        naive_method: "no normalised 1/area",
        naive: greys(&shaded, plane::reciprocal_of_32_bits),
        topleft: drawn::greys(&shaded, SIDE),
        reference: greys(&shaded, linear),
        zoom: 3,
        times: 4,
        unit: "code",
        notes: vec!["A triangle of 38 000 px and a sliver on it. topleft keeps 31 bits of the reciprocal of any area.".into()],
    }
    .draw()
}

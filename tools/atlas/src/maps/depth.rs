//! Which share of surfaces behind each other gets one depth code, by the scene's depth and their distance.

use topleft::{Depth, Depth16, DepthFloat};

use crate::axis::{Axis, Bar, Scale, ticks};
use crate::canvas::Canvas;
use crate::map::{Map, Panel};

/// Pairs for each cell, at distances that grow by one factor.
const PAIRS: u32 = 997;

/// The code at a distance of 1 (the near plane) to `far`.
type Format = fn(f64, f64) -> u16;

/// The library's, which keep `1 - z / w` in 32 bits.
fn library<D: for<'c> Depth<Cell<'c> = &'c mut u16>>(w: f64, far: f64) -> u16 {
    let nearness = (far / w - 1.0) / (far - 1.0);
    let mut cell = 0;
    // The cast saturates.
    D::cover(&mut cell, D::varying(D::vertex(|| (nearness * 2.0_f64.powi(32)) as u32)));
    cell
}

/// 1/w as a small float with `EXPONENT` bits for its power of two, and the rest of 16 for its mantissa.
fn float<const EXPONENT: i32>(w: f64, _: f64) -> u16 {
    let (q, mantissa) = (1.0 / w, 16 - EXPONENT);
    // The last power has no leading one, and goes down to 0.
    let last = (1 << EXPONENT) - 1;
    let down = (-q.log2()).floor().min(f64::from(last)) as i32;
    let scaled = q * 2.0_f64.powi(mantissa + if down == last { last } else { down + 1 });
    let power = if down == last { 0 } else { last - down - 1 };
    (f64::from(power << mantissa) + scaled).min(65_535.0) as u16
}

/// The share of pairs, one `apart` times further than the other, whose codes are the same.
fn ties(format: Format, far: f64, apart: f64) -> f64 {
    let furthest = far / (1.0 + apart);
    if furthest <= 1.0 {
        return 1.0;
    }
    let at = |k: u32| furthest.powf((f64::from(k) + 0.5) / f64::from(PAIRS));
    let tied = (0..PAIRS).map(at).filter(|&w| format(w, far) == format(w * (1.0 + apart), far)).count();
    tied as f64 / f64::from(PAIRS)
}

/// The least distance that the format tells apart everywhere.
fn float_resolution<const EXPONENT: i32>(far: f64) -> f64 {
    let step = 2.0_f64.powi(EXPONENT - 16);
    step * (far * 2.0_f64.powi(1 - (1 << EXPONENT))).max(1.0)
}

pub(crate) fn map() -> Canvas {
    let x = Axis {
        name: "far / near",
        scale: Scale::Log,
        ends: [2.0, 4096.0],
        cells: 33,
        ticks: ticks(&[2.0, 16.0, 128.0, 1024.0, 4096.0]),
    };
    let y = Axis {
        name: "distance between two surfaces, of w",
        scale: Scale::Log,
        ends: [1e-5, 0.1],
        cells: 36,
        ticks: [(1e-5, "0.001 %"), (1e-4, "0.01 %"), (1e-3, "0.1 %"), (1e-2, "1 %"), (0.1, "10 %")]
            .map(|(value, label)| (value, label.to_owned()))
            .into(),
    };
    let panel = |title: &str, format: Format, resolution: fn(f64) -> f64| Panel {
        title: title.into(),
        values: Map::cells(&x, &y, |far, apart| ties(format, far, apart)),
        line: ("bound: no tie above".into(), Box::new(move |far: f64, apart: f64| apart < resolution(far))),
    };
    let panels = vec![
        panel("Depth16: 4 + 65528 (1 - z/w)", library::<Depth16>, |far| (far - 1.0) / 65_528.0),
        panel("DepthFloat: the same as e4m12", library::<DepthFloat>, float_resolution::<4>),
        panel("1/w, float e3m13 (model)", float::<3>, float_resolution::<3>),
    ];
    let bar = Bar { name: "tied pairs", ends: [1e-3, 1.0], ticks: ticks(&[0.001, 0.01, 0.1, 1.0]) };
    let notes = vec![
        "Share of pairs of surfaces that get the same code, at distances from near to far that grow by one factor.".into(),
        "Bounds: (far/near - 1) / 65528 for what is linear on the screen, worst at the far plane; 2^-12 and 2^-13 for".into(),
        "the floats, until the far plane is beyond their last power of two (2^15 and 2^7).".into(),
    ];
    Map {
        title: "Where depth formats tie: surfaces with the same 16-bit code",
        x,
        y,
        cell: [6, 6],
        bar,
        allowed: 0.0,
        panels,
        notes,
    }
    .draw()
}

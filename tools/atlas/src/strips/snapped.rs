//! Corners on their way to whole steps of a pixel.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::{Drawable as _, RgbColor as _, Size};
use reference::naive::snap::{cast, rounded};
use reference::naive::triangles;
use reference::raster::{coverage_counts, covers};
use reference::setup::Triangle;
use reference::transform::Viewport;
use reference::varying::linear;
use topleft::stages::Window;
use topleft::{ShadedTriangle, point};

use crate::canvas::Canvas;
use crate::drawn::{self, BACKGROUND, Sent};
use crate::strip::{Picture, Strip};
use crate::strips::coverage::LEGEND;
use crate::strips::slivers::SIDE;

/// Row 9: a corner that stands on an edge of its neighbour.
pub(crate) fn t_junction() -> Canvas {
    let viewport = Viewport { width: 25, height: 25 };
    let cut = |bits: u32| triangles::t_junction([[-13.3, 8.6], [40.4, 17.2]], 0.43, bits);
    let ([over, left, right], [q, p, m]) = cut(8);
    // What the mesh should have been: the corner on the edge belongs to both sides.
    let whole = [[p, m, over[2]], [m, q, over[2]], left, right];
    Strip {
        title: "9  A corner stands on the edge of one large triangle",
        naive_method: "whole pixels",
        naive: Picture::of_hits(25, coverage_counts(&cut(0).0, viewport)),
        topleft: Picture::of_hits(25, drawn::hits(&[over, left, right], 25, 25)),
        reference: Picture::of_hits(25, coverage_counts(&whole, viewport)),
        zoom: 8,
        times: 127,
        unit: "hit",
        notes: vec![
            "A T-junction: a fault of the mesh. Rounding moves the corner off that edge: by up to 1/2 px both ways on whole pixels,"
                .into(),
            "by 1/512 px in topleft, where only pixel centres in that gap show it. The reference has the corner on both sides."
                .into(),
            LEGEND.into(),
        ],
    }
    .draw()
}

/// Row 27: a corner that is nowhere.
pub(crate) fn not_a_number() -> Canvas {
    let ring: Vec<[f64; 2]> =
        (0..8)
            .map(|i| (f64::from(i) + 0.3) * std::f64::consts::TAU / 8.0)
            .map(|angle| {
                if angle < 0.3 { [f64::NAN; 2] } else { [15.0 + 8.0 * angle.cos(), 15.0 - 8.0 * angle.sin()] }
            })
            .collect();
    let fan: Vec<[[f64; 2]; 3]> = (0..8).map(|i| [[15.2, 15.1], ring[i], ring[(i + 1) % 8]]).collect();
    let viewport = Viewport { width: 25, height: 25 };
    let snapped = |fan: &[[[f64; 2]; 3]]| -> Vec<Triangle> {
        fan.iter().map(|corners| corners.map(|at| at.map(|c| cast(c, 8)))).collect()
    };
    let finite: Vec<_> =
        fan.iter().copied().filter(|t| t.as_flattened().iter().all(|c| c.is_finite())).collect();
    let mut display = Sent::new(Size::new(25, 25));
    for corners in &fan {
        let corners = corners.map(|[x, y]| point(x as f32, y as f32));
        let Ok(()) = ShadedTriangle::flat(corners, Rgb565::WHITE).draw(&mut display);
    }
    // Rounded as topleft rounds: to nearest.
    let exact: Vec<Triangle> =
        finite.iter().map(|t| t.map(|at| at.map(|c| (c * 256.0).round() as i32))).collect();
    Strip {
        title: "27  A fan with a corner that is not a number",
        naive_method: "(x * 256.0) as i32",
        naive: Picture::of_hits(25, coverage_counts(&snapped(&fan), viewport)),
        topleft: Picture::of_hits(25, display.counts),
        reference: Picture::of_hits(25, coverage_counts(&exact, viewport)),
        zoom: 8,
        times: 127,
        unit: "hit",
        notes: vec![
            "A cast makes 0 of it, and two triangles reach for the corner of the screen. In topleft they draw nothing.".into(),
            LEGEND.into(),
        ],
    }
    .draw()
}

/// By how much finer than 1/256 px the reference of motion is. Odd, so that the centres of pixels stay centres.
const FINER: i64 = 63;

/// Row 17: a wheel that turns slowly: one row of pixels in each of 66 frames.
pub(crate) fn slow_motion() -> Canvas {
    const ROW: i64 = 5;
    const SPOKES: usize = 48;
    let wheel = |frame: i32| -> [[f64; 2]; SPOKES] {
        // The rim moves by 1/24 px a frame.
        let turned = f64::from(frame) / 24.0 / 44.0;
        std::array::from_fn(|i| {
            let (sin, cos) = (turned + i as f64 * std::f64::consts::TAU / SPOKES as f64).sin_cos();
            [33.3 + 44.0 * cos, 33.4 - 44.0 * sin]
        })
    };
    let triangles = |frame: i32, snap: &dyn Fn(f64) -> i32| -> Vec<(Triangle, [f64; 3])> {
        let (rim, hub) = (wheel(frame), [33.3, 33.4]);
        let grey = |i: usize| if i.is_multiple_of(2) { 16.0 } else { 240.0 };
        let one = |i: usize| {
            let next = (i + 1) % SPOKES;
            ([hub, rim[i], rim[next]].map(|at| at.map(snap)), [128.0, grey(i), grey(next)])
        };
        (0..SPOKES).map(one).collect()
    };
    let picture = |row: &dyn Fn(i32) -> Vec<u8>| {
        Picture::new(SIDE as usize, (0..SIDE).flat_map(row).map(|grey| [grey; 3]).collect())
    };
    // Pixel `x` of a row whose centres are `finer` times as far apart.
    let exact = |shaded: &[(Triangle, [f64; 3])], finer: i64| -> Vec<u8> {
        let place = |pixel: i64| finer * pixel + finer / 2;
        (0..i64::from(SIDE))
            .map(|x| {
                let (x, y) = (place(x), place(ROW));
                let hit = shaded.iter().find(|(triangle, _)| covers(*triangle, x, y));
                hit.map_or(BACKGROUND[0], |&(triangle, values)| linear(triangle, values, x, y).round() as u8)
            })
            .collect()
    };
    let steps = |c: f64| (c * 256.0).round() as i32;
    let ours = |frame: i32| {
        let mut row = vec![BACKGROUND[0]; SIDE as usize];
        let window = Window { columns: 0..SIDE, rows: ROW as i32..ROW as i32 + 1 };
        for (triangle, values) in triangles(frame, &steps) {
            drawn::values(triangle, values, &window, |x, _, value| row[x as usize] = value.round() as u8);
        }
        row
    };
    Strip {
        title: "17  A wheel turns by 1/24 px a frame: one row of pixels, frames from above",
        naive_method: "whole pixels",
        naive: picture(&|frame| exact(&triangles(frame, &|c| rounded(steps(c), 0)), 1)),
        topleft: picture(&ours),
        reference: picture(&|frame| {
            exact(&triangles(frame, &|c| (c * 256.0 * FINER as f64).round() as i32), FINER)
        }),
        zoom: 3,
        times: 4,
        unit: "code",
        notes: vec![
            "Corners on whole pixels stand still and then jump, one by one, and all that hangs on them with them. topleft rounds".into(),
            "to 1/256 px. The reference rounds 63 times finer.".into(),
        ],
    }
    .draw()
}

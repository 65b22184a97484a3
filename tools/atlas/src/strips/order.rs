//! Strips: what a frame looks like where each strip sets up its own part of a triangle.

use reference::naive::screen_clip::{Valued, to_rows};
use reference::naive::triangles;
use reference::varying::linear;

use crate::canvas::Canvas;
use crate::drawn;
use crate::strip::Strip;
use crate::strips::slivers::{SIDE, greys};

/// Row 31: strips of eight rows.
pub(crate) fn strips() -> Canvas {
    const ROWS: usize = 8;
    let hub = [33 * 256 + 40, 33 * 256 + 90];
    let ring = triangles::ring(hub, 46.0, 96, 0.02, 1);
    let fan = triangles::fan(hub, &ring).into_iter().enumerate();
    let shaded: Vec<Valued> = fan
        .map(|(i, fan)| (fan, if i % 2 == 0 { [128.0, 0.0, 255.0] } else { [128.0, 255.0, 0.0] }))
        .collect();
    let strips = (0..SIDE).step_by(ROWS).map(|top| top..(top + ROWS as i32).min(SIDE));
    let parts: Vec<Valued> =
        strips.flat_map(|rows| shaded.iter().flat_map(move |&whole| to_rows(whole, rows.clone()))).collect();
    Strip {
        title: "31  A fan of 96 triangles drawn in strips of 8 rows",
        naive_method: "clipped to strips",
        naive: greys(&parts, linear),
        topleft: drawn::greys_in_strips(&shaded, SIDE, ROWS),
        reference: greys(&shaded, linear),
        zoom: 3,
        times: 255,
        unit: "code",
        notes: vec![
            "Corners that a strip makes are rounded to 1/256 px, and planes start anew from them: seams every 8 rows.".into(),
        ],
    }
    .draw()
}

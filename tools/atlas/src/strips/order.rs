//! The order of things that should not matter: a triangle's corners, and strips of a frame that set up their own part.

use std::collections::BTreeSet;

use reference::naive::screen_clip::{Valued, to_rows};
use reference::naive::{plane, triangles};
use reference::setup::Triangle;
use reference::varying::linear;
use topleft::stages::Window;

use crate::canvas::Canvas;
use crate::drawn;
use crate::strip::{Picture, Strip};
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
            "Corners that a strip makes are rounded to 1/256 px, and its planes start from them: its pixels are not the frame's.".into(),
        ],
    }
    .draw()
}

/// What gets column, row and value of each pixel.
type Each<'e> = &'e mut dyn FnMut(i32, i32, f64);

const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// Row 32: two triangles whose corners are named in all six orders.
pub(crate) fn corners() -> Canvas {
    let at = |x: i32, y: i32| [x * 256 + 37, y * 256 + 90];
    let [a, b, c, d] = [at(3, 2), at(61, 9), at(57, 62), at(6, 52)];
    let shaded: [Valued; 2] = [([a, b, c], [20.0, 240.0, 100.0]), ([a, c, d], [20.0, 100.0, 230.0])];
    let window = Window { columns: 0..SIDE, rows: 0..SIDE };
    // How many different values the orders give a pixel; `all` calls its function with a pixel's index and value.
    let different = |all: &dyn Fn(Valued, Each<'_>)| {
        let mut found = vec![BTreeSet::new(); (SIDE * SIDE) as usize];
        for (order, (triangle, values)) in ORDERS.iter().flat_map(|order| shaded.map(|one| (order, one))) {
            all((order.map(|i| triangle[i]), order.map(|i| values[i])), &mut |x, y, value| {
                found[(y * SIDE + x) as usize].insert(value.to_bits());
            });
        }
        Picture::of_hits(SIDE as usize, found.into_iter().map(|values| values.len() as u32))
    };
    let by = |value: fn(Triangle, [f64; 3], i64, i64) -> f64| {
        different(&|(triangle, values), each: Each<'_>| {
            drawn::values(triangle, values, &window, |x, y, _| {
                each(x, y, value(triangle, values, x.into(), y.into()));
            });
        })
    };
    Strip {
        title: "32  The same two triangles, their corners in all six orders",
        naive_method: "f32 from corner 0",
        naive: by(plane::from_the_given_vertex),
        topleft: different(&|(triangle, values), each| {
            drawn::values(triangle, values, &window, each);
        }),
        // Exact, but for the last bits of its own floats.
        reference: by(|triangle, values, x, y| (linear(triangle, values, x, y) * 1e9).round()),
        zoom: 3,
        times: 51,
        unit: "value",
        notes: vec![
            "How many different values a pixel gets, to the last bit. Dark: not covered; pale: one; red: two; orange: more.".into(),
        ],
    }
    .draw()
}

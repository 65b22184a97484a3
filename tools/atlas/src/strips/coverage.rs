//! Coverage: pixels hit twice, or by nobody.

use embedded_graphics::prelude::Size;
use reference::naive::snap as naive_snap;
use reference::naive::{alpha_edges, edge_function, screen_clip, triangles};
use reference::raster::{counts_by, coverage_counts};
use reference::setup::{Facing, Triangle, facing, snap};
use reference::transform::Viewport;

use crate::canvas::Canvas;
use crate::drawn;
use crate::strip::{Picture, Strip};

pub(crate) const LEGEND: &str = "dark: hit by no triangle; pale: by one; red: by two; orange: by more";

/// Hits of triangles, by a naive method's own count.
fn hits(
    title: &'static str,
    naive_method: &'static str,
    triangles: &[Triangle],
    [width, height]: [u32; 2],
    zoom: i32,
    naive: Vec<u32>,
    note: &str,
) -> Canvas {
    let viewport = Viewport { width, height };
    let picture = |hits: Vec<u32>| Picture::of_hits(width as usize, hits);
    Strip {
        title,
        naive_method,
        naive: picture(naive),
        topleft: picture(drawn::hits(triangles, width as i32, height as i32)),
        reference: picture(coverage_counts(triangles, viewport)),
        zoom,
        times: 127,
        unit: "hit",
        notes: vec![note.into(), LEGEND.into()],
    }
    .draw()
}

/// Row 1: squares whose edges and diagonals run through pixel centres.
pub(crate) fn shared_edges() -> Canvas {
    let squares = [[2, 2], [12, 2], [2, 12], [12, 12]];
    let parts =
        squares.into_iter().flat_map(|at| triangles::rectangle_on_centres(at, [10, 10], at[0] == at[1]));
    let triangles: Vec<Triangle> = parts.collect();
    let viewport = Viewport { width: 25, height: 25 };
    hits(
        "1  Two triangles share an edge that runs through pixel centres",
        "all weights in [0, 1]",
        &triangles,
        [25, 25],
        8,
        counts_by(edge_function::inclusive, &triangles, viewport),
        "Four squares of two triangles each, all corners on pixel centres.",
    )
}

/// Row 2: a fan round a pixel centre.
pub(crate) fn fan() -> Canvas {
    let hub = [12 * 256 + 128, 12 * 256 + 128];
    let triangles = triangles::fan(hub, &triangles::ring(hub, 11.0, 24, 0.0, 128));
    let viewport = Viewport { width: 25, height: 25 };
    hits(
        "2  A fan of 24 triangles round a pixel centre",
        "all weights above 0",
        &triangles,
        [25, 25],
        8,
        counts_by(edge_function::exclusive, &triangles, viewport),
        "Corners on the half-pixel lattice. With weights in [0, 1] the hub is hit 24 times.",
    )
}

/// Row 3: triangles far larger than the screen.
pub(crate) fn guard_sized() -> Canvas {
    let hub = [28 * 256 + 57, 30 * 256 + 201];
    let triangles = triangles::fan(hub, &triangles::ring(hub, 1000.0, 8, 0.1, 1));
    let viewport = Viewport { width: 66, height: 66 };
    hits(
        "3  A fan of eight triangles that reach 1000 px beyond the screen",
        "edge functions in i32",
        &triangles,
        [66, 66],
        3,
        counts_by(edge_function::in_32_bits, &triangles, viewport),
        "With 8 sub-pixel bits a product of two sides overflows 31 bits beyond 181 x 181 px.",
    )
}

/// Row 4: one triangle larger than the numbers of its edge functions.
pub(crate) fn beyond_the_guard() -> Canvas {
    let right_angle = triangles::right_angle([-700, -900], [3700, 3900]);
    let size = Size::new(66, 66);
    let viewport = Viewport { width: 66, height: 66 };
    let ours = drawn::sent(&[right_angle], size);
    Strip {
        title: "4  A triangle with legs of 3700 and 3900 px over all of the screen",
        naive_method: "no guard rectangle",
        naive: Picture::of_hits(66, counts_by(edge_function::without_guard, &[right_angle], viewport)),
        topleft: Picture::of_hits(66, ours),
        reference: Picture::of_hits(66, coverage_counts(&[right_angle], viewport)),
        zoom: 3,
        times: 127,
        unit: "hit",
        notes: vec![
            "Its box has more than 2^23 px: the edge functions in steps of 2^-8 px^2 wrap. topleft clips it at the guard rectangle."
                .into(),
            LEGEND.into(),
        ],
    }
    .draw()
}

/// Row 6: a sliver that rounding turns over.
pub(crate) fn turned_over() -> Canvas {
    let places = triangles::turned_over([3.0, 12.0], 19.0, 0.4);
    let triangles: Vec<Triangle> =
        places.iter().map(|triangle| triangle.map(|place| place.map(|c| snap(c).expect("finite")))).collect();
    let viewport = Viewport { width: 25, height: 25 };
    let split = |front: &dyn Fn(usize) -> bool| -> [Vec<Triangle>; 2] {
        let (fronts, backs): (Vec<_>, Vec<_>) = (0..triangles.len()).partition(|&i| front(i));
        [fronts, backs].map(|side| side.into_iter().map(|i| triangles[i]).collect())
    };
    // Front hits minus back hits: none is negative here.
    let winding = |[fronts, backs]: [Vec<u32>; 2]| {
        Picture::of_hits(25, fronts.into_iter().zip(backs).map(|(front, back)| front - back))
    };
    let exact = |sides: [Vec<Triangle>; 2]| winding(sides.map(|side| coverage_counts(&side, viewport)));
    let ours = split(&|i| drawn::is_front(triangles[i]));
    Strip {
        title: "6  A sliver whose corners change their order when they are rounded",
        naive_method: "facing before rounding",
        naive: exact(split(&|i| naive_snap::area2_before(places[i]) < 0.0)),
        topleft: winding(ours.map(|side| drawn::hits(&side, 25, 25))),
        reference: exact(split(&|i| facing(triangles[i]) == Facing::Front)),
        zoom: 8,
        times: 127,
        unit: "hit",
        notes: vec![
            "Four triangles without a fold; front hits minus back hits should be 1. The sliver shows its front before, and".into(),
            "its back after rounding. Dark: 0; pale: 1; red: 2; orange: 3.".into(),
        ],
    }
    .draw()
}

/// Row 13: triangles that are clipped to the screen because they are large, and neighbours that are not.
pub(crate) fn clipped_by_size() -> Canvas {
    let at = |x: i32, y: i32| [x * 256 + 128, y * 256 + 128];
    let hub = at(0, 0);
    // Edges through many pixel centres: small triangles on one side, on the other large ones that reach far beyond.
    let ends = [[150, 25], [150, 50], [150, 100], [100, 150], [50, 150], [25, 150]].map(|[x, y]| at(x, y));
    let small = [0, 2, 4].map(|i| [hub, ends[i], ends[i + 1]]);
    let far = [at(1400, 700), at(700, 1400)];
    let large = [[1, 0], [3, 1]].map(|[i, f]| [[hub, ends[i], far[f]], [hub, far[f], ends[i + 1]]]);
    let triangles: Vec<Triangle> = small.into_iter().chain(large.into_iter().flatten()).collect();
    let viewport = Viewport { width: 66, height: 66 };
    let naive = screen_clip::by_size(&triangles, 220, [0, 0, 66 * 256, 66 * 256]);
    hits(
        "13  Only what is too large is clipped at the border of the screen",
        "clipped by size",
        &triangles,
        [66, 66],
        3,
        coverage_counts(&naive, viewport),
        "The corner that clipping makes is rounded to 1/256 px and is not on the neighbour's edge: a T-junction.",
    )
}

/// Row 33: anti-aliased edges inside of a mesh.
pub(crate) fn alpha_inside() -> Canvas {
    let at = |x: i32, y: i32| [x * 256 + 77, y * 256 + 30];
    let corner = |i: i32, j: i32| at(3 + i * 9 + j, 3 + j * 9 - i);
    let triangles: Vec<Triangle> = (0..4)
        .flat_map(|n| {
            let (i, j) = (n % 2, n / 2);
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let viewport = Viewport { width: 25, height: 25 };
    let (front, back) = ([224.0, 168.0, 80.0], [16.0, 20.0, 40.0]);
    let mixed = |left: f64| [0, 1, 2].map(|k| (back[k] * left + front[k] * (1.0_f64 - left)).round() as u8);
    let covered = |hits: Vec<u32>| {
        Picture::new(25, hits.into_iter().map(|hits| mixed(if hits == 0 { 1.0 } else { 0.0 })).collect())
    };
    let left = alpha_edges::background_left(&triangles, viewport);
    Strip {
        title: "33  Edges blended one triangle after the other let the background through",
        naive_method: "alpha on every edge",
        naive: Picture::new(25, left.into_iter().map(mixed).collect()),
        topleft: covered(drawn::hits(&triangles, 25, 25)),
        reference: covered(coverage_counts(&triangles, viewport)),
        zoom: 8,
        times: 2,
        unit: "code",
        notes: vec![
            "Eight triangles of one colour. Inside, the difference is the leak: c (1 - c) of the background, up to a quarter."
                .into(),
            "At the outline it is what anti-aliasing should do; topleft does not smooth outlines yet.".into(),
        ],
    }
    .draw()
}

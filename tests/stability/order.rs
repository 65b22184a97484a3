//! Rows 31 to 34: what must not depend on an order: of strips, of vertices, of triangles.

use std::cell::Cell;
use std::collections::BTreeMap;

use embedded_graphics::prelude::*;
use proptest::prelude::*;
use reference::naive::screen_clip::{Valued, to_rows};
use reference::naive::{alpha_edges, plane, triangles};
use reference::raster::covers;
use reference::setup::{Triangle, area2};
use reference::transform::Viewport;
use reference::varying::linear;
use topleft::{
    Attribute, Cull, Depth16, DrawList, Length, ListTriangle, Mesh, NoDepth, Orthographic, Pose, Spans,
};

use crate::carried::{SIDE, Value, in_strips};
use crate::figure::{grouped, unsigned};
use crate::support::check;
use crate::support::counter::{Add, Hits};
use crate::support::frame::{Frame, Strips};
use crate::support::winding::hits;

/// Bits of a value at each pixel, by row and column.
type Values = BTreeMap<(i32, i32), u64>;

/// Corners on and round a target of 64 x 64, and a grey of 255 at each.
fn shaded() -> impl Strategy<Value = Valued> {
    let corner = || prop::array::uniform2(-20 * 256..84 * 256_i32);
    (prop::array::uniform3(corner()), prop::array::uniform3(0.0..255.0))
        .prop_filter("it has an area", |(triangle, _)| area2(*triangle) != 0)
}

/// What the library gives the target by strips of each height.
fn ours<const N: usize>((triangle, greys): Valued, heights: [i32; N]) -> [Frame<Value>; N] {
    // A position is 1/256 px.
    let corners = triangle.map(|corner| corner.map(|c| (c - SIDE * 128) as i16));
    in_strips(corners, 128, [Length::ZERO; 2], greys.map(Attribute::from_num), heights)
}

/// What a naive method gives the pixels that a triangle covers.
fn by(
    value: fn(Triangle, [f64; 3], i64, i64) -> f64,
    parts: &[Valued],
    rows: core::ops::Range<i32>,
    into: &mut Values,
) {
    for &(triangle, greys) in parts {
        for (y, x) in rows.clone().flat_map(|y| (0..SIDE).map(move |x| (y, x))) {
            if covers(triangle, x.into(), y.into()) {
                into.insert((y, x), value(triangle, greys, x.into(), y.into()).to_bits());
            }
        }
    }
}

/// Triangles drawn whole and in strips: pixels of strips that set up their own parts, how many of these are covered or
/// coloured by more than 1/16 otherwise, and how many of the library's bits differ.
pub(crate) fn strips() -> [u64; 3] {
    let counts = [const { Cell::new(0) }; 3];
    let add = |which: usize, count: usize| counts[which].set(counts[which].get() + count as u64);
    check(1_000, &(shaded(), 1..24_i32), |(whole, height)| {
        let (mut exact, mut naive) = (Values::new(), Values::new());
        by(linear, &[whole], 0..SIDE, &mut exact);
        for top in (0..SIDE).step_by(height as usize) {
            let rows = top..(top + height).min(SIDE);
            by(linear, &to_rows(whole, rows.clone()), rows, &mut naive);
        }
        let off = |(at, bits): (&(i32, i32), &u64)| {
            naive.get(at).is_none_or(|other| (f64::from_bits(*bits) - f64::from_bits(*other)).abs() > 0.0625)
        };
        add(0, exact.len());
        let wrong = exact.iter().filter(|&pixel| off(pixel)).count();
        add(1, wrong + naive.keys().filter(|&at| !exact.contains_key(at)).count());
        let [frame, strips] = ours(whole, [SIDE, height]);
        let drawn = frame.colours.iter().filter(|value| value.0.is_some()).count();
        add(2, frame.colours.iter().zip(&strips.colours).filter(|(one, other)| one != other).count());
        if drawn != exact.len() {
            return Err(format!("{drawn} px are drawn of {}", exact.len()));
        }
        strips.same("strips", &frame)
    });
    counts.map(|count| count.get())
}

// Red when planes are anchored in the window (`pipeline::draw`), or an edge starts anew in a strip (`Edge::skip`).
#[test]
fn row_31_strips_that_set_up_their_own_part_have_seams() {
    let [pixels, naive, ours] = strips();
    println!(
        "row 31, clipped to strips: {} of {} px other than in the frame; topleft {ours}",
        grouped(naive),
        grouped(pixels)
    );
    // A new corner is off by up to 1/512 px: by 1/16 of a code where the grey changes by 32 codes a pixel or more, as on
    // the thin ones of random triangles, and across a pixel's centre for some of the edges.
    assert!(naive > 100);
    assert_eq!(ours, 0);
}

/// The orders of a triangle's vertices: pixels, how many of them have more than one value in `f32`, and in the library.
pub(crate) fn vertex_orders() -> [u64; 3] {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let counts = [const { Cell::new(0) }; 3];
    check(300, &shaded(), |(triangle, greys)| {
        let frames = ORDERS.map(|order| {
            let other: Valued = (order.map(|i| triangle[i]), order.map(|i| greys[i]));
            let (mut naive, mut shown) = (Values::new(), Values::new());
            by(plane::from_the_given_vertex, &[other], 0..SIDE, &mut naive);
            let [frame] = ours(other, [SIDE]);
            for (at, value) in frame.colours.iter().enumerate() {
                let at = (at as i32 / SIDE, at as i32 % SIDE);
                shown.extend(value.0.map(|value| (at, u64::from(value.cast_unsigned()))));
            }
            [naive, shown]
        });
        let [first, ..] = &frames;
        let many = |which: usize| {
            let same =
                |at: &(i32, i32)| frames.iter().all(|frame| frame[which].get(at) == first[which].get(at));
            first[which].keys().filter(|&at| !same(at)).count() as u64
        };
        for (count, more) in counts.iter().zip([first[1].len() as u64, many(0), many(1)]) {
            count.set(count.get() + more);
        }
        if many(1) == 0 { Ok(()) } else { Err("the value depends on the order of the vertices".into()) }
    });
    counts.map(|count| count.get())
}

// Red when a face keeps the order of its corners: `canonical` in src/setup.rs.
#[test]
fn row_32_planes_depend_on_the_order_of_the_vertices() {
    let [pixels, naive, ours] = vertex_orders();
    println!(
        "row 32, f32 from the given vertex: {} of {} px have several values; topleft {ours}",
        grouped(naive),
        grouped(pixels)
    );
    // Sums from three different corners, each rounded to 24 bits: they are the same by accident only.
    assert!(naive * 2 > pixels);
    assert_eq!(ours, 0);
}

/// Fans that cover all of a target: the most of the background that blended edges leave, and how many pixels the library
/// does not cover once.
pub(crate) fn alpha_edges_inside() -> (f64, u64) {
    const VIEW: Viewport = Viewport { width: 40, height: 40 };
    let (most, wrong) = (Cell::new(0.0_f64), Cell::new(0));
    check(300, &([0..40 * 256_i32, 0..40 * 256_i32], 3..12_u32, 0.0..1.0), |(hub, spokes, phase)| {
        let fan = triangles::fan(hub, &triangles::ring(hub, 150.0, spokes, phase, 1));
        let left = alpha_edges::background_left(&fan, VIEW);
        most.set(left.into_iter().fold(most.get(), f64::max));
        let ours = unsigned(&hits::<Spans>(fan.iter().copied(), 40, 40).all);
        wrong.set(wrong.get() + ours.iter().filter(|&&hits| hits != 1).count() as u64);
        if wrong.get() == 0 { Ok(()) } else { Err("the fan does not cover the target once".into()) }
    });
    (most.get(), wrong.get())
}

// Red when the edge between two triangles is not one's alone. Smoothing outlines only is open: the library has no blending.
#[test]
fn row_33_blended_edges_let_the_background_through_a_mesh() {
    let (naive, ours) = alpha_edges_inside();
    println!(
        "row 33, alpha on every edge: {naive:.3} of the background shows inside a mesh; topleft: {ours} px"
    );
    // c (1 - c) is a quarter on a centre on the edge, and what is left of three or more triangles at the hub is more.
    assert!(naive > 0.24);
    assert_eq!(ours, 0);
}

/// Shaded pixels of layers over a target of 32 x 32, drawn in this order, by how far behind the first place they are.
fn shaded_pixels<D: Strips>(layers: impl IntoIterator<Item = i32>) -> u64 {
    const POSITIONS: [[i16; 3]; 4] =
        [[-32_767, -32_767, 0], [32_767, -32_767, 0], [32_767, 32_767, 0], [-32_767, 32_767, 0]];
    let camera = Orthographic::new(Size::new(32, 32), 2.0, 1.0..9.0);
    let mesh = Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 3]])
        .expect("a mesh")
        .with_box([Length::ZERO; 3], Length::lit("1.5"));
    let (mut words, mut triangles) = (vec![0; 200 * 4 * 3], vec![ListTriangle::EMPTY; 400]);
    let mut list = DrawList::<Hits, D, Spans>::with_traversal(&mut words, &mut triangles);
    list.set_cull(Cull::Back);
    for behind in layers {
        let pose =
            Pose::new().at([Length::ZERO, Length::ZERO, Length::from_bits(-(2 << 16) - (behind << 10))]);
        list.draw(&camera, &mesh, &pose, &Add(1)).expect("the list is long enough");
    }
    let (mut cells, mut depths) = (vec![Hits(0); 32 * 32], vec![0; 32 * 32]);
    let mut strip = D::strip(32, &mut cells, &mut depths);
    strip.clear();
    list.render(0..32, &mut strip);
    drop(strip);
    cells.iter().map(|hits| u64::from(hits.0.unsigned_abs())).sum()
}

// Red when hidden pixels are shaded (`cover`), or a triangle's pixels cost more than once.
#[test]
fn row_34_layers_are_shaded_as_often_as_they_are_seen() {
    const ONE: u64 = 32 * 32;
    let [painter, back, front] = [
        shaded_pixels::<NoDepth>((0..200).rev()),
        shaded_pixels::<Depth16>((0..200).rev()),
        shaded_pixels::<Depth16>(0..200),
    ];
    println!(
        "row 34, 200 layers, painter's order: {} px shaded; topleft with depth, front to back: {}",
        grouped(painter),
        grouped(front)
    );
    assert_eq!(painter, 200 * ONE);
    // Each layer is nearer than the last: linear in what is covered, and no more than that.
    assert_eq!(back, 200 * ONE);
    assert_eq!(front, ONE);
    // In any order a layer is shaded where it is nearer than all before it, and nowhere else.
    check(30, &(Just((0..200).collect::<Vec<i32>>()).prop_shuffle(), 1..=200_usize), |(order, count)| {
        let order = &order[..count];
        let nearer = (0..count).filter(|&i| order[..i].iter().all(|&before| before > order[i])).count();
        let shaded = shaded_pixels::<Depth16>(order.iter().copied());
        let painted = shaded_pixels::<NoDepth>(order.iter().copied());
        if [shaded, painted] == [nearer as u64 * ONE, count as u64 * ONE] {
            Ok(())
        } else {
            Err(format!("{shaded} px are shaded of {nearer} layers that are nearer, {painted} without depth"))
        }
    });
}

//! Meshes through the whole path: planar ones, closed ones and convex ones, whole, near-clipped and guard-clipped.

use std::collections::HashMap;
use std::ops::Range;

use embedded_graphics::prelude::Size;
use proptest::collection::vec;
use proptest::prelude::*;
use scenes::mesh::{CUBE, FLOOR, GRID240, ICOSPHERE, ICOSPHERE_FINE, TEAPOT, TORUS_KNOT};
use topleft::{Length, Mesh, Orthographic, Perspective, Pose, Turn};

use crate::support::counter::{ALL, BACKS, Drawn, FRONTS, WINDING, draw};
use crate::support::polygons::polygons;
use crate::support::winding::{Edge, winding_of};
use crate::support::{check, same};

/// A point of the scene.
type Eye = [f32; 3];

const SIZE: Size = Size::new(120, 90);
const WIDTH: usize = 120;
const HEIGHT: usize = 90;

/// The directed edges of a mesh that no other face runs back along, as vertices: none, where it is closed.
///
/// Vertices that stand in one place are one.
fn boundary(mesh: &Mesh<'_>) -> Vec<[u16; 2]> {
    let mut first = HashMap::new();
    let mut name = |vertex: u16| *first.entry(mesh.positions()[usize::from(vertex)]).or_insert(vertex);
    let mut edges: HashMap<[u16; 2], i32> = HashMap::new();
    for face in mesh.faces() {
        let [a, b, c] = face.map(&mut name);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            if from < to {
                *edges.entry([from, to]).or_default() += 1;
            } else if to < from {
                *edges.entry([to, from]).or_default() -= 1;
            }
        }
    }
    let directed = |([from, to], count): ([u16; 2], i32)| {
        let edge = if count > 0 { [from, to] } else { [to, from] };
        std::iter::repeat_n(edge, count.unsigned_abs() as usize)
    };
    edges.into_iter().flat_map(directed).collect()
}

/// The boundary where the list's vertices, which nothing has clipped, put it on the screen.
fn seen_boundary(mesh: &Mesh<'_>, drawn: &Drawn) -> Vec<Edge> {
    assert_eq!(drawn.clipped, 0, "only vertices that are not clipped can be read");
    let at = |vertex: u16| [0, 1].map(|axis| drawn.words[usize::from(vertex) * 2 + axis].cast_signed());
    boundary(mesh).into_iter().map(|edge| edge.map(at)).collect()
}

fn camera(eye: Eye, target: Eye, degrees: i32, depth: Range<f32>) -> Perspective {
    let camera = Perspective::new(SIZE, Turn::from_degrees(degrees), depth).look_at(eye, target);
    assert!(camera.is_valid());
    camera
}

/// What is left of directed edges when those that run both ways are taken out.
fn uncancelled(edges: &[Edge]) -> Vec<Edge> {
    let mut counts: HashMap<Edge, i32> = HashMap::new();
    for &[from, to] in edges {
        if from < to {
            *counts.entry([from, to]).or_default() += 1;
        } else if to < from {
            *counts.entry([to, from]).or_default() -= 1;
        }
    }
    counts.into_iter().filter(|&(_, count)| count != 0).map(|(edge, _)| edge).collect()
}

/// Eyes on circles round the origin, low and high.
fn orbit(distance: f32) -> impl Iterator<Item = Eye> {
    (0..24_u8).map(move |i| {
        let (yaw, pitch) = (f32::from(i) * 0.2618 + 0.05, (f32::from(i % 5) - 2.0) * 0.5 + 0.02);
        [yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos()].map(|c| c * distance)
    })
}

/// A plane of quads, cut along either diagonal, whose inner points are moved by less than half of a quad.
#[derive(Clone, Debug)]
struct Sheet {
    positions: Vec<[i16; 3]>,
    faces: Vec<[u16; 3]>,
}

/// A sheet over 240 x 240 steps of `step` / 256, round the origin.
fn sheets(step: i16) -> impl Strategy<Value = Sheet> {
    (1..12_u16, 1..12_u16).prop_flat_map(move |(columns, rows)| {
        let points = usize::from((columns + 1) * (rows + 1));
        let quads = usize::from(columns * rows);
        (vec(any::<[i16; 2]>(), points), vec(any::<bool>(), quads)).prop_map(move |(moves, diagonals)| {
            let place = |i: u16, count: u16, moved: i16| {
                let quad = 240 * 256 / i32::from(count);
                let inner = i != 0 && i != count;
                // Less than a quarter of a quad either way: no two edges can cross.
                let moved = if inner { i32::from(moved) * (quad / 4 - 1) / 32768 } else { 0 };
                let at = i32::from(i) * 240 * 256 / i32::from(count) + moved - 120 * 256;
                ((at + 32768).div_euclid(i32::from(step)) * i32::from(step) - 32768) as i16
            };
            let stride = columns + 1;
            let positions = (0..=rows).flat_map(|y| (0..=columns).map(move |x| (x, y)));
            let positions = positions.zip(moves);
            let positions =
                positions.map(|((x, y), [mx, my])| [place(x, columns, mx), -place(y, rows, my), 0]);
            let corner = |x: u16, y: u16| y * stride + x;
            let quads = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).zip(diagonals);
            let faces = quads.flat_map(|((x, y), falling)| {
                let [a, b, c, d] = [corner(x, y), corner(x, y + 1), corner(x + 1, y + 1), corner(x + 1, y)];
                if falling { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
            });
            Sheet { positions: positions.collect(), faces: faces.collect() }
        })
    })
}

// Red when a mesh's shared vertices are snapped differently for two faces, or a pixel on an edge is hit twice.
#[test]
fn sheets_without_folds_hit_each_pixel_of_the_screen_once() {
    let size = Size::new(240, 240);
    let camera = Orthographic::new(size, 240.0, -1.0..1.0);
    for step in [1, 16, 128] {
        check(100, &sheets(step), |sheet| {
            let mesh = Mesh::new(&sheet.positions, &sheet.faces).map_err(|error| format!("{error:?}"))?;
            let mesh = mesh.with_box([Length::ZERO; 3], Length::lit("128"));
            same("hits", 240, &draw(&camera, &mesh, &Pose::new(), ALL).hits, &[1; 240 * 240])
        });
    }
}

// Red when the frame is moved by a pixel, `centred` in src/transform.rs, or one of the grid's 800 edges is hit twice.
#[test]
fn grid240_hits_each_of_57600_pixels_once() {
    let camera = Orthographic::new(Size::new(240, 240), 240.0, -1.0..1.0);
    let hits = draw(&camera, &GRID240, &Pose::new(), ALL).hits;
    same("hits", 240, &hits, &[1; 57_600]).unwrap();
}

// Red when a planar mesh in perspective is hit twice at a clipped edge: `polygon` in src/list/draw.rs, or src/clip.rs.
#[test]
fn a_floor_under_the_viewer_is_hit_once_up_to_its_border() {
    let mut clipped = 0;
    for eye in orbit(1.2) {
        let camera = camera([eye[0], eye[1].abs() + 0.1, eye[2]], [0.0, -0.2, 0.0], 70, 0.25..20.0);
        let drawn = draw(&camera, &FLOOR, &Pose::new(), ALL);
        clipped += drawn.clipped;
        let expected = winding_of(&polygons(&camera, &FLOOR, &Pose::new()).edges(), WIDTH, HEIGHT);
        assert!(expected.iter().all(|&hits| hits == 0 || hits == 1));
        same(&format!("eye {eye:?}"), WIDTH, &drawn.hits, &expected).unwrap();
    }
    println!("{clipped} faces clipped");
    assert!(clipped > 100);
}

/// The first three are convex.
const CLOSED: [(&str, Mesh<'static>); 5] = [
    ("cube", CUBE),
    ("icosphere", ICOSPHERE),
    ("fine icosphere", ICOSPHERE_FINE),
    ("torus knot", TORUS_KNOT),
    ("teapot", TEAPOT),
];

// Red when a mesh of scenes/ loses a face, or one is turned over: the tests below stand on it.
#[test]
fn the_meshes_that_should_be_closed_are() {
    for (name, mesh) in CLOSED {
        assert_eq!(boundary(&mesh), [[0; 2]; 0], "{name} has a border");
    }
}

// Red when one triangle in a thousand loses a pixel, or culling disagrees with coverage: `Cull::leaves_out`, `area2`.
#[test]
fn closed_meshes_wind_round_no_pixel() {
    let mut pixels = 0;
    for (name, mesh) in CLOSED {
        for eye in orbit(3.5) {
            let ours = camera(eye, [0.1, 0.0, -0.1], 45, 1.0..8.0);
            let hits = draw(&ours, &mesh, &Pose::new(), WINDING).hits;
            same(&format!("{name} from {eye:?}"), WIDTH, &hits, &[0; WIDTH * HEIGHT]).unwrap();
            pixels += draw(&ours, &mesh, &Pose::new(), ALL).hits.iter().sum::<i32>();
        }
    }
    println!("{pixels} hits");
}

// Red as above; and when the border of a mesh is drawn elsewhere than its vertices say.
#[test]
fn open_meshes_wind_round_pixels_as_their_border_does() {
    let torn = Mesh::new(ICOSPHERE.positions(), &ICOSPHERE.faces()[..200]).expect("some of its faces");
    let mut border = 0;
    for (name, mesh) in [("floor", FLOOR), ("torn icosphere", torn)] {
        for eye in orbit(3.5) {
            let ours = camera([eye[0], eye[1] + 0.3, eye[2]], [0.0; 3], 60, 0.5..9.0);
            let drawn = draw(&ours, &mesh, &Pose::new(), WINDING);
            let edges = seen_boundary(&mesh, &drawn);
            border += edges.len();
            let expected = winding_of(&edges, WIDTH, HEIGHT);
            same(&format!("{name} from {eye:?}"), WIDTH, &drawn.hits, &expected).unwrap();
        }
    }
    println!("{border} edges on borders");
}

// Red when a neighbour clips its edge at the guard rectangle to another point: an order of ends, in `cut`, that
// follows the face, once the fraction is short enough to show it.
#[test]
fn closed_meshes_that_leave_the_guard_rectangle_wind_round_no_pixel() {
    let mut clipped = 0;
    for (name, mesh) in CLOSED {
        for eye in orbit(1.35) {
            // So large that most of it is off the screen, and so far that none of it is nearer than the near plane.
            let eye = eye.map(|c| c * 32.0);
            let ours = camera(eye, [5.0, -3.0, 2.0], 4, 0.01..200.0);
            let pose = Pose::new().scaled(Length::lit("24"));
            let drawn = draw(&ours, &mesh, &pose, WINDING);
            clipped += drawn.clipped;
            same(&format!("{name} from {eye:?}"), WIDTH, &drawn.hits, &[0; WIDTH * HEIGHT]).unwrap();
        }
    }
    println!("{clipped} faces clipped");
    assert!(clipped > 1_000);
}

// Red when a face that crosses the near plane is dropped, or its new vertices differ from its neighbour's.
#[test]
fn from_inside_a_convex_mesh_every_pixel_is_a_back() {
    let mut clipped = 0;
    for (name, mesh) in &CLOSED[..3] {
        for eye in orbit(0.4) {
            let ours = camera(eye, [0.0, 0.1, 0.0], 80, 0.05..4.0);
            let drawn = draw(&ours, mesh, &Pose::new(), WINDING);
            clipped += drawn.clipped;
            let what = format!("{name} from {eye:?}");
            same(&what, WIDTH, &drawn.hits, &[-1; WIDTH * HEIGHT]).unwrap();
            let all = draw(&ours, mesh, &Pose::new(), ALL).hits;
            same(&what, WIDTH, &all, &[1; WIDTH * HEIGHT]).unwrap();
        }
    }
    println!("{clipped} faces clipped");
    assert!(clipped > 1_000);
}

// Red as above: two faces of an edge must cut it at the same point, so that all edges cancel but those of the cut, and
// the mesh winds round the pixels of the cut and no others.
#[test]
fn closed_meshes_cut_by_the_near_and_far_planes_wind_round_the_cut() {
    let (mut clipped, mut edges, mut pixels) = (0, 0, 0);
    for (name, mesh) in CLOSED {
        for (depth, distance) in [(1.0..6.0, 1.6), (1.5..3.0, 2.9), (0.3..6.0, 0.9)] {
            for eye in orbit(distance).step_by(3) {
                let what = format!("{name} from {eye:?}");
                let ours = camera(eye, [0.1, 0.0, -0.1], 60, depth.clone());
                let polygons = polygons(&ours, &mesh, &Pose::new());
                let edges_left = polygons.edges();
                let cut = uncancelled(&edges_left);
                let torn = cut.iter().find(|edge| edge.iter().any(|end| !polygons.made.contains(end)));
                assert_eq!(torn, None, "{what}: an edge is left open");
                let drawn = draw(&ours, &mesh, &Pose::new(), WINDING);
                let expected = winding_of(&edges_left, WIDTH, HEIGHT);
                same(&what, WIDTH, &drawn.hits, &expected).unwrap();
                (clipped, edges) = (clipped + drawn.clipped / 2, edges + cut.len());
                pixels += expected.iter().filter(|&&winding| winding != 0).count();
            }
        }
    }
    println!("{clipped} faces clipped, {edges} edges of cuts, {pixels} pixels in cuts");
    assert!(clipped > 5_000 && pixels > 10_000);
}

// Red when culling takes one of two faces that share a pixel's centre and leaves neither, or both.
#[test]
fn convex_meshes_with_culling_hit_each_pixel_once() {
    for (name, mesh) in &CLOSED[..3] {
        for distance in [1.9, 2.5, 4.0, 12.0, 40.0] {
            for eye in orbit(distance) {
                let ours = camera(eye, [0.05, 0.0, 0.0], 45, 0.1..60.0);
                let what = format!("{name} from {eye:?}");
                let pose = Pose::new();
                let [fronts, backs, all] =
                    [FRONTS, BACKS, ALL].map(|passes| draw(&ours, mesh, &pose, passes).hits);
                let union: Vec<i32> = all.iter().map(|&hits| i32::from(hits != 0)).collect();
                same(&format!("fronts of {what}"), WIDTH, &fronts, &union).unwrap();
                same(&format!("backs of {what}"), WIDTH, &backs, &union).unwrap();
            }
        }
    }
}

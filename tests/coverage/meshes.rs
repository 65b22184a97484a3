//! Meshes through the whole path: planar ones, closed ones and convex ones, whole, near-clipped and guard-clipped.

use std::collections::HashMap;

use embedded_graphics::prelude::Size;
use proptest::collection::vec;
use proptest::prelude::*;
use reference::image::Image;
use reference::matrix::Vec3;
use reference::shade::Look;
use reference::transform::{look_at, perspective};
use scenes::mesh::{CUBE, FLOOR, GRID240, ICOSPHERE, ICOSPHERE_FINE, TEAPOT, TORUS_KNOT};
use topleft::{Length, Mesh, Orthographic, Perspective, Pose, Turn};

use crate::support::counter::{ALL, BACKS, Drawn, FRONTS, WINDING, draw};
use crate::support::{check, same};
use crate::winding::{Edge, winding_of};

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

/// A camera of the library, and the same one of the reference as a matrix.
fn camera(
    eye: Vec3,
    target: Vec3,
    degrees: i32,
    [near, far]: [f64; 2],
) -> (Perspective, reference::matrix::Matrix) {
    let single = |point: Vec3| point.map(|c| c as f32);
    let ours = Perspective::new(SIZE, Turn::from_degrees(degrees), near as f32..far as f32)
        .look_at(single(eye), single(target));
    assert!(ours.is_valid());
    let aspect = f64::from(SIZE.width) / f64::from(SIZE.height);
    let projection = perspective(f64::from(degrees).to_radians(), aspect, near, far);
    (ours, look_at(eye, target, [0.0, 1.0, 0.0]).then(&projection))
}

/// Front hits minus back hits of the reference, which clips and snaps on its own.
fn reference_winding(mesh: &Mesh<'_>, model_to_clip: reference::matrix::Matrix) -> Vec<i32> {
    let viewport = reference::transform::Viewport { width: SIZE.width, height: SIZE.height };
    let view = reference::render::View { model_to_clip, guard: None, first_face: 0 };
    let writes = |cull| {
        let mut image = Image::new(viewport, [0.0; 3]);
        let look = Look { cull, depth: false, ..Look::flat([255; 3]) };
        reference::render::draw(&mut image, mesh, &view, &look).expect("a flat look needs no attributes");
        image.pixels().iter().map(|pixel| pixel.writes.cast_signed()).collect::<Vec<_>>()
    };
    let (fronts, backs) = (writes(reference::setup::Cull::Back), writes(reference::setup::Cull::Front));
    fronts.iter().zip(backs).map(|(front, back)| front - back).collect()
}

/// Eyes on circles round the origin, low and high.
fn orbit(distance: f64) -> impl Iterator<Item = Vec3> {
    (0..24).map(move |i| {
        let (yaw, pitch) = (f64::from(i) * 0.2618 + 0.05, f64::from(i % 5 - 2) * 0.5 + 0.02);
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

// Red when the scene's transform moves the border of the grid by a step: the rounding of `Projection::project`.
#[test]
fn grid240_hits_each_of_57600_pixels_once() {
    let camera = Orthographic::new(Size::new(240, 240), 240.0, -1.0..1.0);
    let hits = draw(&camera, &GRID240, &Pose::new(), ALL).hits;
    same("hits", 240, &hits, &[1; 57_600]).unwrap();
    // The scene's list says the same of strips and of the boxes' walk.
    let scene = scenes::by_name("grid240").expect("the scene of the grid");
    assert!(scene.objects.iter().all(|object| object.cull == topleft::Cull::None));
}

// Red when a planar mesh in perspective is hit twice at a clipped edge: `polygon` in src/list/draw.rs, or src/clip.rs.
#[test]
fn a_floor_under_the_viewer_is_hit_once_up_to_its_border() {
    let mut clipped = 0;
    for eye in orbit(1.2) {
        let eye = [eye[0], eye[1].abs() + 0.1, eye[2]];
        let (ours, theirs) = camera(eye, [0.0, -0.2, 0.0], 70, [0.25, 20.0]);
        let drawn = draw(&ours, &FLOOR, &Pose::new(), ALL);
        clipped += drawn.clipped;
        near_enough(&format!("eye {eye:?}"), &drawn.hits, &reference_winding(&FLOOR, theirs)).unwrap();
    }
    println!("{clipped} faces clipped");
    assert!(clipped > 100);
}

/// Equality, but for pixels on the outline of what is clipped: there the two may differ by the snapping of the new
/// vertices, and our value must be one that the reference has in a neighbouring pixel.
fn near_enough(what: &str, got: &[i32], expected: &[i32]) -> Result<(), String> {
    for (i, value) in got.iter().enumerate() {
        let (x, y) = (i % WIDTH, i / WIDTH);
        let rows = y.saturating_sub(1)..(y + 2).min(HEIGHT);
        let mut neighbours = rows
            .flat_map(|y| (x.saturating_sub(1)..(x + 2).min(WIDTH)).map(move |x| expected[y * WIDTH + x]));
        if !neighbours.any(|neighbour| neighbour == *value) {
            return Err(format!("{what}: {value} at column {x}, row {y}, where {} is right", expected[i]));
        }
    }
    let differing = got.iter().zip(expected).filter(|(a, b)| a != b).count();
    if differing > 8 { Err(format!("{what}: {differing} pixels differ")) } else { Ok(()) }
}

const CLOSED: [(&str, Mesh<'static>); 4] = [
    ("cube", CUBE),
    ("icosphere", ICOSPHERE),
    ("fine icosphere", ICOSPHERE_FINE),
    ("torus knot", TORUS_KNOT),
];

#[test]
fn the_meshes_that_should_be_closed_are() {
    for (name, mesh) in CLOSED {
        assert_eq!(boundary(&mesh), [[0; 2]; 0], "{name} has a border");
    }
    println!("teapot: {} edges on its border", boundary(&TEAPOT).len());
}

// Red when one triangle in a thousand loses a pixel, or culling disagrees with coverage: `Cull::leaves_out`, `area2`.
#[test]
fn closed_meshes_wind_round_no_pixel() {
    let mut pixels = 0;
    for (name, mesh) in CLOSED {
        for eye in orbit(3.5) {
            let (ours, _) = camera(eye, [0.1, 0.0, -0.1], 45, [1.0, 8.0]);
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
    let mut border = 0;
    for (name, mesh) in [("teapot", TEAPOT), ("floor", FLOOR)] {
        for eye in orbit(3.5) {
            let eye = [eye[0], eye[1] + 0.3, eye[2]];
            let (ours, _) = camera(eye, [0.0, 0.0, 0.0], 60, [0.5, 9.0]);
            let drawn = draw(&ours, &mesh, &Pose::new(), WINDING);
            let edges = seen_boundary(&mesh, &drawn);
            border += edges.len();
            let expected = winding_of(&edges, WIDTH, HEIGHT);
            same(&format!("{name} from {eye:?}"), WIDTH, &drawn.hits, &expected).unwrap();
        }
    }
    println!("{border} edges on borders");
}

// Red when two neighbours clip their edge at the guard rectangle to different points: the order of ends in `cut`.
#[test]
fn closed_meshes_that_leave_the_guard_rectangle_wind_round_no_pixel() {
    let mut clipped = 0;
    for (name, mesh) in CLOSED {
        for eye in orbit(1.35) {
            // So large that most of it is off the screen, and so far that none of it is nearer than the near plane.
            let eye = eye.map(|c| c * 32.0);
            let (ours, _) = camera(eye, [5.0, -3.0, 2.0], 4, [0.01, 200.0]);
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
            let (ours, _) = camera(eye, [0.0, 0.1, 0.0], 80, [0.05, 4.0]);
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

// Red as above: where the near plane cuts a closed mesh open, it winds round the pixels of the cut and no others.
#[test]
fn closed_meshes_cut_by_the_near_and_far_planes_wind_round_the_cut() {
    let mut clipped = 0;
    for (name, mesh) in CLOSED {
        for (planes, distance) in [([1.0, 6.0], 1.6), ([1.5, 3.0], 2.9), ([0.3, 6.0], 0.9)] {
            for eye in orbit(distance) {
                let (ours, theirs) = camera(eye, [0.1, 0.0, -0.1], 60, planes);
                let drawn = draw(&ours, &mesh, &Pose::new(), WINDING);
                clipped += drawn.clipped;
                let expected = reference_winding(&mesh, theirs);
                near_enough(&format!("{name} from {eye:?}"), &drawn.hits, &expected).unwrap();
            }
        }
    }
    println!("{clipped} faces clipped");
    assert!(clipped > 10_000);
}

// Red when culling takes one of two faces that share a pixel's centre and leaves neither, or both.
#[test]
fn convex_meshes_with_culling_hit_each_pixel_once() {
    for (name, mesh) in &CLOSED[..3] {
        for distance in [1.9, 2.5, 4.0, 12.0, 40.0] {
            for eye in orbit(distance) {
                let (ours, _) = camera(eye, [0.05, 0.0, 0.0], 45, [0.1, 60.0]);
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

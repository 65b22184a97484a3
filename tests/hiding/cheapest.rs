//! What [`Hiding::cheapest`] says is safe, against what each pixel shows with a buffer and mesh by mesh; and which buffer.

use std::cell::Cell;

use embedded_graphics::prelude::Size;
use proptest::collection::vec;
use proptest::prelude::*;
use topleft::{
    Camera, Depth16, DrawList, Flat, Gouraud, Hiding, Length, ListTriangle, Material, Matrix, MatrixCamera,
    Mesh, NoDepth, Orthographic, Painter, Perspective, Pose, Turn,
};

use crate::solids::{Placed, placed, poses};
use crate::support::check;
use crate::support::frame::{Frame, Strips, rendered};

const SIDE: usize = 64;
const SIZE: Size = Size::new(64, 64);
const PERCENT: Length = Length::lit("0.01");

/// Meshes in their places, each in its own colour.
struct Things<'t>(Vec<(Mesh<'t>, Pose)>);

impl Things<'_> {
    fn cheapest(&self, camera: &impl Camera) -> Hiding {
        let things: Vec<(&Mesh<'_>, &Pose)> = self.0.iter().map(|(mesh, pose)| (mesh, pose)).collect();
        Hiding::cheapest(camera, &things, PERCENT)
    }

    /// The frame of some of them, from the last to the first, by two shaders in turn.
    fn drawn<D: Strips>(&self, camera: &impl Camera, which: impl Fn(usize) -> bool) -> Frame {
        let (mut words, mut triangles) = (vec![0; 4000], vec![ListTriangle::EMPTY; 500]);
        let mut list = DrawList::<u16, D>::new(&mut words, &mut triangles);
        for (place, (mesh, pose)) in self.0.iter().enumerate().rev().filter(|(place, _)| which(*place)) {
            let paint = Material::Colour([8 * (place as u8 + 1); 3]);
            let result = if place % 2 == 0 {
                list.draw(camera, mesh, pose, &Flat::new(paint))
            } else {
                list.draw(camera, mesh, pose, &Gouraud::unlit(&paint))
            };
            result.expect("it is long enough");
        }
        D::sort(&mut list);
        rendered(&list, SIDE, 0..SIDE as i32, SIDE, 0)
    }

    /// `1 - z / w` of each mesh's vertices, from the least to the greatest, to the rounding of a length.
    fn depths(&self, camera: &impl Camera) -> Vec<[f64; 2]> {
        let [z, w] = [2, 3].map(|row| camera.matrix().row(row).map(f64::from));
        let range = |(mesh, pose): &(Mesh<'_>, Pose)| {
            let depth = |position: &[i16; 3]| {
                let at = pose.apply(position.map(|c| Length::from_bits(i32::from(c) * 2)));
                let [x, y, depth] = at.map(Length::to_num::<f64>);
                let dot = |row: [f64; 4]| row[0] * x + row[1] * y + row[2] * depth + row[3];
                1.0 - dot(z) / dot(w)
            };
            let depths = mesh.positions().iter().map(depth);
            depths.fold([f64::MAX, f64::MIN], |[least, most], depth| [least.min(depth), most.max(depth)])
        };
        self.0.iter().map(range).collect()
    }
}

/// How many scenes, and pixels in which several meshes meet, a test has seen.
#[derive(Default)]
struct Seen {
    painted: Cell<usize>,
    met: Cell<usize>,
    against_depth: Cell<usize>,
}

fn add(count: &Cell<usize>, more: usize) {
    count.set(count.get() + more);
}

/// Where the answer is painter's order, every pixel shows the nearest of the meshes that cover it, each drawn alone; and
/// what a depth buffer shows, where its codes tell the meshes apart.
fn is_right(things: &Things<'_>, camera: &impl Camera, seen: &Seen) -> Result<(), String> {
    if things.cheapest(camera) != Hiding::Painter {
        return Ok(());
    }
    add(&seen.painted, 1);
    let frame = things.drawn::<Painter>(camera, |_| true);
    let alone: Vec<Frame> =
        (0..things.0.len()).map(|one| things.drawn::<NoDepth>(camera, |place| place == one)).collect();
    let depths = things.depths(camera);
    for (pixel, &shown) in frame.colours.iter().enumerate() {
        let covering = (0..alone.len()).filter(|&one| alone[one].colours[pixel] != 0);
        add(&seen.met, usize::from(covering.clone().count() > 1));
        let nearest = covering.max_by(|&a, &b| depths[a][0].total_cmp(&depths[b][0]));
        let expected = nearest.map_or(0, |one| alone[one].colours[pixel]);
        if shown != expected {
            return Err(format!("pixel {pixel}: {shown} and not {expected}; depths {depths:?}"));
        }
    }
    // Codes are cut off, and interpolated to less than one; a length's rounding moves a depth here by up to one more.
    let mut ranges = depths.clone();
    ranges.sort_by(|a, b| a[0].total_cmp(&b[0]));
    if ranges.windows(2).all(|pair| pair[1][0].min(1.0) - pair[0][1].max(0.0) > 4.0 / 65_528.0) {
        add(&seen.against_depth, 1);
        let colours = |frame: &Frame| Frame { depths: Vec::new(), ..frame.clone() };
        colours(&frame).same("with depth", &colours(&things.drawn::<Depth16>(camera, |_| true)))?;
    }
    Ok(())
}

/// What is seen: some solids, and the near and far plane as powers of ten.
fn scene() -> impl Strategy<Value = (Vec<Placed>, i32, i32, i32)> {
    (vec(placed(), 2..6), 0..3, 1..4, 20..80)
}

// Red when a corner of the bounds is left out, when a list is sorted from near to far, or when a key is not that of its own
// vertices.
#[test]
fn painters_order_shows_no_wrong_pixel_where_it_is_said_to_be_safe() {
    let seen = Seen::default();
    check(1500, &scene(), |(placed, near, ratio, degrees)| {
        let near = 10_f64.powi(near);
        let poses = poses(&placed, near);
        let things = Things(placed.iter().map(|placed| placed.solid.mesh()).zip(poses).collect());
        let depth = near as f32..(near * 10_f64.powi(ratio)) as f32;
        let camera = Perspective::new(SIZE, Turn::from_degrees(degrees), depth);
        is_right(&things, &camera, &seen)
    });
    println!(
        "{} scenes, {} pixels, {} by codes",
        seen.painted.get(),
        seen.met.get(),
        seen.against_depth.get()
    );
    assert!(seen.painted.get() > 300 && seen.met.get() > 20_000 && seen.against_depth.get() > 100);
}

// Red when the depths of a camera without perspective are all the same.
#[test]
fn without_perspective_neither() {
    let seen = Seen::default();
    check(500, &(vec(placed(), 2..5), 1.0..4.0_f32), |(placed, height)| {
        let poses = poses(&placed, 1.0);
        let things = Things(placed.iter().map(|placed| placed.solid.mesh()).zip(poses).collect());
        is_right(&things, &Orthographic::new(SIZE, height, 1.0..30.0), &seen)
    });
    println!(
        "{} scenes, {} pixels, {} by codes",
        seen.painted.get(),
        seen.met.get(),
        seen.against_depth.get()
    );
    assert!(seen.painted.get() > 100 && seen.met.get() > 5_000 && seen.against_depth.get() > 50);
}

/// A frame with a colour for each face of one mesh.
fn by_face<D: Strips>(camera: &impl Camera, mesh: &Mesh<'_>, pose: &Pose) -> Vec<u16> {
    let colours: Vec<[u8; 3]> = (0..mesh.faces().len()).map(|face| [(face as u8 + 1) * 8, 200, 0]).collect();
    let mesh = mesh.with_face_colours(&colours).expect("one a face");
    let (mut words, mut triangles) = (vec![0; 4000], vec![ListTriangle::EMPTY; 500]);
    let mut list = DrawList::<u16, D>::new(&mut words, &mut triangles);
    list.draw(camera, &mesh, pose, &Flat::new(Material::OfMesh)).expect("it is long enough");
    rendered(&list, SIDE, 0..SIDE as i32, SIDE, 0).colours
}

// Red when a face is drawn that is culled, or a convex mesh asks for a buffer.
#[test]
fn one_convex_mesh_needs_no_buffer_wherever_it_is_cut() {
    let pixels = Cell::new(0);
    let input = (placed(), 0.05..3.0_f64, 20..100_i32);
    check(2000, &input, |(placed, near, degrees)| {
        let pose = poses(std::slice::from_ref(&placed), 1.0)[0];
        let mesh = placed.solid.mesh();
        let camera = Perspective::new(SIZE, Turn::from_degrees(degrees), near as f32..20.0);
        let things = Things(vec![(mesh, pose)]);
        if things.cheapest(&camera) != Hiding::Culling {
            return Err("a convex mesh".into());
        }
        // And inside out, as a room.
        let room: Vec<[u16; 3]> = mesh.faces().iter().map(|&[a, b, c]| [b, a, c]).collect();
        for mesh in [mesh, Mesh::new(mesh.positions(), &room).expect("the same vertices")] {
            let frame = by_face::<NoDepth>(&camera, &mesh, &pose);
            add(&pixels, frame.iter().filter(|&&colour| colour != 0).count());
            if frame != by_face::<Depth16>(&camera, &mesh, &pose) {
                return Err("a face shows that is hidden".into());
            }
        }
        Ok(())
    });
    println!("{} pixels", pixels.get());
    assert!(pixels.get() > 300_000);
}

/// What is asked of two meshes in one place, from beyond the near plane to a distance: a buffer.
fn buffer(camera: &impl Camera, near: f64, distance: f64, gap: Length) -> Hiding {
    let positions = [[-3, -3, i16::MIN], [3, -3, i16::MIN], [0, 3, i16::MAX]];
    let [middle, half] = [1.0, -1.0].map(|sign| Length::from_num((distance + sign * 1.01 * near) / 2.0));
    let mesh =
        Mesh::new(&positions, &[[0, 1, 2]]).unwrap().with_box([Length::ZERO, Length::ZERO, -middle], half);
    Hiding::cheapest(camera, &[(&mesh, &Pose::new()), (&mesh, &Pose::new())], gap)
}

// Red when the resolution is another plane's than the farthest thing's, or a share of the near plane's distance.
#[test]
fn the_buffer_is_the_cheapest_that_tells_the_gap_apart() {
    for (near, far) in [(0.1, 100.0), (1.0, 30.0), (1.0, 1000.0), (0.5, 7.0), (20.0, 30_000.0)] {
        let camera = Perspective::new(SIZE, Turn::from_degrees(50), near as f32..far as f32);
        for step in 1..40 {
            let distance = near * f64::powf(far / near, f64::from(step) / 40.0);
            let share = distance * (1.0 / near - 1.0 / far) / 65_528.0;
            let depth = (1.0 / distance - 1.0 / far) / (1.0 / near - 1.0 / far);
            for (factor, enough) in [(1.05, true), (0.95, false)] {
                let gap = Length::from_num(share * factor);
                // What a gap is rounded to is not what is tested, nor where both buffers are as fine.
                let rounded = gap.to_num::<f64>() / share;
                if (rounded / factor - 1.0).abs() > 0.04 || (depth * 16.0 - 1.0).abs() < 0.02 {
                    continue;
                }
                let expected =
                    if enough || depth > 1.0 / 16.0 { Hiding::Depth16 } else { Hiding::DepthFloat };
                assert_eq!(
                    buffer(&camera, near, distance, gap),
                    expected,
                    "{near}..{far} at {distance}: {gap}"
                );
            }
            if (depth * 16.0 - 1.0).abs() < 0.02 {
                continue;
            }
            let finest = if depth > 1.0 / 16.0 { Hiding::Depth16 } else { Hiding::DepthFloat };
            for gap in [Length::ZERO, Length::NEG_ONE, Length::MIN] {
                assert_eq!(buffer(&camera, near, distance, gap), finest, "{near}..{far} at {distance}");
            }
        }
    }
    let level = Orthographic::new(SIZE, 4.0, 1.0..1000.0);
    assert_eq!(buffer(&level, 1.0, 900.0, Length::ZERO), Hiding::Depth16);
}

// Red when what the view does not reach is counted, when a mesh is not asked whether it is convex, when more meshes than are
// kept are taken for apart, or when a target that is too large asks for a buffer.
#[test]
fn what_is_not_seen_asks_for_nothing() {
    let camera = Perspective::new(SIZE, Turn::from_degrees(50), 1.0..200.0);
    let cube = scenes::mesh::CUBE;
    let at = |z: i32| Pose::new().at([Length::ZERO, Length::ZERO, Length::from_num(z)]);
    let ask = |camera: &Perspective, mesh: &Mesh<'_>, places: &[i32]| {
        let things = Things(places.iter().map(|&z| (*mesh, at(z))).collect());
        things.cheapest(camera)
    };
    assert_eq!(ask(&camera, &cube, &[]), Hiding::Culling);
    assert_eq!(ask(&camera, &cube, &[-5]), Hiding::Culling);
    assert_eq!(ask(&camera, &cube, &[-5, 30, -5000]), Hiding::Culling);
    assert_eq!(ask(&camera, &cube, &[-5, 30, -10]), Hiding::Painter);
    assert_eq!(ask(&camera, &cube, &[-5, -5]), Hiding::Depth16);
    assert_eq!(ask(&camera, &scenes::mesh::TEAPOT, &[-5]), Hiding::Depth16);
    assert_eq!(ask(&camera, &scenes::mesh::TEAPOT, &[-5, -10]), Hiding::Depth16);
    let row: Vec<i32> = (1..=33).map(|place| -5 * place).collect();
    assert_eq!(ask(&camera, &cube, &row[..32]), Hiding::Painter);
    assert_eq!(ask(&camera, &cube, &row), Hiding::Depth16);
    let nowhere = camera.look_at([0.0; 3], [0.0; 3]);
    assert!(!nowhere.is_valid());
    assert_eq!(ask(&nowhere, &scenes::mesh::TEAPOT, &[-5, -5]), Hiding::Culling);
    let huge = Perspective::new(Size::new(9000, 9000), Turn::from_degrees(50), 1.0..200.0);
    assert_eq!(ask(&huge, &scenes::mesh::TEAPOT, &[-5, -5]), Hiding::Culling);
}

// Red when any sum or shift overflows: the test profile checks.
#[test]
fn any_camera_and_any_gap_have_an_answer() {
    let rows = [any::<[i32; 4]>(), any::<[i32; 4]>(), any::<[i32; 4]>(), any::<[i32; 4]>()];
    let input = (rows, 0..32_u32, any::<[i32; 5]>(), any::<[u16; 2]>(), any::<i32>(), any::<bool>());
    check(20_000, &input, |(rows, down, [x, y, z, scale, half], [a, b], gap, level)| {
        let matrix = Matrix::new(rows.map(|row| row.map(|element| Length::from_bits(element >> down))));
        let pose = |turn| {
            let pose = Pose::new().turned_x(Turn::new(turn)).scaled(Length::from_bits(scale));
            pose.at([x, y, z].map(Length::from_bits))
        };
        let mesh = scenes::mesh::CUBE.with_box([Length::ZERO; 3], Length::from_bits(half));
        let things = Things(vec![(mesh, pose(a)), (mesh, pose(b))]);
        let things: Vec<(&Mesh<'_>, &Pose)> = things.0.iter().map(|(mesh, pose)| (mesh, pose)).collect();
        if level {
            Hiding::cheapest(&MatrixCamera::<false>::new(SIZE, matrix), &things, Length::from_bits(gap));
        } else {
            Hiding::cheapest(&MatrixCamera::<true>::new(SIZE, matrix), &things, Length::from_bits(gap));
        }
        Ok(())
    });
}

//! Promise 2: the same scene gives the same bytes, colours and depths, whichever vertex a triangle starts with, whatever
//! the height of the strips, by either traversal, and as often as it is drawn.
#![expect(clippy::disallowed_types, reason = "cameras are given in floats")]

#[path = "../support/mod.rs"]
mod support;

mod by_hand;
mod in_order;

use std::cell::Cell;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::prelude::*;
use scenes::texture::TEST_CARD;
use scenes::{Method, SCENES, Scene, Shade, View};
use topleft::stages::{Shader, Traversal};
use topleft::{
    Affine, Attribute, BoxWalk, BySize, Camera, ColourError, Coord, Cull, Depth, Depth16, DepthFloat,
    Divided, DrawList, Flat, Gouraud, Length, ListTriangle, Material, Mesh, Orthographic, PerPixel,
    Perspective, Point as Corner, Portable, Pose, ShadedTriangle, Spans, SpansBy, Stats, Strip, Subspans,
    Sun, Textured, Turn, Within, Wrap,
};

use by_hand::ByHand;
use support::counter::StrictDisplay;
use support::frame::{Frame, Strips, rendered};
use support::strategies::{MeshData, mesh_data};
use support::{check, same};

/// The six orders of a triangle's vertices.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// What can be drawn into a list of either traversal.
trait Drawing {
    /// The target.
    fn size(&self) -> Size;
    /// Words and triangles that a list needs for it.
    fn needs(&self) -> (usize, usize);
    fn draw<D: Depth, T: Traversal>(&self, list: &mut DrawList<'_, u16, D, T>);
}

const BACKGROUND: u16 = 0x1234;

/// Renders a list into a frame by strips of `rows` rows each.
fn render<D: Strips, T: Traversal>(list: &DrawList<'_, u16, D, T>, size: Size, rows: usize) -> Frame {
    rendered(list, size.width as usize, 0..size.height.cast_signed(), rows, BACKGROUND)
}

/// Draws into a new list by a traversal, and hands it over.
fn listed<D: Depth, T: Traversal, R>(
    drawing: &impl Drawing,
    with: impl FnOnce(&mut DrawList<'_, u16, D, T>) -> R,
) -> R {
    let (words, triangles) = drawing.needs();
    let (mut words, mut triangles) = (vec![0; words], vec![ListTriangle::EMPTY; triangles]);
    let mut list = DrawList::<u16, D, T>::with_traversal(&mut words, &mut triangles);
    drawing.draw(&mut list);
    with(&mut list)
}

/// The whole frame in one strip.
fn whole<D: Strips, T: Traversal>(drawing: &impl Drawing) -> Frame {
    listed::<D, T, _>(drawing, |list| render(list, drawing.size(), drawing.size().height as usize))
}

/// All strip heights by both traversals; gives back the frame and how many others were compared with it.
fn any_strips<D: Strips>(what: &str, drawing: &impl Drawing) -> Result<(Frame, usize), String> {
    fn heights<D: Strips, T: Traversal>(
        what: &str,
        drawing: &impl Drawing,
        expected: &Frame,
    ) -> Result<usize, String> {
        let height = drawing.size().height as usize;
        listed::<D, T, _>(drawing, |list| {
            for rows in 1..=height {
                let what = format!("{what}, strips of {rows} rows, {}", std::any::type_name::<T>());
                render(list, drawing.size(), rows).same(&what, expected)?;
            }
            Ok(height)
        })
    }
    let frame = whole::<D, Spans>(drawing);
    let frames = heights::<D, Spans>(what, drawing, &frame)?
        + heights::<D, BoxWalk>(what, drawing, &frame)?
        + heights::<D, BySize>(what, drawing, &frame)?
        + heights::<D, SpansBy<ByHand>>(what, drawing, &frame)?;
    Ok((frame, frames))
}

/// A scene as it is, or in another way of shading.
struct OfScene {
    scene: &'static Scene,
    size: Size,
    view: View,
}

impl Drawing for OfScene {
    fn size(&self) -> Size {
        self.size
    }

    fn needs(&self) -> (usize, usize) {
        // Up to seven words a vertex, and room for what clipping makes.
        (self.scene.vertices() * 7 + 20_000, self.scene.faces() + 4_000)
    }

    fn draw<D: Depth, T: Traversal>(&self, list: &mut DrawList<'_, u16, D, T>) {
        self.scene.draw(list, self.size, &self.view).expect("the list is long enough");
    }
}

/// All scenes in all ways of shading, from where they are usually seen and from nearer by.
fn all_scenes(size: Size) -> impl Iterator<Item = (String, OfScene)> {
    let ways = Shade::ALL.into_iter().flat_map(|shade| Method::ALL.map(|method| (shade, method)));
    let ways = ways
        .filter(|&(shade, method)| matches!(shade, Shade::Textured | Shade::Lit) || method == Method::Affine);
    SCENES.iter().flat_map(move |scene| {
        ways.clone().map(move |(shade, method)| {
            let near = if shade == Shade::Gouraud { "0.7" } else { "1" };
            let view = View {
                turn: Turn::from_degrees(30),
                yaw: Turn::from_degrees(200),
                distance: Length::lit(near),
                shade: Some(shade),
                method: Some(method),
                ..View::default()
            };
            (format!("{} {} {}", scene.name, shade.name(), method.name()), OfScene { scene, size, view })
        })
    })
}

/// A mesh of random triangles before a camera that stands among them.
struct OfMesh<'m> {
    mesh: Mesh<'m>,
    way: usize,
    near: f32,
    stats: Cell<Stats>,
}

const WAYS: usize = 16;
/// So that some triangles of random colours are of one, and others are not.
const ROUGH: Attribute = Attribute::lit("60");

impl OfMesh<'_> {
    fn add<'a, D: Depth, T: Traversal, S: Shader<'a, u16>>(
        &self,
        list: &mut DrawList<'a, u16, D, T>,
        shader: &S,
    ) {
        fn add<'a, D: Depth, T: Traversal>(
            list: &mut DrawList<'a, u16, D, T>,
            camera: &impl Camera,
            mesh: &Mesh<'_>,
            shader: &impl Shader<'a, u16>,
        ) {
            list.draw(camera, mesh, &Pose::new(), shader).expect("the list is long enough");
        }
        list.set_cull(Cull::None);
        if self.way == WAYS - 1 {
            add(list, &Orthographic::new(self.size(), 0.05, -0.5..0.7), &self.mesh, shader);
        } else {
            let camera = Perspective::new(self.size(), Turn::from_degrees(70), self.near..1.5);
            add(list, &camera.look_at([0.2, 0.1, 0.3], [-0.2, 0.0, -0.1]), &self.mesh, shader);
        }
        self.stats.set(list.stats());
    }
}

impl Drawing for OfMesh<'_> {
    fn size(&self) -> Size {
        Size::new(36, 26)
    }

    fn needs(&self) -> (usize, usize) {
        (1024, 64)
    }

    fn draw<D: Depth, T: Traversal>(&self, list: &mut DrawList<'_, u16, D, T>) {
        let sun = Sun::new([Length::lit("0.3"), Length::lit("0.8"), Length::lit("0.4")]);
        let card =
            TEST_CARD.with_wrap(if self.mesh.faces().len() % 2 == 0 { Wrap::Clamp } else { Wrap::Repeat });
        match self.way {
            0 => self.add(list, &Flat::new(Material::OfMesh)),
            1 => self.add(list, &Flat::new(Material::OfMesh).lit_by(&sun)),
            2 => self.add(list, &Gouraud::unlit(&Material::OfMesh)),
            3 => self.add(list, &Gouraud::new(&sun, &Material::OfMesh)),
            4 => self.add(list, &Textured::new(&card, Affine)),
            5 => self.add(list, &Textured::new(&card, PerPixel)),
            6 => self.add(list, &Textured::new(&card, Affine).lit_by(&sun)),
            7 => self.add(list, &Textured::new(&card, Subspans::Of4)),
            8 => self.add(list, &Textured::new(&card, Subspans::Of16).lit_by(&sun)),
            9 => self.add(list, &Textured::new(&card, Within::default())),
            10 => self.add(list, &Textured::new(&card, Within::texels(Attribute::ONE)).lit_by(&sun)),
            11 => self.add(list, &Textured::new(&card, Within::texels(Attribute::lit("0.0625")))),
            12 => self.add(list, &Textured::new(&card, Divided::<Portable>::new())),
            13 => self.add(list, &Gouraud::unlit(&Material::OfMesh).within(ColourError::codes(ROUGH))),
            14 => self.add(list, &Gouraud::new(&sun, &Material::OfMesh).within(ColourError::default())),
            _ => self.add(list, &Textured::new(&card, PerPixel).lit_by(&sun)),
        }
    }
}

/// Random meshes in a way of shading, before near planes from 1/500 of their size on: the nearest make triangles that
/// leave the guard rectangle.
fn meshes() -> impl Strategy<Value = (MeshData, usize, f32)> {
    (mesh_data(), 0..WAYS, prop_oneof![Just(0.002_f32), Just(0.05), Just(0.3)])
}

// Red when `canonical` in src/setup.rs keeps two vertices in the order that they came in, or `polygon` in
// src/list/draw.rs does not rotate the clipped polygon to its least vertex.
#[test]
fn six_vertex_orders_give_the_same_bytes() {
    let (clipped, pixels) = (Cell::new(0), Cell::new(0));
    check(20_000, &meshes(), |(data, way, near)| {
        let frame = |order: [usize; 3]| {
            let faces: Vec<[u16; 3]> = data.faces.iter().map(|face| order.map(|i| face[i])).collect();
            let drawing = OfMesh { mesh: data.with_faces(&faces), way, near, stats: Cell::default() };
            let frame = whole::<Depth16, Spans>(&drawing);
            (frame, drawing.stats.get())
        };
        let (expected, stats) = frame(ORDERS[0]);
        clipped.set(clipped.get() + stats.clipped);
        pixels.set(pixels.get() + expected.seen());
        for order in ORDERS {
            frame(order).0.same(&format!("order {order:?}"), &expected)?;
        }
        Ok(())
    });
    println!("{} pixels seen, {} triangles clipped", pixels.get(), clipped.get());
    assert!(clipped.get() > 3_000 && pixels.get() > 100_000);
}

// Red when `least` in src/triangle.rs is not the least vertex, or clipping depends on where the triangle starts.
#[test]
fn six_vertex_orders_of_a_flat_drawing_give_the_same_pixels() {
    let texture = TEST_CARD.with_wrap(Wrap::Repeat);
    let coordinate = prop_oneof![-600 * 256..600 * 256_i32, -4000 * 256..4000 * 256_i32, any::<i32>()];
    let corner = (coordinate.clone(), coordinate, any::<[u8; 3]>(), any::<[i16; 2]>());
    let pixels = Cell::new(0);
    check(20_000, &([corner.clone(), corner.clone(), corner], 0..3_u8), |(corners, shade)| {
        let drawn = |order: [usize; 3]| {
            let [a, b, c] = order.map(|i| corners[i]);
            let points = [a, b, c].map(|(x, y, ..)| Corner::new(Coord::from_bits(x), Coord::from_bits(y)));
            let colours = [a, b, c].map(|(.., [r, g, b], _)| Rgb565::new(r & 31, g & 63, b & 31));
            let texels = [a, b, c].map(|(.., uv)| uv.map(|c| Attribute::from_bits(i32::from(c) << 8)));
            let mut display = StrictDisplay::new(Rectangle::new(Point::new(-3, 20), Size::new(40, 30)));
            match shade {
                0 => ShadedTriangle::flat(points, Rgb565::RED).draw(&mut display),
                1 => ShadedTriangle::new(points, colours).draw(&mut display),
                _ => ShadedTriangle::textured(points, texels, &texture).draw(&mut display),
            }
            .expect("this display does not fail");
            display.pixels
        };
        let expected = drawn(ORDERS[0]);
        pixels.set(pixels.get() + expected.iter().flatten().count());
        for order in ORDERS {
            same(&format!("order {order:?}"), 40, &drawn(order), &expected)?;
        }
        Ok(())
    });
    println!("{} pixels", pixels.get());
    assert!(pixels.get() > 100_000);
}

// Red when a span's start values are stepped from its first visible row or column in place of the anchor: `Plane::at`; and
// when a small float is 0 where something is drawn.
#[test]
fn any_strips_and_traversal_give_the_same_bytes_of_random_meshes() {
    let frames = Cell::new(0);
    check(3_000, &meshes(), |(data, way, near)| {
        let drawing = OfMesh { mesh: data.mesh(), way, near, stats: Cell::default() };
        let (frame, compared) = any_strips::<Depth16>("a mesh", &drawing)?;
        let (float, also) = any_strips::<DepthFloat>("a mesh, small floats", &drawing)?;
        same("pixels seen", 1, &[float.seen()], &[frame.seen()])?;
        frames.set(frames.get() + compared + also);
        Ok(())
    });
    println!("{} frames", frames.get());
}

// Red as above, and when a triangle is missed by the strip that holds its first or last row: `rows` of `ListTriangle`.
#[test]
fn any_strips_and_traversal_give_the_same_bytes_of_every_scene() {
    let mut frames = 0;
    for (name, drawing) in all_scenes(Size::new(60, 48)) {
        let (frame, compared) = any_strips::<Depth16>(&name, &drawing).unwrap();
        frames += compared;
        // The least is the ladder from behind.
        assert!(frame.seen() > 50, "{name} shows {} pixels", frame.seen());
    }
    println!("{frames} frames");
}

// Red as above, at the size of a real display.
#[test]
fn any_strips_give_the_same_bytes_of_a_whole_display() {
    let size = Size::new(240, 240);
    let scene = scenes::by_name("teapot").expect("the scene of the teapot");
    let drawing = OfScene { scene, size, view: View::default() };
    let (frame, frames) = any_strips::<Depth16>("teapot", &drawing).unwrap();
    let (float, also) = any_strips::<DepthFloat>("teapot, small floats", &drawing).unwrap();
    println!("{} frames of {} pixels", frames + also, frame.seen());
    assert_eq!(frame.seen(), float.seen());
}

// Red when rendering changes a list, or `DrawList::clear` leaves something behind: its shaders, words or triangles.
#[test]
fn drawing_twice_gives_the_same_bytes() {
    let mut drawings: Vec<(String, OfScene)> = all_scenes(Size::new(60, 48)).collect();
    drawings.rotate_left(3);
    let (mut words, mut triangles) = (vec![0; 40_000], vec![ListTriangle::EMPTY; 8_000]);
    let mut list = DrawList::<u16, Depth16>::new(&mut words, &mut triangles);
    for (name, drawing) in &drawings {
        // The list still has the scene before in its storage.
        list.clear();
        drawing.draw(&mut list);
        let first = render(&list, drawing.size, 48);
        render(&list, drawing.size, 5).same(name, &first).unwrap();
        render(&list, drawing.size, 48).same(name, &first).unwrap();
        let used = list.words();
        list.clear();
        drawing.draw(&mut list);
        assert_eq!(list.words(), used, "{name}");
        render(&list, drawing.size, 48).same(name, &first).unwrap();
        whole::<Depth16, Spans>(drawing).same(name, &first).unwrap();
    }
}

// Red when a shader that comes back finds another's vertices in place of its own: `keep` in src/list/draw.rs.
#[test]
fn shaders_that_take_turns_in_a_list_draw_as_in_lists_of_their_own() {
    let size = Size::new(36, 26);
    let turn = || (mesh_data(), 0..WAYS - 1);
    check(1_000, &[turn(), turn(), turn(), turn()], |turns| {
        let drawings: Vec<OfMesh<'_>> = turns
            .iter()
            .map(|(data, way)| OfMesh { mesh: data.mesh(), way: *way, near: 0.01, stats: Cell::default() })
            .collect();
        let mut together = vec![0; 4096];
        let mut triangles = vec![ListTriangle::EMPTY; 256];
        let mut list = DrawList::<u16, Depth16>::new(&mut together, &mut triangles);
        for drawing in &drawings {
            drawing.draw(&mut list);
        }
        let (mut colours, mut depths) = (vec![BACKGROUND; 36 * 26], vec![0; 36 * 26]);
        let strip = Strip::new(36, &mut colours).expect("whole rows");
        let mut strip = strip.with_depth(&mut depths).expect("as many depths");
        for drawing in &drawings {
            listed::<Depth16, Spans, _>(drawing, |list| list.render(0..26, &mut strip));
        }
        render(&list, size, 26).same("together", &Frame { width: 36, colours, depths })
    });
}

// Red when a strip's first row or its width moves what is drawn: `set_top`, or the window in src/list/render.rs.
#[test]
fn a_strip_shows_its_part_of_the_frame_wherever_it_is() {
    let size = Size::new(60, 48);
    for (name, drawing) in all_scenes(size).step_by(3) {
        let expected = whole::<Depth16, Spans>(&drawing);
        listed::<Depth16, Spans, _>(&drawing, |list| {
            for (width, top, rows) in
                [(60, -7, 20), (60, 11, 30), (60, 40, 20), (60, 47, 1), (31, 0, 48), (1, 9, 9), (75, -3, 60)]
            {
                let what = format!("{name}, {width} columns of rows {top} to {}", top + rows);
                // A subspan ends on the last pixel of its run, and a run ends where a narrower strip does.
                let by_subspans = [Method::Subspans, Method::Within].map(Method::name);
                if width < 60 && by_subspans.iter().any(|method| name.ends_with(method)) {
                    continue;
                }
                // What lies beyond the frame is background.
                let part = |of: &[u16], outside: u16| -> Vec<u16> {
                    let places = (top..top + rows).flat_map(|y| (0..width).map(move |x| (x, y)));
                    let inside = |(x, y): (i32, i32)| {
                        (x < 60 && (0..48).contains(&y)).then_some((y * 60 + x) as usize)
                    };
                    places.map(|place| inside(place).map_or(outside, |i| of[i])).collect()
                };
                let (colours, depths) = (part(&expected.colours, BACKGROUND), part(&expected.depths, 0));
                let width = width as usize;
                let got = rendered(list, width, top..top + rows, rows as usize, BACKGROUND);
                got.same(&what, &Frame { width, colours, depths }).unwrap();
            }
        });
    }
}

//! Every vertex of every scene after the vertex stage, as the list's storage holds it: x and y, depth, 1/w.

use embedded_graphics_core::geometry::Size;
use reference::transform::{Viewport, depth, model_position};
use scenes::{Object, SCENES, Scene, View};
use topleft::stages::{PerVertexInverse, Words};
use topleft::{Depth16, DrawList, ListTriangle, Mesh, PerPixel, Pose, Texture, Textured, Turn};

use crate::measured::{Errors, Row, hold};
use crate::patches::{Placement, camera_of, pose_of};
use crate::probe::{SIZE, exact_perspective, w_of};
use crate::random::Random;
use crate::tolerance::{DEPTH_VERTEX, PERSPECTIVE_DIVIDE, REACHED, VERTEX_INVERSE};

/// Words of a textured vertex with perspective and depth: x, y, depth, 1/w, u and v.
const STRIDE: usize = 6;
/// The first word of a vertex that lies outside of some plane.
const UNSEEN: u32 = 1 << 31;

/// The words of an object's vertices.
fn words(scene: &Scene, object: &Object, size: Size, view: &View) -> Vec<u32> {
    let vertices = object.mesh.positions().len();
    // Room for what is clipped, which comes after the vertices.
    let (mut words, mut triangles) = (vec![0; 1 << 16], vec![ListTriangle::EMPTY; 4000]);
    let (pose, shader) = (object.pose(view.turn), Textured::new(&Texture::WHITE, PerPixel));
    {
        let mut list = DrawList::<u16, Depth16>::new(&mut words, &mut triangles);
        if let Some(camera) = scene.camera.orbiting(size, view) {
            list.draw(&camera, object.mesh, &pose, &shader).unwrap();
        }
        if let Some(camera) = scene.camera.front(size) {
            list.draw(&camera, object.mesh, &pose, &shader).unwrap();
        }
    }
    words.truncate(vertices * STRIDE);
    words
}

/// What a word of 1/w says, in a unit that all vertices of a mesh share.
fn inverse_of(word: u32) -> f64 {
    let [mantissa, ..] =
        PerVertexInverse::aligned([PerVertexInverse::load(&mut [word].into_iter()).unwrap(); 3]);
    f64::from(mantissa) * 2.0_f64.powi(-((word % 32) as i32))
}

/// The vertices of a scene, turned round twelve times on two sizes of screen.
pub(crate) fn of_scene(scene: &Scene) -> Vec<Row> {
    let [mut places, mut depths, mut inverses] = [(); 3].map(|()| Errors::default());
    for (turn, size) in
        (0..12).flat_map(|k| [(k * 31, Size::new(240, 240)), (k * 31 + 7, Size::new(320, 170))])
    {
        let view = View { turn: Turn::from_degrees(turn), ..View::default() };
        let viewport = Viewport { width: size.width, height: size.height };
        for object in scene.objects {
            let words = words(scene, object, size, &view);
            let (camera, pose) = (camera_of(scene, size, &view), pose_of(object, view.turn));
            let placement = Placement::new(object.mesh, &camera, &pose, viewport);
            let mut unit = None;
            for (vertex, words) in words.chunks(STRIDE).enumerate() {
                let &[x, y, code, .., inverse] = words else { panic!("{STRIDE} words a vertex") };
                if x == UNSEEN {
                    continue;
                }
                let clip = placement.whole.apply_point(model_position(object.mesh, vertex));
                let place = viewport.to_screen(clip);
                let off = placement.error(clip, place);
                let name = || format!("{} at {turn}, {size:?}, vertex {vertex}", scene.name);
                for (ours, exact) in [x, y].into_iter().zip(place) {
                    // What comes before rounding, and rounding.
                    let error = f64::from(ours.cast_signed()) - exact * 256.0;
                    places.add(error, off + 0.5, name);
                }
                // (w - z) / w: both of the quotient are off, and w - z is at most w.
                let of_w = placement.clip_error / clip[3];
                let off = 65_528.0 * 3.0 * of_w + DEPTH_VERTEX;
                depths.add(f64::from(code) / 65_536.0 - depth(clip), off, name);
                // All vertices of a mesh share the unit of 1/w: that of the first one, which is as far off itself.
                let ours = inverse_of(inverse) * clip[3];
                let unit = *unit.get_or_insert(ours);
                inverses.add(ours / unit - 1.0, 2.0 * (VERTEX_INVERSE + of_w), name);
            }
        }
    }
    // A scene of two faces has few vertices in sight.
    assert!(places.count() > 20, "{}", scene.name);
    [("place", "1/256 px", places), ("depth", "code", depths), ("1/w", "1", inverses)]
        .map(|(metric, unit, errors)| {
            Row::new("vertices", scene.name, "as the scene draws them", [metric, unit], &errors)
        })
        .into()
}

/// One vertex at every z that a mesh can have, before a camera whose numbers are exact: what the divide by w does alone.
pub(crate) fn at_every_distance() -> Vec<Row> {
    let mut random = Random::new(51);
    // The nearest comes first: its w is a power of two, whose reciprocal is exact.
    let positions: Vec<[i16; 3]> = (i16::MIN..i16::MAX)
        .map(|z| {
            let w = w_of([0, 0, z]);
            let [x, y] = [(); 2].map(|()| (f64::from(random.next() as i16) * w) as i16);
            [x, y, z]
        })
        .collect();
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    let (mut words, mut triangles) = (vec![0; positions.len() * STRIDE], [ListTriangle::EMPTY; 1]);
    {
        let mut list = DrawList::<u16, Depth16>::new(&mut words, &mut triangles);
        let uvs = vec![[0; 2]; positions.len()];
        let mesh = mesh.with_uvs(&uvs, 0).unwrap();
        list.draw(&exact_perspective(), &mesh, &Pose::new(), &Textured::new(&Texture::WHITE, PerPixel))
            .unwrap();
    }
    let [mut places, mut depths, mut inverses] = [(); 3].map(|()| Errors::default());
    let unit = inverse_of(words[STRIDE - 1]) * w_of(positions[0]);
    for (words, &position) in words.chunks(STRIDE).zip(&positions) {
        let &[x, y, code, .., inverse] = words else { panic!("{STRIDE} words a vertex") };
        let w = w_of(position);
        let name = || format!("{position:?}");
        let half_screen = f64::from(SIZE) * 128.0;
        let [exact_x, exact_y] = [position[0], position[1]].map(|c| f64::from(c) / w);
        let place = [half_screen + exact_x, half_screen - exact_y];
        for (ours, exact) in [x, y].into_iter().zip(place) {
            places.add(f64::from(ours.cast_signed()) - exact, 0.5 + PERSPECTIVE_DIVIDE, name);
        }
        let nearness = depth([0.0, 0.0, w - 1.0 / 64.0, w]);
        depths.add(f64::from(code) / 65_536.0 - nearness, DEPTH_VERTEX, name);
        inverses.add(inverse_of(inverse) * w / unit - 1.0, VERTEX_INVERSE, name);
    }
    [("place", "1/256 px", places), ("depth", "code", depths), ("1/w", "1", inverses)]
        .map(|(metric, unit, errors)| {
            Row::new("vertices", "every z of 16 bits", "w to 1:64", [metric, unit], &errors).reaching(REACHED)
        })
        .into()
}

/// Turned red by: a projection that truncates, a matrix of 22 bits, y up, 1/w of 21 bits.
#[test]
fn vertices_are_where_the_reference_sees_them() {
    SCENES.iter().for_each(|scene| hold(&of_scene(scene)));
}

/// Turned red by: one Newton step less in the reciprocal, 1/w of 24 bits.
#[test]
fn the_divide_is_within_its_bound_at_every_distance() {
    hold(&at_every_distance());
}

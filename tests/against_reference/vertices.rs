//! Every vertex of every scene after the vertex stage, as the list's storage holds it: x and y, depth, 1/w.

use embedded_graphics_core::geometry::Size;
use reference::transform::{Viewport, depth, model_position};
use scenes::{Object, SCENES, Scene, View};
use topleft::stages::{PerVertexInverse, Words};
use topleft::{Depth16, DrawList, ListTriangle, PerPixel, Texture, Textured, Turn};

use crate::patches::{Placement, camera_of, pose_of};
use crate::tolerance::{DEPTH_VERTEX, VERTEX_INVERSE};

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

/// Turned red by: a projection that truncates, a matrix of 22 bits, y up, 1/w of 21 bits.
#[test]
fn vertices_are_where_the_reference_sees_them() {
    for scene in SCENES {
        let mut worst = [0.0_f64; 3];
        let mut bound = 0.0_f64;
        let mut seen = 0_u64;
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
                    let &[x, y, code, inverse, ..] = words else { panic!("{STRIDE} words a vertex") };
                    if x == UNSEEN {
                        continue;
                    }
                    let clip = placement.whole.apply_point(model_position(object.mesh, vertex));
                    let place = viewport.to_screen(clip);
                    let off = placement.error(clip, place);
                    let name = || format!("{} at {turn}, {size:?}, vertex {vertex}", scene.name);
                    for (ours, exact) in [x, y].into_iter().zip(place) {
                        // Rounding, and what comes before it.
                        let error = (f64::from(ours.cast_signed()) - exact * 256.0).abs() - 0.5;
                        assert!(error <= off, "{}: {error} steps, of {off}", name());
                        worst[0] = worst[0].max(error / off);
                    }
                    bound = bound.max(off);
                    // (w - z) / w: both of the quotient are off, and w - z is at most w.
                    let of_w = placement.clip_error / clip[3];
                    let error = (f64::from(code) / 65_536.0 - depth(clip)).abs();
                    let off = 65_528.0 * 3.0 * of_w + DEPTH_VERTEX;
                    assert!(error <= off, "{}: depth off by {error} codes, of {off}", name());
                    worst[1] = worst[1].max(error / off);
                    // All vertices of a mesh share the unit of 1/w: that of the first one, which is as far off itself.
                    let word = PerVertexInverse::load(&mut [inverse].into_iter()).unwrap();
                    let [mantissa, ..] = PerVertexInverse::aligned([word; 3]);
                    let ours = f64::from(mantissa) * 2.0_f64.powi(-((inverse % 32) as i32)) * clip[3];
                    let unit = *unit.get_or_insert(ours);
                    let off = 2.0 * (VERTEX_INVERSE + of_w);
                    let error = (ours / unit - 1.0).abs();
                    assert!(error <= off, "{}: 1/w off by {error:e}, of {off:e}", name());
                    worst[2] = worst[2].max(error / off);
                    seen += 1;
                }
            }
        }
        println!(
            "vertices, {}: {seen}; {worst:.3?} of the bounds of x and y (at most {bound:.4} steps), depth and 1/w",
            scene.name
        );
        assert!(seen > 100, "{}", scene.name);
    }
}

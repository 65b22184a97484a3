//! Perspective: texels that swim and bend, and faces that reach behind the eye.

use embedded_graphics::prelude::Size;
use reference::image::Image;
use reference::render;
use reference::setup::Cull;
use reference::shade::{Base, Look};
use reference::transform::{Viewport, model_position};
use reference::varying::Method as Carried;
use scenes::{Method, Scene, View};
use topleft::{Length, Mesh, Turn};

use crate::canvas::Canvas;
use crate::drawn;
use crate::patches::{Frame, Placement, camera_of, pose_of};
use crate::strip::{Picture, Strip};

/// Row 15: a cube so near that w doubles over a face.
pub(crate) fn affine_cube() -> Canvas {
    let scene = scenes::by_name("near-cube").expect("a scene");
    let size = Size::new(66, 66);
    let view = View { turn: Turn::from_degrees(30), distance: Length::lit("1.3"), ..View::default() };
    let reference = Frame::new(scene, size, &view).image;
    Strip {
        title: "15  Texels that are linear on the screen bend on a near cube",
        naive_method: "affine",
        naive: drawn::scene(scene, size, &View { method: Some(Method::Affine), ..view }),
        topleft: drawn::scene(scene, size, &view),
        reference: Picture::from_rgb565(66, reference.rgb565()),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec![
            "Each face is two triangles, and each bends its texture by itself: lines break at the diagonal. The few pixels of".into(),
            "topleft that differ lie on the edges of texels.".into(),
        ],
    }
    .draw()
}

const SIZE: Size = Size::new(66, 66);

fn reference_of(scene: &Scene, view: &View) -> Picture {
    Picture::from_rgb565(66, Frame::new(scene, SIZE, view).image.rgb565())
}

/// Row 11: a floor of large tiles, some of which reach behind the eye.
pub(crate) fn behind_the_eye() -> Canvas {
    let scene = scenes::by_name("floor").expect("a scene");
    let view = View { turn: Turn::from_degrees(20), ..View::default() };
    let [object] = scene.objects else { unreachable!("the scene is a floor") };
    let viewport = Viewport { width: 66, height: 66 };
    let camera = camera_of(scene, SIZE, &view);
    let whole = Placement::new(object.mesh, &camera, &pose_of(object, view.turn), viewport).whole;
    let between = |index: &u16| {
        let [_, _, z, w] = whole.apply_point(model_position(object.mesh, usize::from(*index)));
        z >= 0.0 && z <= w
    };
    let kept: Vec<[u16; 3]> =
        object.mesh.faces().iter().copied().filter(|face| face.iter().all(between)).collect();
    let mesh = Mesh::new(object.mesh.positions(), &kept)
        .map(|mesh| mesh.with_box(object.mesh.centre(), object.mesh.half()))
        .and_then(|mesh| mesh.with_uvs(object.mesh.uvs(), object.mesh.uv_exponent()))
        .expect("a part of a mesh");
    let mut image = Image::new(viewport, scene.background.map(f64::from));
    let look = Look {
        base: Base::Texture(object.look.texture),
        light: None,
        colours: Carried::Affine,
        texels: Carried::Perspective,
        cull: Cull::Back,
        depth: true,
    };
    let seen = render::View { model_to_clip: whole, guard: None, first_face: 0 };
    render::draw(&mut image, &mesh, &seen, &look).expect("it has texture coordinates");
    Strip {
        title: "11  A floor that runs under the eye and behind it",
        naive_method: "z outside: no face",
        naive: Picture::from_rgb565(66, image.rgb565()),
        topleft: drawn::scene(scene, SIZE, &view),
        reference: reference_of(scene, &view),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec![
            "Faces with a corner before the near plane are left out, and the floor under the viewer is gone. topleft cuts them.".into(),
        ],
    }
    .draw()
}

/// Row 18: a floor whose texels are far smaller than pixels.
pub(crate) fn minified() -> Canvas {
    const FINER: u32 = 8;
    let scene = scenes::by_name("floor").expect("a scene");
    let view = View { turn: Turn::from_degrees(20), ..View::default() };
    let fine = Frame::new(scene, SIZE * FINER, &view).image;
    let mean = |x: u32, y: u32| {
        let parts =
            (0..FINER * FINER).map(|i| fine.pixel(x * FINER + i % FINER, y * FINER + i / FINER).colour);
        let sum = parts.fold([0.0; 3], |sum, colour| [0, 1, 2].map(|k| sum[k] + colour[k]));
        sum.map(|channel| (channel / f64::from(FINER * FINER)).round() as u8)
    };
    let means = (0..66).flat_map(|y| (0..66).map(move |x| (x, y))).map(|(x, y)| mean(x, y)).collect();
    Strip {
        title: "18  Texels smaller than pixels: open",
        naive_method: "nearest texel",
        naive: reference_of(scene, &view),
        topleft: drawn::scene(scene, SIZE, &view),
        reference: Picture::new(66, means),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec![
            "The reference is the mean of 8 x 8 samples a pixel. One sample is a moire that flickers when it moves. topleft has".into(),
            "no smaller levels of a texture yet: it does as the naive method does.".into(),
        ],
    }
    .draw()
}

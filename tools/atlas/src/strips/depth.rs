//! Depth: what two surfaces with one code look like.

use embedded_graphics::prelude::Size;
use reference::matrix::Vec4;
use reference::naive::plane;
use reference::setup::{Triangle, snap};
use reference::shade::to_rgb565;
use reference::transform::{Viewport, depth, model_position};
use reference::varying::linear;
use topleft::{Flat, Length, Material, Mesh, Perspective, Pose, Turn};

use crate::canvas::{Canvas, Colour};
use crate::drawn::{self, BACKGROUND};
use crate::probe::exact;
use crate::strip::{Picture, Strip};

const SIZE: Size = Size::new(66, 66);
const FAR: f32 = 40.0;
const COLOURS: [Colour; 2] = [[224, 168, 80], [64, 112, 200]];
/// Steps of a position in one unit: its cube reaches to 16.
const UNIT: i32 = 2048;

/// Two triangles over all of the screen, ten units away, that cross on a slanted line.
const POSITIONS: [[i16; 3]; 6] = {
    let mut positions = [[0; 3]; 6];
    let places = [[-12, -10], [12, -10], [0, 14]];
    let mut i = 0;
    while i < 6 {
        let [x, y] = places[i % 3];
        // A fifth of a unit nearer for each unit to the right, or further; both lean towards the viewer.
        let slope = (x * 10 + y * 4) * UNIT / 50;
        let z = (y - 50) * UNIT / 5 + if i < 3 { slope } else { -slope };
        positions[i] = [(x * UNIT) as i16, (y * UNIT) as i16, z as i16];
        i += 1;
    }
    positions
};
const CROSSING: [[u16; 3]; 2] = [[0, 1, 2], [3, 4, 5]];
/// One plane twice, from another corner on.
const THE_SAME: [[u16; 3]; 2] = [[0, 1, 2], [1, 2, 0]];

fn mesh(faces: &'static [[u16; 3]; 2]) -> Mesh<'static> {
    Mesh::new(&POSITIONS, faces)
        .map(|mesh| mesh.with_box([Length::ZERO; 3], Length::lit("16")))
        .and_then(|mesh| mesh.with_face_colours(&COLOURS))
        .expect("a mesh")
}

fn camera(near: f32) -> Perspective {
    Perspective::new(SIZE, Turn::from_degrees(45), near..FAR)
}

/// Drawn by the library, with the near plane at a distance.
fn with_near(near: f32, faces: &'static [[u16; 3]; 2]) -> Picture {
    drawn::frame(SIZE, BACKGROUND, |list| {
        let drawn = list.draw(&camera(near), &mesh(faces), &Pose::new(), &Flat::new(Material::OfMesh));
        drawn.expect("the list is long enough");
    })
}

/// Two faces over all of the screen, as corners on the screen with their clip coordinates.
fn on_screen(near: f32, faces: &'static [[u16; 3]; 2]) -> [(Triangle, [Vec4; 3]); 2] {
    let viewport = Viewport { width: SIZE.width, height: SIZE.height };
    let (mesh, matrix) = (mesh(faces), exact(topleft::Camera::matrix(&camera(near))));
    faces.map(|face| {
        let clip = face.map(|index| matrix.apply_point(model_position(&mesh, usize::from(index))));
        let corner = |clip| viewport.to_screen(clip).map(|c| snap(c).expect("a place on the screen"));
        (clip.map(corner), clip)
    })
}

/// The colour of the first face, or of the second where that is in front.
fn second_where(is_in_front: impl Fn(i64, i64) -> bool) -> Picture {
    let places = (0..66).flat_map(|y| (0..66).map(move |x| (x, y)));
    let colour = |second: bool| to_rgb565(COLOURS[usize::from(second)].map(f64::from));
    Picture::from_rgb565(66, places.map(|(x, y)| colour(is_in_front(x, y))))
}

/// Row 24: a plane that is drawn twice.
pub(crate) fn coplanar() -> Canvas {
    const NEAR: f32 = 5.0;
    let faces = on_screen(NEAR, &THE_SAME);
    let depth = |(triangle, clip): (Triangle, [Vec4; 3]), x: i64, y: i64| {
        plane::from_the_given_vertex(triangle, clip.map(depth), x, y)
    };
    Strip {
        title: "24  One triangle twice, named from another corner on",
        naive_method: "f32 depth, corner 0",
        naive: second_where(|x, y| depth(faces[1], x, y) > depth(faces[0], x, y)),
        topleft: with_near(NEAR, &THE_SAME),
        reference: second_where(|_, _| false),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec![
            "Depth as f32, counted from corner 0: the second shines through where the last bit differs. topleft sorts the corners"
                .into(),
            "first: both have the same depth, and the first drawn stays.".into(),
        ],
    }
    .draw()
}

/// Row 25: planes that cross far away.
pub(crate) fn crossing_planes() -> Canvas {
    // Which is nearer, without codes.
    let [first, second] = on_screen(1.0, &CROSSING);
    let nearness = |(triangle, clip): (Triangle, [Vec4; 3]), x: i64, y: i64| {
        linear(triangle, clip.map(|[.., w]| 1.0 / w), x, y)
    };
    Strip {
        title: "25  Two planes cross ten units away",
        naive_method: "near plane at 0.004",
        naive: with_near(0.004, &CROSSING),
        topleft: with_near(1.0, &CROSSING),
        reference: second_where(|x, y| nearness(second, x, y) > nearness(first, x, y)),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec![
            "The far plane is at 40. Ten units away a code is w^2 / (65528 near) deep: 0.38 units with the near plane at 0.004,".into(),
            "and 0.0015 with it at 1, as in topleft's picture. Of equal codes the first drawn stays.".into(),
        ],
    }
    .draw()
}

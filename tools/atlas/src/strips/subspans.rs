//! Subspans: texels that are exact at every 16th pixel and linear between.

use embedded_graphics::prelude::Size;
use reference::image::Image;
use reference::render::{self, View};
use reference::setup::{Cull, Triangle, snap};
use reference::shade::{Base, Look, texel, uv};
use reference::transform::{Viewport, model_position};
use reference::varying::{Method, perspective};
use scenes::texture::TEST_CARD;
use topleft::stages::Window;
use topleft::{Length, Mesh, PerPixel, Perspective, Pose, Textured, Turn};

use crate::canvas::Canvas;
use crate::drawn::{self, BACKGROUND};
use crate::probe::exact;
use crate::strip::{Picture, Strip};

const SIDE: i32 = 66;
const SIZE: Size = Size::new(66, 66);
const LENGTH: i32 = 16;
/// Steps of a position in one unit: its cube reaches to 64.
const UNIT: i16 = 512;

/// A wall on the left, from beside the viewer into the distance.
const POSITIONS: [[i16; 3]; 4] = [
    [-UNIT, -UNIT, -2 * UNIT],
    [-UNIT, -UNIT, -60 * UNIT],
    [-UNIT, UNIT, -60 * UNIT],
    [-UNIT, UNIT, -2 * UNIT],
];
const FACES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
/// Eight repeats along it.
const UVS: [[i16; 2]; 4] = [[0, 4096], [32_767, 4096], [32_767, 0], [0, 0]];
const UV_EXPONENT: u8 = 3;

fn wall() -> Mesh<'static> {
    Mesh::new(&POSITIONS, &FACES)
        .map(|mesh| mesh.with_box([Length::ZERO; 3], Length::lit("64")))
        .and_then(|mesh| mesh.with_uvs(&UVS, UV_EXPONENT))
        .expect("a mesh")
}

fn camera() -> Perspective {
    Perspective::new(SIZE, Turn::from_degrees(45), 1.0..100.0)
}

/// Every subspan as long as the others: the last one ends beyond the edge.
fn extrapolated() -> Picture {
    let viewport = Viewport { width: SIZE.width, height: SIZE.height };
    let (mesh, matrix) = (wall(), exact(topleft::Camera::matrix(&camera())));
    let mut pixels = vec![reference::shade::to_rgb565(BACKGROUND.map(f64::from)); (SIDE * SIDE) as usize];
    for face in mesh.faces() {
        let clip = face.map(|index| matrix.apply_point(model_position(&mesh, usize::from(index))));
        let triangle: Triangle =
            clip.map(|clip| viewport.to_screen(clip).map(|c| snap(c).expect("before the eye")));
        let q = clip.map(|[.., w]| 1.0 / w);
        let texels = face.map(|index| uv(mesh.uvs()[usize::from(index)], UV_EXPONENT, &TEST_CARD));
        let at = |x: i32, y: i32| {
            [0, 1].map(|axis| perspective(triangle, texels.map(|uv| uv[axis]), q, x.into(), y.into()))
        };
        drawn::spans(triangle, &Window { columns: 0..SIDE, rows: 0..SIDE }, |span, _, _| {
            for left in (span.start..span.end).step_by(LENGTH as usize) {
                let (from, to) = (at(left, span.y), at(left + LENGTH, span.y));
                for x in left..(left + LENGTH).min(span.end) {
                    let part = f64::from(x - left) / f64::from(LENGTH);
                    let uv = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
                    pixels[(span.y * SIDE + x) as usize] = texel(&TEST_CARD, uv);
                }
            }
        });
    }
    Picture::from_rgb565(SIDE as usize, pixels)
}

fn exactly() -> Picture {
    let mut image =
        Image::new(Viewport { width: SIZE.width, height: SIZE.height }, BACKGROUND.map(f64::from));
    let look = Look {
        base: Base::Texture(TEST_CARD),
        light: None,
        colours: Method::Affine,
        texels: Method::Perspective,
        cull: Cull::None,
        depth: true,
    };
    let seen = View { model_to_clip: exact(topleft::Camera::matrix(&camera())), guard: None, first_face: 0 };
    render::draw(&mut image, &wall(), &seen, &look).expect("it has texture coordinates");
    Picture::from_rgb565(SIDE as usize, image.rgb565())
}

/// Row 16: a wall into the distance.
pub(crate) fn beyond_the_edge() -> Canvas {
    let ours = drawn::frame(SIZE, BACKGROUND, |list| {
        list.set_cull(topleft::Cull::None);
        let shader = Textured::new(&TEST_CARD, PerPixel);
        list.draw(&camera(), &wall(), &Pose::new(), &shader).expect("the list is long enough");
    });
    Strip {
        title: "16  Subspans of 16 px, the last one to an end beyond the edge",
        naive_method: "all of 16 px",
        naive: extrapolated(),
        topleft: ours,
        reference: exactly(),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec![
            "Beyond the wall's horizon 1/w is negative: subspans that reach over it run through texels backwards. topleft takes a"
                .into(),
            "reciprocal at each pixel, and none beyond the edge. (The naive picture is a model in f64.)".into(),
        ],
    }
    .draw()
}

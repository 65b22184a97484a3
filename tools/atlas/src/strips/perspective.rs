//! Perspective: texels that swim and bend.

use embedded_graphics::prelude::Size;
use scenes::{Method, View};
use topleft::Turn;

use crate::canvas::Canvas;
use crate::drawn;
use crate::patches::Frame;
use crate::strip::{Picture, Strip};

/// Row 15: a cube so near that w doubles over a face.
pub(crate) fn affine_cube() -> Canvas {
    let scene = scenes::by_name("near-cube").expect("a scene");
    let size = Size::new(66, 66);
    let view = View { turn: Turn::from_degrees(30), ..View::default() };
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
        notes: vec![],
    }
    .draw()
}

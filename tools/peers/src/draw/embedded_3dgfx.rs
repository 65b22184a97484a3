//! embedded-3dgfx: the way of its engine and its fixed-point triangles, at whole pixels.

use embedded_3dgfx::pipeline::rasterize::draw::{fill_triangle_fixed, fill_triangle_zbuffered_fixed};
use embedded_3dgfx::prelude::{DrawPrimitive, RasterState, Z_MAX_VALUE, ZDepth, draw_zbuffered_with_state};
use embedded_graphics::pixelcolor::{Rgb565, raw::RawU16};
use embedded_graphics::prelude::Point;
use nalgebra::Point2;

use super::frame::Frame;
use crate::grid::{Face, SIZE};
use crate::peer::Peer;

const VERSION: &str = "0.7.2";

struct Buffers {
    frame: Frame,
    depths: Vec<ZDepth>,
}

impl Default for Buffers {
    fn default() -> Self {
        Self { frame: Frame::default(), depths: vec![Z_MAX_VALUE; SIZE * SIZE] }
    }
}

impl Buffers {
    fn clear(&mut self) {
        self.frame.0.fill(0);
        self.depths.fill(Z_MAX_VALUE);
    }
}

/// A triangle at whole pixels.
struct Whole {
    points: [Point; 3],
    depths: [f32; 3],
    colour: Rgb565,
}

fn whole(face: &Face) -> Whole {
    Whole {
        points: face.corners.map(|c| Point::new(c.x.floor() as i32, c.y.floor() as i32)),
        depths: face.corners.map(|c| c.z),
        colour: RawU16::new(face.colour).into(),
    }
}

macro_rules! ways {
    ($($way:ident, $name:literal, $work:literal, $from:expr, $draw:expr;)*) => {$(
        #[derive(Default)]
        pub(super) struct $way(Buffers);

        impl Peer for $way {
            fn name(&self) -> &'static str {
                $name
            }

            fn version(&self) -> &'static str {
                VERSION
            }

            fn work(&self) -> &'static str {
                $work
            }

            fn given(&self) -> &'static str {
                "whole px"
            }

            fn run(&mut self, faces: &[Face], timed: &mut dyn FnMut(&mut dyn FnMut())) {
                let faces: Vec<_> = faces.iter().map(whole).map($from).collect();
                self.0.clear();
                timed(&mut || faces.iter().for_each(|face| $draw(face, &mut self.0)));
            }

            fn pixels(&self) -> Vec<u16> {
                self.0.frame.0.clone()
            }
        }
    )*};
}

fn primitive(Whole { points, depths, colour }: Whole) -> (DrawPrimitive, RasterState<'static>) {
    let points = points.map(|p| Point2::new(p.x, p.y));
    let primitive = DrawPrimitive::ColoredTriangleWithDepth { points, depths, color: colour };
    (primitive, RasterState::from_zbuffer(SIZE, SIZE * SIZE))
}

/// Its depths as integers: 0 is near.
fn fixed(face: Whole) -> (Whole, [u32; 3]) {
    let depths = face.depths.map(|z| (z * f32::from(u16::MAX)) as u32);
    (face, depths)
}

ways! {
    Engine, "embedded-3dgfx, draw_zbuffered_with_state", "flat+depth", primitive,
        |(primitive, state): &(DrawPrimitive, _), Buffers { frame, depths }: &mut Buffers| {
            draw_zbuffered_with_state(primitive.clone(), frame, depths, state);
        };
    FixedDepth, "embedded-3dgfx, fill_triangle_zbuffered_fixed", "flat+depth", fixed,
        |(face, [a, b, c]): &(Whole, [u32; 3]), Buffers { frame, depths }: &mut Buffers| {
            let [p, q, r] = face.points;
            fill_triangle_zbuffered_fixed(p, q, r, *a, *b, *c, face.colour, frame, depths, SIZE);
        };
    FixedFlat, "embedded-3dgfx, fill_triangle_fixed", "flat", |face| face,
        |face: &Whole, Buffers { frame, .. }: &mut Buffers| {
            let [p, q, r] = face.points;
            fill_triangle_fixed(p, q, r, face.colour, frame);
        };
}

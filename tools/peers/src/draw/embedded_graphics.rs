//! embedded-graphics: its filled `Triangle`, at whole pixels, without depth.

use embedded_graphics::pixelcolor::{Rgb565, raw::RawU16};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Styled, Triangle};

use super::frame::Frame;
use crate::grid::Face;
use crate::peer::Peer;

#[derive(Default)]
pub(super) struct Filled(Frame);

impl Peer for Filled {
    fn name(&self) -> &'static str {
        "embedded-graphics, Triangle"
    }

    fn version(&self) -> &'static str {
        "0.8.2"
    }

    fn work(&self) -> &'static str {
        "flat"
    }

    fn given(&self) -> &'static str {
        "whole px"
    }

    fn run(&mut self, faces: &[Face], timed: &mut dyn FnMut(&mut dyn FnMut())) {
        let styled = |face: &Face| {
            let [a, b, c] = face.corners.map(|c| Point::new(c.x.floor() as i32, c.y.floor() as i32));
            let colour: Rgb565 = RawU16::new(face.colour).into();
            Triangle::new(a, b, c).into_styled(PrimitiveStyle::with_fill(colour))
        };
        let triangles: Vec<Styled<Triangle, _>> = faces.iter().map(styled).collect();
        self.0.0.fill(0);
        timed(&mut || {
            for triangle in &triangles {
                let Ok(_) = triangle.draw(&mut self.0);
            }
        });
    }

    fn pixels(&self) -> Vec<u16> {
        self.0.0.clone()
    }
}

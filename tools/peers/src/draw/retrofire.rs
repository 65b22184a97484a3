//! retrofire-core: `tri_fill`, floats, top-left by rounding to pixel centres. A test of depth and a store a pixel.

use retrofire_core::geom::{Vertex, vertex};
use retrofire_core::math::pt3;
use retrofire_core::render::raster::{ScreenPt, tri_fill};

use crate::grid::{Face, SIZE};
use crate::peer::Peer;

pub(super) struct TriFill {
    faces: Vec<([Vertex<ScreenPt, ()>; 3], u16)>,
    pixels: Vec<u16>,
    depths: Vec<f32>,
}

impl Default for TriFill {
    fn default() -> Self {
        Self { faces: Vec::new(), pixels: vec![0; SIZE * SIZE], depths: vec![0.0; SIZE * SIZE] }
    }
}

impl Peer for TriFill {
    fn name(&self) -> &'static str {
        "retrofire-core, tri_fill"
    }

    fn version(&self) -> &'static str {
        "0.4.0"
    }

    fn work(&self) -> &'static str {
        "flat+depth"
    }

    fn given(&self) -> &'static str {
        "f32"
    }

    fn run(&mut self, faces: &[Face], timed: &mut dyn FnMut(&mut dyn FnMut())) {
        // Its z is 1/w: greater is nearer.
        let corner = |c: crate::grid::Corner| vertex(pt3(c.x, c.y, 1.0 - c.z), ());
        self.faces = faces.iter().map(|face| (face.corners.map(corner), face.colour)).collect();
        self.pixels.fill(0);
        self.depths.fill(0.0);
        let Self { faces, pixels, depths } = self;
        timed(&mut || {
            for (corners, colour) in &*faces {
                tri_fill(*corners, |mut scanline| {
                    let (row, columns) = (scanline.y * SIZE, scanline.xs.clone());
                    let cells = row + columns.start..row + columns.end;
                    let (pixels, depths) = (&mut pixels[cells.clone()], &mut depths[cells]);
                    for ((pixel, depth), fragment) in pixels.iter_mut().zip(depths).zip(scanline.fragments())
                    {
                        if fragment.pos.z() > *depth {
                            (*pixel, *depth) = (*colour, fragment.pos.z());
                        }
                    }
                });
            }
        });
    }

    fn pixels(&self) -> Vec<u16> {
        self.pixels.clone()
    }
}

//! euc: its filled triangles, floats, a colour for each draw call.

use euc::buffer::Buffer2d;
use euc::rasterizer::{BackfaceCullingDisabled, Triangles};
use euc::{Pipeline, Target};

use crate::grid::{Face, SIZE};
use crate::peer::Peer;

pub(super) struct Filled {
    faces: Vec<([[f32; 4]; 3], u16)>,
    pixels: Buffer2d<u16>,
    depths: Buffer2d<f32>,
}

impl Default for Filled {
    fn default() -> Self {
        let size = [SIZE; 2];
        Self { faces: Vec::new(), pixels: Buffer2d::new(size, 0), depths: Buffer2d::new(size, 1.0) }
    }
}

struct Colour(u16);

impl Pipeline for Colour {
    type Vertex = [f32; 4];
    type VsOut = ();
    type Pixel = u16;

    #[inline(always)]
    fn vert(&self, vertex: &[f32; 4]) -> ([f32; 4], ()) {
        (*vertex, ())
    }

    #[inline(always)]
    fn frag(&self, (): &()) -> u16 {
        self.0
    }
}

impl Peer for Filled {
    fn name(&self) -> &'static str {
        "euc, Triangles"
    }

    fn version(&self) -> &'static str {
        "0.5.3"
    }

    fn work(&self) -> &'static str {
        "flat+depth"
    }

    fn given(&self) -> &'static str {
        "f32"
    }

    fn run(&mut self, faces: &[Face], timed: &mut dyn FnMut(&mut dyn FnMut())) {
        let corner = |c: crate::grid::Corner| [c.x / 120.0 - 1.0, 1.0 - c.y / 120.0, c.z, 1.0];
        self.faces = faces.iter().map(|face| (face.corners.map(corner), face.colour)).collect();
        self.pixels.clear(0);
        self.depths.clear(1.0);
        let Self { faces, pixels, depths } = self;
        timed(&mut || {
            for (corners, colour) in &*faces {
                Colour(*colour).draw::<Triangles<'_, _, BackfaceCullingDisabled>, _>(
                    corners,
                    pixels,
                    Some(depths),
                );
            }
        });
    }

    fn pixels(&self) -> Vec<u16> {
        self.pixels.as_ref().to_vec()
    }
}

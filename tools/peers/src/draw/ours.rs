//! topleft: a list of screen triangles, drawn into a whole frame.

use topleft::{
    Cull, Depth, Depth16, DrawList, Flat, Length, ListTriangle, Material, Matrix, MatrixCamera, Mesh,
    NoDepth, Pose, Strip,
};

use crate::grid::{Face, SIZE};
use crate::peer::Peer;

const VERSION: &str = "this";

/// A unit a pixel, the origin in the middle, y up; z from the eye in 1/960.
fn camera() -> MatrixCamera<false> {
    let rows = [[8, 0, 0, 0], [0, 8, 0, 0], [0, 0, 1, 480], [0, 0, 0, 960]];
    let size = embedded_graphics::geometry::Size::new(SIZE as u32, SIZE as u32);
    MatrixCamera::new(size, Matrix::new(rows.map(|row| row.map(Length::from_bits))))
}

/// The faces as a mesh, three vertices each; with buffers.
struct Buffers {
    positions: Vec<[i16; 3]>,
    faces: Vec<[u16; 3]>,
    colours: Vec<[u8; 3]>,
    words: Vec<u32>,
    triangles: Vec<ListTriangle>,
    pixels: Vec<u16>,
    depths: Vec<u16>,
}

impl Default for Buffers {
    fn default() -> Self {
        Self {
            positions: Vec::new(),
            faces: Vec::new(),
            colours: Vec::new(),
            words: vec![0; 1 << 16],
            triangles: vec![ListTriangle::EMPTY; 512],
            pixels: vec![0; SIZE * SIZE],
            depths: vec![0; SIZE * SIZE],
        }
    }
}

impl Buffers {
    fn prepare(&mut self, faces: &[Face]) {
        let corner = |corner: &crate::grid::Corner| {
            // A step is 1/16 px; z in 1/960 of the depth as the camera sees it.
            let [x, y] = [(corner.x - 120.0) * 16.0, (120.0 - corner.y) * 16.0];
            [x as i16, y as i16, ((corner.z - 0.5) * 960.0 * 16.0) as i16]
        };
        // Neighbours share their vertices, as in any mesh.
        self.positions.clear();
        self.faces.clear();
        for face in faces {
            self.faces.push(face.corners.each_ref().map(|c| {
                let position = corner(c);
                let known = self.positions.iter().position(|&other| other == position);
                known.unwrap_or_else(|| {
                    self.positions.push(position);
                    self.positions.len() - 1
                }) as u16
            }));
        }
        self.colours = faces
            .iter()
            .map(|face| {
                let [r, g, b] = [face.colour >> 11, face.colour >> 5 & 63, face.colour & 31];
                [r * 255 / 31, g * 255 / 63, b * 255 / 31].map(|c| c as u8)
            })
            .collect();
        self.pixels.fill(0);
        self.depths.fill(0);
    }
}

const ROWS: core::ops::Range<i32> = 0..SIZE as i32;
const FITS: &str = "the buffers are as large as the grid needs";

/// Draws a mesh into a list, and the list into a strip as tall as the frame; what is timed, the macro's user says.
macro_rules! ways {
    ($($(#[$doc:meta])* $way:ident, $name:literal, $given:literal, $work:literal, $depth:ty, $whole:literal;)*) => {$(
        $(#[$doc])*
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
                $given
            }

            fn run(&mut self, faces: &[Face], timed: &mut dyn FnMut(&mut dyn FnMut())) {
                self.0.prepare(faces);
                let Buffers { positions, faces, colours, words, triangles, pixels, depths } = &mut self.0;
                let mesh = Mesh::new(positions, faces)
                    .map(|mesh| mesh.with_box([Length::ZERO; 3], Length::lit("2048")))
                    .and_then(|mesh| mesh.with_face_colours(colours))
                    .expect("a mesh");
                let strip = Strip::new(SIZE as u16, pixels).expect(FITS);
                let mut strip = <$depth>::strip(strip, depths);
                let camera = camera();
                let mut list = DrawList::<u16, $depth>::new(words, triangles);
                let shader = Flat::new(Material::OfMesh);
                if $whole {
                    timed(&mut || {
                        list.clear();
                        list.set_cull(Cull::None);
                        list.draw(&camera, &mesh, &Pose::new(), &shader).expect(FITS);
                        list.render(ROWS, &mut strip);
                    });
                } else {
                    list.set_cull(Cull::None);
                    list.draw(&camera, &mesh, &Pose::new(), &shader).expect(FITS);
                    timed(&mut || list.render(ROWS, &mut strip));
                }
            }

            fn pixels(&self) -> Vec<u16> {
                self.0.pixels.clone()
            }
        }
    )*};
}

/// A strip with depth, or as it is.
trait Kept: Depth + Sized {
    fn strip<'s>(strip: Strip<'s, u16, NoDepth>, depths: &'s mut [u16]) -> Strip<'s, u16, Self>;
}

impl Kept for NoDepth {
    fn strip<'s>(strip: Strip<'s, u16, NoDepth>, _: &'s mut [u16]) -> Strip<'s, u16, Self> {
        strip
    }
}

impl Kept for Depth16 {
    fn strip<'s>(strip: Strip<'s, u16, NoDepth>, depths: &'s mut [u16]) -> Strip<'s, u16, Self> {
        strip.with_depth(depths).expect(FITS)
    }
}

ways! {
    /// What a frame takes: vertices to the screen, faces in order, and pixels.
    WholeDepth, "topleft, from the mesh", "a mesh", "flat+depth", Depth16, true;
    /// The list is made before: what the others are given as well.
    ListDepth, "topleft, from the list", "1/256 px", "flat+depth", Depth16, false;
    /// The same without depth.
    WholeFlat, "topleft, from the mesh", "a mesh", "flat", NoDepth, true;
    /// The same without depth.
    ListFlat, "topleft, from the list", "1/256 px", "flat", NoDepth, false;
}

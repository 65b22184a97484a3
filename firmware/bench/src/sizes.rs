//! Triangles of five sizes in every way of shading: what a triangle costs apart from its pixels.

use scenes::mesh::GRID240;
use scenes::texture::TEST_CARD;
use topleft::stages::Traversal;
use topleft::{
    Affine, Depth16, DrawError, DrawList, Flat, Gouraud, Length, Material, MatrixCamera, Mesh, MeshError,
    NoDepth, PerPixel, Pose, Subspans, Sun, Textured,
};

use crate::grid::matrix;
use crate::measure::{Bench, Buffers, Case, PANEL};

/// Triangles in a row and in a column of the screen.
const ROW: usize = 8;
pub(crate) const VERTICES: usize = 3 * ROW * ROW;

/// Triangles with sides of 1, in 1/1024, that lean in eight ways: counter-clockwise, y up.
#[rustfmt::skip]
const SHAPES: [[[i32; 2]; 3]; ROW] = [
    [[588, 59], [-345, 480], [-243, -539]],
    [[553, 209], [-458, 374], [-95, -583]],
    [[480, 345], [-539, 243], [59, -588]],
    [[374, 458], [-583, 95], [209, -553]],
    [[243, 539], [-588, -59], [345, -480]],
    [[95, 583], [-553, -209], [458, -374]],
    [[-59, 588], [-480, -345], [539, -243]],
    [[-209, 553], [-374, -458], [583, -95]],
];

/// Triangles of `side` pixels in the middles of 8 x 8 cells of the screen, each half a unit nearer than the one before.
pub(crate) const fn positions(side: i32) -> [[i16; 3]; VERTICES] {
    let mut positions = [[0; 3]; VERTICES];
    let mut i = 0;
    while i < VERTICES {
        let (triangle, corner) = (i / 3, i % 3);
        let (row, column) = (triangle / ROW, triangle % ROW);
        let shape = SHAPES[(row + 3 * column) % ROW][corner];
        // A step is 1/16 px, as in the grid.
        let (x, y) = ((30 * column as i32 - 105) * 16, (30 * row as i32 - 105) * 16);
        positions[i] =
            [(x + shape[0] * side / 64) as i16, (y + shape[1] * side / 64) as i16, 8 * triangle as i16];
        i += 1;
    }
    positions
}

/// A texel a pixel, of a texture of 64.
pub(crate) const fn uvs(positions: &[[i16; 3]; VERTICES]) -> [[i16; 2]; VERTICES] {
    let mut uvs = [[0; 2]; VERTICES];
    let mut i = 0;
    while i < VERTICES {
        uvs[i] = [4 * positions[i][0], -4 * positions[i][1]];
        i += 1;
    }
    uvs
}

/// Triangles that share no vertex.
pub(crate) const fn faces<const COUNT: usize>() -> [[u16; 3]; COUNT] {
    let mut faces = [[0; 3]; COUNT];
    let mut i = 0;
    while i < COUNT {
        faces[i] = [3 * i as u16, 3 * i as u16 + 1, 3 * i as u16 + 2];
        i += 1;
    }
    faces
}

static FACES: [[u16; 3]; ROW * ROW] = faces();

static COLOURS: [[u8; 3]; VERTICES] = {
    let mut colours = [[0; 3]; VERTICES];
    let mut i = 0;
    while i < VERTICES {
        let bits = (i as u32 + 1).wrapping_mul(0x9E37_79B1);
        colours[i] = [(bits >> 8) as u8, (bits >> 16) as u8, (bits >> 24) as u8];
        i += 1;
    }
    colours
};

static NORMALS: [[i8; 3]; VERTICES] = [[0, 0, 127]; VERTICES];

const fn checked(mesh: Result<Mesh<'static>, MeshError>) -> Mesh<'static> {
    match mesh {
        Ok(mesh) => mesh,
        Err(_) => panic!("the arrays are as long as each other"),
    }
}

pub(crate) const fn mesh(
    positions: &'static [[i16; 3]; VERTICES],
    uvs: &'static [[i16; 2]; VERTICES],
) -> Mesh<'static> {
    let mesh = checked(Mesh::new(positions, &FACES)).with_box([Length::ZERO; 3], GRID240.half());
    let mesh = checked(mesh.with_normals(&NORMALS));
    checked(checked(mesh.with_uvs(uvs, 3)).with_vertex_colours(&COLOURS))
}

macro_rules! sizes {
    ($($side:literal)*) => {
        /// By the triangles' side in pixels.
        static SIZES: [(&str, Mesh<'static>); 5] = [$((concat!("side-", $side), {
            static POSITIONS: [[i16; 3]; VERTICES] = positions($side);
            static UVS: [[i16; 2]; VERTICES] = uvs(&POSITIONS);
            mesh(&POSITIONS, &UVS)
        })),*];
    };
}

sizes! { 4 8 16 32 64 }

/// A unit a pixel, without perspective.
pub(crate) const LEVEL: MatrixCamera<false> =
    MatrixCamera::new(PANEL, matrix([[8, 0, 0, 0], [0, 8, 0, 0], [0, 0, -8, 480], [0, 0, 0, 960]]));

/// The same with w from 3/4 at the bottom to 5/4 at the top.
const RECEDING: MatrixCamera<true> =
    MatrixCamera::new(PANEL, matrix([[8, 0, 0, 0], [0, 8, 0, 0], [0, 0, -8, 480], [0, 2, 0, 960]]));

pub(crate) const PAINT: Material = Material::Colour([200, 80, 40]);

fn light() -> Sun {
    Sun::new([Length::ZERO, Length::ZERO, Length::ONE])
}

/// A case for each way of shading, at the size of that place.
macro_rules! ways {
    ($($case:ident, $method:literal, $depth:ty, $camera:ident, $shader:expr;)*) => {
        $(
            struct $case(usize);

            impl Case for $case {
                type Depth = $depth;

                fn method(&self) -> &'static str {
                    $method
                }

                fn scene(&self) -> &'static str {
                    SIZES[self.0].0
                }

                fn draw<T: Traversal>(
                    &self,
                    list: &mut DrawList<'_, u16, Self::Depth, T>,
                ) -> Result<(), DrawError> {
                    list.draw(&$camera, &SIZES[self.0].1, &Pose::new(), &$shader)
                }
            }
        )*

        /// Measures all ways of shading at all sizes.
        pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
            for size in 0..SIZES.len() {
                $(bench.case(&$case(size), buffers);)*
            }
        }
    };
}

ways! {
    FlatWay, "flat", NoDepth, LEVEL, Flat::new(PAINT);
    FlatDepthWay, "flat+depth", Depth16, LEVEL, Flat::new(PAINT);
    GouraudWay, "gouraud", NoDepth, LEVEL, Gouraud::unlit(&Material::OfMesh);
    GouraudDepthWay, "gouraud+depth", Depth16, LEVEL, Gouraud::unlit(&Material::OfMesh);
    AffineWay, "affine", NoDepth, LEVEL, Textured::new(&TEST_CARD, Affine);
    AffineDepthWay, "affine+depth", Depth16, LEVEL, Textured::new(&TEST_CARD, Affine);
    LitAffineDepthWay, "lit-affine+depth", Depth16, LEVEL, Textured::new(&TEST_CARD, Affine).lit_by(&light());
    SubspanWay, "perspective-subspan-16", NoDepth, RECEDING, Textured::new(&TEST_CARD, Subspans::Of16);
    SubspanDepthWay, "perspective-subspan-16+depth", Depth16, RECEDING, Textured::new(&TEST_CARD, Subspans::Of16);
    PixelWay, "perspective-pixel", NoDepth, RECEDING, Textured::new(&TEST_CARD, PerPixel);
    PixelDepthWay, "perspective-pixel+depth", Depth16, RECEDING, Textured::new(&TEST_CARD, PerPixel);
    LitPixelDepthWay, "lit-perspective-pixel+depth", Depth16, RECEDING, Textured::new(&TEST_CARD, PerPixel).lit_by(&light());
}

//! The grid of 512 triangles that other rasterizers were measured on: one case for each way to draw.

use scenes::mesh::{GRID240, GRID240_TILTED};
use scenes::texture::TEST_CARD;
use topleft::stages::Traversal;
use topleft::{
    Affine, Cull, Depth16, DepthFloat, Divided, DrawError, DrawList, Flat, Gouraud, Length, Material, Matrix,
    MatrixCamera, Mesh, NoDepth, Painter, PerPixel, Portable, Pose, Spans, Subspans, Textured, Within,
};

use crate::measure::{Bench, Buffers, Case, PANEL};

/// Measures all ways to draw the grid.
pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    bench.case(&FlatGrid, buffers);
    bench.case(&FlatPainterGrid, buffers);
    bench.case(&FlatDepthGrid, buffers);
    bench.case(&FlatDepthFloatGrid, buffers);
    bench.case(&GouraudDepthGrid, buffers);
    bench.case(&AffineGrid, buffers);
    bench.case(&AffineDepthGrid, buffers);
    bench.case(&Subspan16DepthGrid, buffers);
    bench.case(&WithinDepthGrid, buffers);
    bench.case(&PerspectiveDepthGrid, buffers);
    bench.case(&DividedDepthGrid, buffers);
    portable(bench, buffers);
}

/// Those that `topleft_thumb` has instructions for, by the library alone.
fn portable(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    bench.by::<Spans, _>("flat-portable", &FlatGrid, buffers);
    bench.by::<Spans, _>("flat-portable+depth", &FlatDepthGrid, buffers);
    bench.by::<Spans, _>("gouraud-portable+depth", &GouraudDepthGrid, buffers);
    bench.by::<Spans, _>("affine-portable", &AffineGrid, buffers);
    bench.by::<Spans, _>("affine-portable+depth", &AffineDepthGrid, buffers);
    bench.by::<Spans, _>("perspective-within-1/4-portable+depth", &WithinDepthGrid, buffers);
    bench.by::<Spans, _>("perspective-pixel-portable+depth", &PerspectiveDepthGrid, buffers);
}

const SCENE: &str = "grid240";

pub(crate) const fn matrix(rows: [[i32; 4]; 4]) -> Matrix {
    let mut elements = [[Length::ZERO; 4]; 4];
    let mut i = 0;
    while i < 16 {
        elements[i / 4][i % 4] = Length::from_bits(rows[i / 4][i % 4]);
        i += 1;
    }
    Matrix::new(elements)
}

/// A unit a pixel, the origin in the middle. Depth is a plane that slants both ways, as nothing is drawn level.
const FRONT: MatrixCamera<false> =
    MatrixCamera::new(PANEL, matrix([[8, 0, 0, 0], [0, 8, 0, 0], [1, 2, 0, 480], [0, 0, 0, 960]]));

/// 90 degrees from top to bottom, from 100 to 500 units: the tilted grid lies between 120 and 480.
const EYE: MatrixCamera<true> =
    MatrixCamera::new(PANEL, matrix([[4, 0, 0, 0], [0, 4, 0, 0], [0, 0, -5, -500], [0, 0, -4, 0]]));

/// A colour that differs from vertex to vertex in all channels.
static COLOURS: [[u8; 3]; 289] = {
    let mut colours = [[0; 3]; 289];
    let mut i = 0;
    while i < 289 {
        let bits = (i as u32 + 1).wrapping_mul(0x9E37_79B1);
        colours[i] = [(bits >> 8) as u8, (bits >> 16) as u8, (bits >> 24) as u8];
        i += 1;
    }
    colours
};

const COLOURED: Mesh<'static> = match GRID240.with_vertex_colours(&COLOURS) {
    Ok(mesh) => mesh,
    Err(_) => panic!("the grid has 289 vertices"),
};

/// Draws a mesh of the grid; both sides, as other rasterizers did.
macro_rules! cases {
    ($($case:ident, $method:literal, $depth:ty, $camera:ident, $mesh:ident, $shader:expr;)*) => {$(
        struct $case;

        impl Case for $case {
            type Depth = $depth;

            fn method(&self) -> &'static str {
                $method
            }

            fn scene(&self) -> &'static str {
                SCENE
            }

            fn draw<T: Traversal>(
                &self,
                list: &mut DrawList<'_, u16, Self::Depth, T>,
            ) -> Result<(), DrawError> {
                list.set_cull(Cull::None);
                list.draw(&$camera, &$mesh, &Pose::new(), &$shader)
            }
        }
    )*};
}

cases! {
    FlatGrid, "flat", NoDepth, FRONT, GRID240, Flat::new(Material::OfMesh);
    FlatPainterGrid, "flat+painter", Painter, FRONT, GRID240, Flat::new(Material::OfMesh);
    FlatDepthGrid, "flat+depth", Depth16, FRONT, GRID240, Flat::new(Material::OfMesh);
    FlatDepthFloatGrid, "flat+depth-float", DepthFloat, FRONT, GRID240, Flat::new(Material::OfMesh);
    GouraudDepthGrid, "gouraud+depth", Depth16, FRONT, COLOURED, Gouraud::unlit(&Material::OfMesh);
    AffineGrid, "affine", NoDepth, FRONT, GRID240, Textured::new(&TEST_CARD, Affine);
    AffineDepthGrid, "affine+depth", Depth16, EYE, GRID240_TILTED, Textured::new(&TEST_CARD, Affine);
    Subspan16DepthGrid, "perspective-subspan-16+depth", Depth16, EYE, GRID240_TILTED, Textured::new(&TEST_CARD, Subspans::Of16);
    WithinDepthGrid, "perspective-within-1/4+depth", Depth16, EYE, GRID240_TILTED, Textured::new(&TEST_CARD, Within::default());
    DividedDepthGrid, "perspective-divided+depth", Depth16, EYE, GRID240_TILTED, Textured::new(&TEST_CARD, Divided::<Portable>::new());
    PerspectiveDepthGrid, "perspective-pixel+depth", Depth16, EYE, GRID240_TILTED, Textured::new(&TEST_CARD, PerPixel);
}

//! Triangles strewn over the screen and beyond its edges, through each other: what rows of any kernel have to get right.

use scenes::texture::TEST_CARD;
use topleft::stages::{FlatPixel, GouraudPixel, Traversal};
use topleft::{
    Affine, Attribute, Coord, Cull, Depth16, DepthCode, DrawError, DrawList, Length, NoDepth, PerPixel,
    Point, ProjectedVertex, Textured, Within,
};

use crate::measure::{Bench, Buffers, Case, PANEL};
use crate::sizes::faces;

const TRIANGLES: usize = 300;

static FACES: [[u16; 3]; TRIANGLES] = faces();

static COLOURS: [[u8; 3]; TRIANGLES] = {
    let mut colours = [[0; 3]; TRIANGLES];
    let mut i = 0;
    while i < TRIANGLES {
        colours[i] = channels(i as u32 * 7);
        i += 1;
    }
    colours
};

/// Those of needles are black but for one corner, which is white.
const fn channels(vertex: u32) -> [u8; 3] {
    if needle(vertex).is_some() {
        return [if vertex % 3 == 1 { 255 } else { 0 }; 3];
    }
    let bits = hash(vertex);
    [(bits >> 8) as u8, (bits >> 16) as u8, (bits >> 24) as u8]
}

/// Each eighth triangle is a needle, a tenth of a pixel wide: which of them a vertex is of, counted from the last.
const fn needle(vertex: u32) -> Option<i32> {
    let triangle = vertex / 3;
    if triangle % 8 == 7 { Some(TRIANGLES as i32 / 8 - 1 - (triangle / 8).cast_signed()) } else { None }
}

/// A column and a row, w, and a texel.
type Corner = ([i32; 2], i32, [i32; 2]);

/// The last two triangles have corners in centres of pixels and in corners of texels: on an edge of each, a coordinate over w is a
/// step below 0 at a pixel of either octave. These are the first one's; of the other, u and v change places.
const CENTRES: [Corner; 3] = [([8, 0], 1, [0, 0]), ([6, 4], 2, [0, 16]), ([13, 5], 2, [16, 0])];

/// Which of them a vertex is of, and the corner that it is.
fn centre(vertex: u32) -> Option<(i32, Corner)> {
    let first = 3 * (TRIANGLES as u32 - 2);
    let place = vertex.checked_sub(first)?;
    Some(((place / 3).cast_signed(), CENTRES[place as usize % 3]))
}

/// Up to a few hundred texels from a corner, on either side.
fn texel(vertex: u32) -> [Attribute; 2] {
    if let Some((triangle, (_, _, [u, v]))) = centre(vertex) {
        return (if triangle == 0 { [u, v] } else { [v, u] }).map(|texel| Attribute::from_bits(texel << 16));
    }
    let bits = hash(vertex).cast_signed();
    [bits >> 8, bits << 9 >> 7].map(Attribute::from_bits)
}

const fn hash(number: u32) -> u32 {
    let bits = (number + 1).wrapping_mul(0x9E37_79B1);
    (bits ^ bits >> 15).wrapping_mul(0x85EB_CA77)
}

/// From 1 to 3: most triangles have one or two octaves of it, and some have three.
fn distance(vertex: u32) -> Length {
    if let Some((_, (_, w, _))) = centre(vertex) {
        return Length::from_bits(w << 16);
    }
    Length::from_bits(((1 << 16) + (hash(vertex + 30_000) >> 15)).cast_signed())
}

/// Triangle after triangle up to 1, 2, 4 .. 64 px wide and high, and back to 1, at any depths; and needles, which channels change fast on.
fn vertex<A: Copy>(vertex: u32, attributes: fn(u32) -> A) -> ProjectedVertex<A> {
    let at = if let Some((triangle, ([column, row], ..))) = centre(vertex) {
        let [x, y] = [column + 20 * triangle, row].map(|place| Coord::from_bits((place << 8) + 128));
        Point::new(x, y)
    } else if let Some(needle) = needle(vertex) {
        let [x, y] = [[0, 0], [25, 0], [12, 4096]][vertex as usize % 3];
        let (x, y) = (51_316 + x - 256 * 5 * needle, 2_560 + y + 256 * 5 * needle);
        Point::new(Coord::from_bits(x), Coord::from_bits(y))
    } else {
        let (middle, corner) = (hash(vertex / 3 + 10_000), hash(vertex));
        let size = 8 + vertex / 3 % 7;
        // From 8 px outside on one side to 8 px outside on the other.
        let place = |middle: u32, corner: u32| {
            let at = ((middle & 0xFFFF) * (256 << 8)) >> 16;
            Coord::from_bits((at + ((corner & 0xFFFF) >> (16 - size))).cast_signed() - (8 << 8))
        };
        Point::new(place(middle, corner), place(middle >> 16, corner >> 16))
    };
    let depth = if centre(vertex).is_some() { u32::MAX } else { hash(vertex + 20_000) };
    let depth = DepthCode::from_bits(depth);
    ProjectedVertex::new(at, attributes(vertex)).with_depth(depth).with_w(distance(vertex))
}

/// A case for each way of shading.
macro_rules! ways {
    ($($case:ident, $method:literal, $depth:ty, $shader:expr, $attributes:expr;)*) => {
        $(
            struct $case;

            impl Case for $case {
                type Depth = $depth;

                fn method(&self) -> &'static str {
                    $method
                }

                fn scene(&self) -> &'static str {
                    "strewn"
                }

                fn draw<T: Traversal>(
                    &self,
                    list: &mut DrawList<'_, u16, Self::Depth, T>,
                ) -> Result<(), DrawError> {
                    list.set_cull(Cull::None);
                    let vertices = (0..3 * TRIANGLES).map(|i| vertex(i as u32, $attributes));
                    list.draw_projected(PANEL, vertices, &FACES, &COLOURS, &$shader)
                }
            }
        )*

        /// Measures all ways of shading that a kernel may have.
        pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
            $(bench.case(&$case, buffers);)*
        }
    };
}

ways! {
    FlatWay, "flat", NoDepth, FlatPixel, |_| ();
    FlatDepthWay, "flat+depth", Depth16, FlatPixel, |_| ();
    GouraudWay, "gouraud", NoDepth, GouraudPixel, channels;
    GouraudDepthWay, "gouraud+depth", Depth16, GouraudPixel, channels;
    AffineWay, "affine", NoDepth, Textured::new(&TEST_CARD, Affine), texel;
    AffineDepthWay, "affine+depth", Depth16, Textured::new(&TEST_CARD, Affine), texel;
    PerspectiveWay, "perspective-pixel", NoDepth, Textured::new(&TEST_CARD, PerPixel), texel;
    PerspectiveDepthWay, "perspective-pixel+depth", Depth16, Textured::new(&TEST_CARD, PerPixel), texel;
    WithinDepthWay, "perspective-within-1/4+depth", Depth16, Textured::new(&TEST_CARD, Within::default()), texel;
}

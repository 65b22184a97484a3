//! topleft's small triangles in the Thumb instructions of a Cortex-M: the same bytes, faster.
//!
//! A Cortex-M0+ has eight registers that all of its instructions reach, and a compiler keeps a row of pixels in no fewer than
//! ten. So rows are written by hand here, for what most scenes are made of: flat, Gouraud and affine triangles, and those with a
//! reciprocal a pixel ([`PerPixel`](topleft::PerPixel), and [`Within`](topleft::Within)), less than 32 px wide and high, in strips
//! of `u16` that are at most 2047 px wide, without depth or with [`Depth16`](topleft::Depth16).
//!
//! All else is drawn by the library itself: textures that end ([`Wrap::Clamp`](topleft::Wrap)) or are under light; perspective by
//! any other method, or over more than two octaves of 1/w; triangles that reach over the left or right edge of the strip; and all
//! of them on chips without these instructions. Gouraud without depth gains on cores only that have no products of 64 bits, such
//! as a Cortex-M0+.
//!
//! Sides of small triangles are found here too, whatever is drawn between them.
//!
//! It is a traversal, which a list is made with:
//!
//! ```
//! use embedded_graphics_core::geometry::Size;
//! use topleft::{Flat, Length, ListStorage, Material, Orthographic, Pose, Strip};
//! use topleft_thumb::Spans;
//!
//! let (mut storage, mut colours) = (ListStorage::<100, 12>::new(), [0_u16; 16 * 16]);
//! let mut list = storage.list_with_traversal::<_, _, Spans>();
//! let camera = Orthographic::new(Size::new(16, 16), 4.0, -9.0..9.0);
//! let white = Flat::new(Material::Colour([255; 3]));
//! list.draw(&camera, &scenes::mesh::CUBE, &Pose::new(), &white).unwrap();
//! list.render(0..16, &mut Strip::new(16, &mut colours).unwrap());
//! assert_eq!(colours.iter().filter(|&&colour| colour == 0xFFFF).count(), 8 * 8);
//! ```
#![no_std]

use topleft::SpansBy;
#[cfg(thumb)]
use topleft::stages::{FoundSides, SmallTriangle};
use topleft::stages::{Kernel, Rows};

#[cfg(thumb)]
mod affine;
#[cfg(thumb)]
mod edges;
#[cfg(thumb)]
mod flat;
#[cfg(thumb)]
mod gouraud;
#[cfg(thumb)]
mod perspective;
#[cfg(thumb)]
mod single_pass;
#[cfg(thumb)]
mod walk;

/// [`topleft::Spans`], with small triangles in Thumb instructions.
pub type Spans = SpansBy<Thumb>;

/// The kernel: whole triangles in Thumb instructions, of all that it has them for.
#[derive(Clone, Copy, Debug)]
pub enum Thumb {}

#[cfg(not(thumb))]
impl Kernel for Thumb {
    #[inline(always)]
    fn draw(_: Rows<'_>) -> bool {
        false
    }
}

#[cfg(thumb)]
impl Kernel for Thumb {
    #[inline(always)]
    fn draw(rows: Rows<'_>) -> bool {
        use topleft::Wrap;
        use topleft::stages::{Shade, Tested};

        match (rows.shade(), rows.tested()) {
            (Shade::Flat(colour), Tested::Never) => flat::draw(rows, colour),
            (Shade::Flat(colour), Tested::Depth16(depth)) => flat::draw_tested(rows, depth, colour),
            // Where products of 64 bits are instructions, the library's own rows are no slower without depth.
            #[cfg(not(narrow))]
            (Shade::Gouraud(_), Tested::Never) => return false,
            #[cfg(narrow)]
            (Shade::Gouraud(channels), Tested::Never) => gouraud::draw(rows, &channels),
            (Shade::Gouraud(channels), Tested::Depth16(depth)) => {
                gouraud::draw_tested(rows, depth, &channels);
            }
            // Each by itself, so that no shader links another's.
            (Shade::Affine(texture, _), _) if texture.wrap() != Wrap::Repeat => return false,
            (Shade::Affine(texture, texels), Tested::Never) => affine::draw(rows, &texture, &texels),
            (Shade::Affine(texture, texels), Tested::Depth16(depth)) => {
                affine::draw_tested(rows, depth, &texture, &texels);
            }
            (Shade::Perspective(texture, _), _) if texture.wrap() != Wrap::Repeat => return false,
            (Shade::Perspective(texture, texels), Tested::Never) => {
                perspective::draw(rows, &texture, &texels);
            }
            (Shade::Perspective(texture, texels), Tested::Depth16(depth)) => {
                perspective::draw_tested(rows, depth, &texture, &texels);
            }
        }
        true
    }

    #[inline(always)]
    fn sides(triangle: SmallTriangle<'_>) -> FoundSides<'_> {
        edges::sides(&triangle)
    }
}

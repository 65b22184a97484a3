//! One name for each number format of the data path.
//!
//! | role | type | range | step | rounding |
//! |---|---|---|---|---|
//! | model position | `i16` | -1 to 1 - 2^-15 of the mesh's half box | 2^-15 | nearest, by `meshpack` |
//! | scene length | [`Length`] | ±32 768 units | 2^-16 | nearest |
//! | clip x, y, z, w | [`Clip`] | ±2^30 in a mesh's own power of two | 1 | down, at most 3 steps |
//! | screen x, y | [`Coord`] | ±8 388 608 px | 1/256 px | nearest, once |
//! | depth plane | [`DepthCode`] | 0 to 65 536 codes, 0 is far | 2^-16 code | nearest |
//! | attribute plane | [`Attribute`] | ±32 768 | 2^-16 | nearest |
//! | 1/w | [`Inverse`] | 0 to 1 of the triangle's largest | 2^-31 | down |

use fixed::types::{I1F31, I16F16, I24F8, U16F16};

/// A length in the scene's own unit: ±32 768 in steps of 2^-16. `Length::lit("0.01")` is a literal,
/// `Length::from_num(x)` a number that is known later.
pub type Length = I16F16;

/// A screen coordinate in pixels: ±8 388 608 in steps of 1/256.
///
/// x grows to the right and y down; the centre of the top left pixel is at (0.5, 0.5).
pub type Coord = I24F8;

/// A depth in codes of [`Depth16`](crate::Depth16), with 16 fraction bits for interpolation: 0 is far, greater is nearer.
/// [`DepthFloat`](crate::DepthFloat) makes its codes of all 32 bits.
pub type DepthCode = U16F16;

/// An attribute that is interpolated over a triangle: texels, or steps of a colour channel. Made as a [`Length`] is.
pub type Attribute = I16F16;

/// 1/w as a fraction of a power of two at least as large as the triangle's largest.
pub type Inverse = I1F31;

/// A homogeneous clip coordinate: an integer in a power of two that all vertices of a mesh share.
///
/// Only ratios of clip coordinates mean anything, so the power itself is dropped.
pub(crate) type Clip = i32;

/// Bits after the point of a [`Coord`].
pub(crate) const SUBPIXEL_BITS: u32 = 8;
/// Steps of a [`Coord`] in a pixel.
pub(crate) const SUBPIXELS: i32 = 1 << SUBPIXEL_BITS;
/// From a pixel's corner to its centre, in steps of a [`Coord`].
pub(crate) const HALF_PIXEL: i32 = SUBPIXELS / 2;

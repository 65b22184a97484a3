//! Shaded, textured, depth-tested triangles for microcontroller displays: integers only, every pixel exactly once, the
//! same bytes on every chip. No `std`, no allocation, no `unsafe`.
//!
//! # Three ways to draw
//!
//! One triangle on any embedded-graphics display, with no buffer at all:
//!
//! ```
//! use embedded_graphics::mock_display::MockDisplay;
//! use embedded_graphics::pixelcolor::Rgb565;
//! use embedded_graphics::prelude::*;
//! use topleft::{ShadedTriangle, point};
//!
//! # let mut display = MockDisplay::<Rgb565>::new();
//! ShadedTriangle::new(
//!     [point(2.0, 1.25), point(60.25, 9.0), point(20.0, 50.5)],
//!     [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE],
//! )
//! .draw(&mut display)?;
//! # assert_eq!(display.affected_area().bottom_right(), Some(Point::new(59, 49)));
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! A mesh, with depth, through strips of 16 rows. The vertex work is done once a frame, in [`DrawList::draw`]:
//!
//! ```
//! use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
//! use embedded_graphics::prelude::*;
//! use topleft::{Gouraud, Length, ListStorage, Material, Perspective, Pose, Strip, Sun, Turn};
//! # use scenes::mesh::TEAPOT;
//! # let mut display = embedded_graphics_simulator::SimulatorDisplay::<Rgb565>::new(Size::new(240, 240));
//!
//! let camera = Perspective::new(Size::new(240, 240), Turn::from_degrees(50), 0.5..6.0)
//!     .look_at([0.0, 1.0, 2.2], [0.0; 3]);
//! let sun = Sun::new([Length::lit("-0.5"), Length::ONE, Length::ONE]);
//! let brass = Material::from(Rgb888::new(0xE0, 0xA8, 0x50));
//! let pose = Pose::new().turned_y(Turn::from_degrees(30));
//!
//! let mut storage: ListStorage<3048, 900> = ListStorage::new(); // words for vertices, and triangles
//! let (mut colours, mut depths) = ([Rgb565::BLACK; 240 * 16], [0; 240 * 16]);
//! let mut strip = Strip::new(240, &mut colours)?.with_depth(&mut depths)?;
//!
//! let mut list = storage.list();
//! list.draw(&camera, &TEAPOT, &pose, &Gouraud::new(&sun, &brass))?; // Err(Full { .. }) says what did not fit
//! list.present(&mut strip, &mut display)?; // one fill_contiguous a strip
//! # assert_eq!(list.stats().faces, 1200);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! A program with a vertex stage of its own, or a drawing in two dimensions, hands vertices that are on the screen already to
//! [`DrawList::draw_projected`]: no mesh, no camera, and no code for them, in a list like any other.
//!
//! Without a depth buffer, [`DrawList::sort`] puts a list in painter's order, and one convex mesh needs only its back faces
//! culled: [`Hiding::cheapest`] tells which way is safe for a scene.
//!
//! The same list into a whole frame is `list.render(0..240, &mut frame)`, with a strip as tall as the target. Rendering
//! changes nothing in the list, so two cores can render different rows of it. Strips that one core renders in order take
//! fewer cycles by [`DrawList::render_next`].
//!
//! A list is made with a traversal: [`Spans`], [`BySize`] for the smallest triangles, or [`SpansBy`] a chip's own
//! [`Kernel`](stages::Kernel), which draws the same bytes faster.
//!
//! # The way of the data
//!
//! ```text
//! mesh --Face--> transform --Position--> clip --ClipVertex--> setup --Setup--> raster --Span--> depth --Run--> shade --colours--> target
//! ```
//!
//! # Promises
//!
//! 1. **Watertight.** At the snapped, clipped vertices coverage is the exact answer, and a pixel centre on a shared edge
//!    belongs to exactly one triangle: no cracks and no double hits, whatever the triangles, the strips or the traversal.
//!    (`tests/coverage`, `tests/stability`)
//! 2. **The same everywhere.** The same scene gives the same bytes, whole frame or in strips, whichever vertex a
//!    triangle starts with, and whichever chip draws it. (`tests/same_bytes`, `tests/projected`,
//!    `firmware/bench/tests/same_everywhere.rs`)
//! 3. **A stated error.** A value with 16 fraction bits, n columns and m rows from its triangle's first vertex, is off by
//!    at most `(n + m + 2) 2^-17 + D 2^-30`, with D the largest difference between vertices; a texel that is found with
//!    [`PerPixel`] by at most `U 2^-13`, with U the power of two of texels that holds the triangle's, up to a ratio of w
//!    of 64 and within 500 pixels of that vertex; with [`Within`] by what the caller allows, if that is more, and the value's
//!    share above; a colour of [`GouraudWithin`] likewise, in codes; a depth by `(n + m + 2) 2^-17 + 2^-11` codes of
//!    [`Depth16`], and that of a [`DepthFloat`] as it says.
//!    (`tests/against_reference`, `tests/stability`)
//! 4. **It does not fail.** Any `i32` and any `f32` is legal input. What cannot be drawn is clipped, culled, or left out
//!    and counted; what does not fit is handed back to the caller. No panic can be reached in an image for a chip.
//!    (`tests/any_input`, `fuzz`, `tools/link-check`)
//! 5. **Pay for what the scene uses.** Depth, texture, light and perspective are type parameters and shaders: a scene
//!    without them has no buffer, no cycle and no code for them. Where nothing is hidden that a depth buffer would be needed
//!    for, [`Hiding::cheapest`] says so. (`firmware/measure.sh`, `tests/hiding`)
//!
//! What was measured, from the tables of `docs/measured`, whose rows are named here by their first columns:
//!
//! | promise | table and row | measured | bound | unit |
//! |---|---|---|---|---|
//! | 1 | accuracy: coverage, random meshes, spans and box walk, mismatches | 0 | 0 | of 182522554 px hit; 2000 meshes with 644126 triangles |
//! | 2 | rp2040: grid240, gouraud+depth, 3, 240 | ab13ef1b | | crc |
//! | 2 | cortex-m4: grid240, gouraud+depth, s, 16 | ab13ef1b | | crc |
//! | 3 | accuracy: vertices, every z of 16 bits, w to 1:64, place | 0.5000 | 0.5016 | 1/256 px |
//! | 3 | accuracy: interpolation, full-screen triangles, colour, value | 0.003763 | 0.004463 | code of 255 |
//! | 3 | accuracy: depth, triangles over 256 px, perspective, beyond its code | 0.001558 | 0.003534 | code |
//! | 3 | accuracy: texels, full-screen triangles, per pixel w 1:64, of 256 | 0.006727 | 0.02641 | texel |
//! | 3 | accuracy: texels, triangles of all sizes, within 1/4 texel, as allowed | 0.2186 | 0.2543 | texel |
//! | 3 | accuracy: light, random suns, vertex, lit colour | 0.5272 | 0.5701 | code of 255 |
//! | 5 | rp2040: grid240, flat, 3, 240 | 11.6 | | cycles_per_pixel |
//! | 5 | rp2040: grid240, perspective-pixel+depth, 3, 240 | 93.9 | | cycles_per_pixel |
//!
//! # Conventions
//!
//! * Scenes are right-handed with y up, and a camera looks along its own -z. Lengths are in the scene's own unit.
//! * Clip space has x and y in [-w, w], and z from 0 at the near plane to w at the far one.
//! * Screen x grows to the right and y down, and pixel centres lie at .5. Vertices are snapped to 1/256 px, rounded to
//!   nearest, halves up, before anything else is computed from them.
//! * A pixel is covered where its centre is inside a triangle, or on a top or left edge of it.
//! * Front faces are counter-clockwise as the viewer sees them, as in OBJ files.
//! * Depth is a `u16`, linear on the screen or a small float: 0 is cleared, greater is nearer, and of two that are equal the
//!   earlier stays.
//! * Texture coordinates start at the top left corner of the texture, and v grows down.
//! * Colours and light are computed in code values: no gamma.
//!
//! # Not there
//!
//! Mip levels, filtering, blending, edge anti-aliasing, normal maps, lines and points.
#![no_std]
#![cfg_attr(not(test), deny(clippy::disallowed_types, clippy::float_arithmetic))]

mod math;

mod mesh;
mod convex;
mod texture;
mod blob;

mod viewport;
mod pose;
mod camera;

mod snapped;
mod point;
mod attributes;
mod retained;
mod transform;
mod clip;

mod gradients;
mod varying;
mod setup;
mod raster;
mod fill;
mod depth;
mod hiding;
mod run;
mod pixel;
mod shade;

mod pipeline;
mod target;
mod list;
mod triangle;

pub use blob::{Aligned, BlobError};
pub use camera::{Camera, MatrixCamera, Orthographic, Perspective};
pub use depth::{Depth, Depth16, DepthFloat, NoDepth, Painter};
pub use hiding::Hiding;
pub use list::{DrawError, DrawList, ListStorage, ListTriangle, ProjectedVertex, SortError, Stats};
pub use math::format::{Attribute, Coord, DepthCode, Inverse, Length};
pub use math::matrix::Matrix;
pub use math::turn::Turn;
pub use mesh::{MAX_UV_EXPONENT, MAX_VERTICES, Mesh, MeshError};
pub use pixel::Pixel;
pub use point::{Point, point};
pub use pose::Pose;
pub use raster::{BoxWalk, BySize, Spans, SpansBy};
pub use setup::Cull;
pub use shade::{
    Affine, ColourError, Divide, Divided, Flat, Gouraud, GouraudWithin, Lighting, LitTexture, Material,
    PerPixel, Portable, Subspans, Sun, Textured, Unlit, Within,
};
pub use target::{Strip, StripError};
pub use texture::{MAX_TEXTURE_SIZE, Texture, TextureError, Wrap};
pub use triangle::ShadedTriangle;
pub use viewport::{TooLarge, Viewport};

/// The stages themselves, for shaders, cameras and traversals of your own, and for tests.
pub mod stages {
    pub use crate::attributes::{Attributes, Fraction, Words};
    pub use crate::gradients::{Gradients, Plane};
    pub use crate::pixel::Stepped;
    pub use crate::raster::{
        DrawSpan, FoundSides, Kernel, Rows, Shade, ShortEdge, Sides, SmallTriangle, Span, Tested,
        TexelsOverW, Trapezoids, Traversal, Window,
    };
    pub use crate::run::{Place, Run};
    pub use crate::setup::Setup;
    pub use crate::shade::{
        Correction, DrawTexels, DrawTriangle, FlatPixel, GouraudPixel, PixelShader, Sampler, Shader, Uniforms,
    };
    pub use crate::snapped::Snapped;
    pub use crate::transform::PerVertexInverse;
    pub use crate::varying::Varying;
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

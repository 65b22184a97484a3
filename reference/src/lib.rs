//! The reference that `topleft` is compared with: brute force in `f64`, and in `i128` where an answer must be exact.
//!
//! It has the library's stages under the library's names, and shares its data types (meshes, textures) but none of
//! its arithmetic: every formula is written out here a second time, in the plainest way.
//!
//! ```text
//! mesh -> transform -> clip -> setup -> raster -> varying -> depth -> shade -> image
//!                      `homogeneous` is the coverage of all up to raster, without a clipper
//!                      `render` calls them in order, `compare` measures the distance between two results
//! ```
//!
//! The conventions are the library's: right-handed world with y up, the camera looks along -Z, clip x and y in
//! \[-w, w\], z in \[0, w\] with 0 near, screen y down with pixel centres at .5, front faces counter-clockwise as the
//! viewer sees them, greater depth is nearer, colours in code values 0 to 255 without gamma.

pub mod matrix;

pub mod transform;
pub mod clip;
pub mod setup;
pub mod raster;
pub mod homogeneous;
pub mod varying;
pub mod depth;
pub mod shade;
pub mod image;

pub mod render;

pub mod compare;

pub mod naive;

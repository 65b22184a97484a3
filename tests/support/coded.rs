//! The codes of a depth buffer as the reference has them.

use reference::depth::small_float;
use reference::transform::{CODES, FAR_CODE};
use topleft::{Depth16, DepthFloat};

use super::frame::Strips;
use super::tolerance::{DEPTH_VERTEX, float_depth, interpolation};

/// A depth of the library, and what its codes are of `1 - z / w`.
pub(crate) trait Coded: Strips {
    /// The code, not rounded.
    fn code(nearness: f64) -> f64;

    /// What it may be off by, so many pixels from the first vertex, where vertices differ by `range`.
    fn bound(nearness: f64, steps: u64, range: f64) -> f64;
}

impl Coded for Depth16 {
    fn code(nearness: f64) -> f64 {
        FAR_CODE + CODES * nearness
    }

    fn bound(_: f64, steps: u64, range: f64) -> f64 {
        interpolation(16, steps, CODES * range) + DEPTH_VERTEX
    }
}

impl Coded for DepthFloat {
    fn code(nearness: f64) -> f64 {
        small_float(nearness)
    }

    fn bound(nearness: f64, steps: u64, range: f64) -> f64 {
        float_depth(small_float, nearness, steps, range)
    }
}

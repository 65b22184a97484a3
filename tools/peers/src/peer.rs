//! What a rasterizer has to do here.

use crate::grid::Face;

/// A rasterizer with its buffers of 240x240 pixels.
pub(crate) trait Peer {
    /// The package, and what of it draws.
    fn name(&self) -> &'static str;

    /// Its version.
    fn version(&self) -> &'static str;

    /// What is done to each pixel: the same words for the same work.
    fn work(&self) -> &'static str;

    /// What it is given.
    fn given(&self) -> &'static str;

    /// Takes the faces in its own form, clears its buffers, and hands what draws them once to `timed`.
    fn run(&mut self, faces: &[Face], timed: &mut dyn FnMut(&mut dyn FnMut()));

    /// The pixels in RGB565: 0 where nothing was drawn.
    fn pixels(&self) -> Vec<u16>;
}

//! The rows of topleft's triangles in the instructions of a Cortex-M0, M0+ or M1.
#![no_std]

use topleft::stages::{Kernel, Rows};

#[cfg(armv6m)]
mod flat;
#[cfg(armv6m)]
mod flat_depth;
#[cfg(armv6m)]
mod gouraud;
#[cfg(armv6m)]
mod texels;

/// `DrawList`'s traversal.
pub type Spans = topleft::SpansBy<Armv6m>;

/// The kernel.
#[derive(Clone, Copy, Debug)]
pub enum Armv6m {}

impl Kernel for Armv6m {
    #[inline(always)]
    #[cfg(not(armv6m))]
    fn draw(_: Rows<'_>) -> bool {
        false
    }

    #[inline(always)]
    #[cfg(armv6m)]
    fn draw(mut rows: Rows<'_>) -> bool {
        use topleft::stages::{Shade, Tested};
        let (trapezoids, stride) = (rows.trapezoids(), 2 * rows.width());
        let shade = *rows.shade();
        let (colours, tested) = rows.cells();
        let colours = colours.as_mut_ptr();
        match (shade, tested) {
            (Shade::Flat(colour), Tested::Never) => flat::draw(trapezoids, colours, stride, colour),
            (Shade::Flat(colour), Tested::Depth16(depths, plane)) => {
                flat_depth::draw(trapezoids, colours, stride, depths.as_mut_ptr(), plane, colour);
            }
            (Shade::Gouraud(channels), Tested::Never) => {
                gouraud::draw(trapezoids, colours, stride, &channels)
            }
            (Shade::Gouraud(channels), Tested::Depth16(depths, plane)) => {
                gouraud::draw_depth(trapezoids, colours, stride, depths.as_mut_ptr(), plane, &channels);
            }
            (Shade::Affine(texture, _), _) if texture.wrap() != topleft::Wrap::Repeat => return false,
            (Shade::Affine(texture, plane), Tested::Never) => {
                texels::draw(trapezoids, colours, stride, &texture, &plane)
            }
            (Shade::Affine(texture, plane), Tested::Depth16(depths, depth)) => {
                texels::draw_depth(trapezoids, colours, stride, depths.as_mut_ptr(), depth, &texture, &plane);
            }
        }
        true
    }
}

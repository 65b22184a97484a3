//! Plane equations from values at three vertices.
//!
//! Gradients come from one normalised reciprocal of the doubled area: `g = (d1 dy2 - d2 dy1) / area2`, the numerator
//! exact, the product with the reciprocal as well, and one rounding to nearest. An error of the reciprocal scales the
//! plane about its first vertex, so it is harmless even for slivers.

use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS};
use crate::snapped::Snapped;

mod rough;
mod small;
mod wide;

/// A plane equation: its value at the anchor pixel's centre, and its step a pixel to the right and a pixel down.
///
/// The value at a pixel that is n columns and m rows from the anchor is off by at most `(n + m + 2) / 2` steps of the
/// format, rounding, and 2^-30 of the largest difference between vertices, the reciprocal of the area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plane<V> {
    /// The value at the anchor: the centre of the pixel that holds the triangle's first vertex.
    pub start: V,
    /// A pixel to the right.
    pub dx: V,
    /// A pixel down.
    pub dy: V,
}

/// The reciprocal of the area and the edges from the first vertex: what all planes of a triangle share.
#[derive(Clone, Copy, Debug)]
pub struct Gradients {
    /// To the right and down.
    axes: [Axis; 2],
    area: Area,
    anchor: [i32; 2],
}

/// One of the screen's two, for planes: their gradient along it is `(d1 second - d2 first) / area2`, where d1 and d2 are
/// the differences of the second and the third value from the first.
#[derive(Clone, Copy, Debug)]
struct Axis {
    /// Across the axis from the first vertex to the third, in 1/256 px.
    second: i32,
    /// The same to the second.
    first: i32,
    /// Along it from the first vertex to the anchor's centre, in 1/256 px.
    to_anchor: i32,
}

/// One over the doubled area.
#[derive(Clone, Copy, Debug)]
enum Area {
    /// No two vertices are 32 px or more apart on an axis, and the area is less than 2^8 px^2.
    Small(small::Area),
    Any(wide::Area),
}

impl Gradients {
    /// Of a triangle in canonical order, with an area; `small` where no two vertices are 32 px or more apart on an axis.
    /// Planes start at the pixel in a column and a row, less than 2^13 of either from the first vertex.
    #[inline]
    pub(crate) fn new([a, b, c]: &[Snapped; 3], area2: i64, small: bool, column: i32, row: i32) -> Self {
        // Where vertices are near, 32 bits hold the area.
        let near = area2 as i32;
        let area = if small && near.unsigned_abs() >> small::AREA_BITS == 0 {
            Area::Small(small::Area::new(near))
        } else {
            Area::Any(wide::Area::new(area2))
        };
        // The area before the axes: a small core has no registers for both.
        core::hint::black_box(());
        let [(ax, ay), (bx, by), (cx, cy)] = [a.bits(), b.bits(), c.bits()];
        let to_centre = |pixel: i32, coordinate: i32| (pixel << SUBPIXEL_BITS) + HALF_PIXEL - coordinate;
        let right = Axis { second: cy - ay, first: by - ay, to_anchor: to_centre(column, ax) };
        let down = Axis { second: ax - cx, first: ax - bx, to_anchor: to_centre(row, ay) };
        Self { axes: [right, down], area, anchor: [column, row] }
    }

    /// The column and row of the pixel that planes start from: the one that holds the first vertex.
    #[inline]
    pub const fn anchor(&self) -> [i32; 2] {
        self.anchor
    }

    /// The plane through three values, in canonical order, modulo 2^32.
    #[inline(never)]
    pub(crate) fn plane(&self, a: i32, b: i32, c: i32) -> Plane<i32> {
        match &self.area {
            Area::Small(area) => self.through(a, area.gradients([a, b, c])),
            Area::Any(area) => self.through(a, |axis| area.gradient(axis, &[a, b, c])),
        }
    }

    /// The planes through the channels of three colours, from 0 to 2^24, in canonical order.
    #[inline(never)]
    pub(crate) fn channels(&self, colours: &[[i32; 3]; 3]) -> Plane<[i32; 3]> {
        let [[ar, ag, ab], [br, bg, bb], [cr, cg, cb]] = *colours;
        let rough = match &self.area {
            Area::Small(area) => area.rough(),
            Area::Any(_) => None,
        };
        let (r, g, b) = if let Some(rough) = rough {
            let plane = |a: i32, b: i32, c: i32| self.through(a, rough.gradients([a, b, c]));
            (plane(ar, br, cr), plane(ag, bg, cg), plane(ab, bb, cb))
        } else {
            (self.plane(ar, br, cr), self.plane(ag, bg, cg), self.plane(ab, bb, cb))
        };
        Plane { start: [r.start, g.start, b.start], dx: [r.dx, g.dx, b.dx], dy: [r.dy, g.dy, b.dy] }
    }

    /// The plane of a value at the first vertex and its gradient along each axis.
    #[inline(always)]
    fn through(&self, first: i32, gradient: impl Fn(&Axis) -> Gradient) -> Plane<i32> {
        let [right, down] = &self.axes;
        let (dx, dy) = (gradient(right), gradient(down));
        let (ox, oy) = (right.to_anchor, down.to_anchor);
        // A gradient is multiplied by less than 2^21 and divided by 256: as its whole steps of 256, and what is below them.
        let whole = dx.over_256.wrapping_mul(ox).wrapping_add(dy.over_256.wrapping_mul(oy));
        let below = (dx.low & 255) * ox + (dy.low & 255) * oy;
        let start = first.wrapping_add(whole).wrapping_add((below + 128) >> 8);
        Plane { start, dx: dx.low, dy: dy.low }
    }
}

/// A gradient of up to 64 bits: its low 32 bits, and those of a 256th of it, rounded down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Gradient {
    low: i32,
    over_256: i32,
}

#[cfg(test)]
mod tests {
    use crate::setup::Setup;
    use crate::snapped::Snapped;

    // Red when a start leaves out what a gradient has below 256, or its way to the anchor is that inside a pixel.
    #[test]
    fn a_plane_is_the_same_from_any_anchor() {
        let mut state = 1_u64;
        let mut random = |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) & ((1 << bits) - 1)) as i32
        };
        for round in 0..20_000 {
            let (bits, [x, y]) = (3 + round % 13, [random(20), random(18)]);
            let points = [(); 3].map(|()| Snapped::from_bits(x + random(bits), y + random(bits)));
            let Some((setup, _)) = Setup::new(points) else { continue };
            let [a, b, c] = [(); 3].map(|()| random(31) << 1);
            let (near, [column, row]) = (setup.gradients().plane(a, b, c), setup.anchor());
            let far = setup.gradients_from(0, 0).plane(a, b, c);
            let moved = near.dx.wrapping_mul(column).wrapping_add(near.dy.wrapping_mul(row));
            assert_eq!([far.dx, far.dy], [near.dx, near.dy]);
            assert_eq!(far.start, near.start.wrapping_sub(moved), "{points:?} {a} {b} {c}");
        }
    }
}

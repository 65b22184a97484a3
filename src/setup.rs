//! Stage 4. Everything about a triangle that its pixels share.
//!
//! Takes three snapped vertices; gives a [`Setup`]. Facing, coverage and gradients are all computed from the snapped
//! positions, so nothing is ever extrapolated. The vertices are in canonical order, by y and then x, so that the bytes
//! drawn do not depend on which vertex a triangle starts with.

use crate::gradients::Gradients;
use crate::math::format::SUBPIXEL_BITS;
use crate::math::product;
use crate::snapped::{Snapped, first_centre};

/// Which triangles are left out, by the way they face once they are snapped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cull {
    /// Those that show their back: clockwise as the viewer sees them.
    #[default]
    Back,
    /// Those that show their front: counter-clockwise as the viewer sees them.
    Front,
    /// None: both sides are drawn.
    None,
}

impl Cull {
    /// Whether a triangle that faces this way is left out. One without an area always is.
    #[inline]
    pub(crate) const fn leaves_out(self, facing: i32) -> bool {
        match self {
            // Screen y grows down: counter-clockwise as seen is negative.
            Self::Back => facing >= 0,
            Self::Front => facing <= 0,
            Self::None => facing == 0,
        }
    }
}

/// The doubled area, in steps of 2^-16 px^2: positive where a, b, c are clockwise as seen.
///
/// Exact for vertices inside the guard rectangle, and for any that are at most 2^30 steps apart.
#[inline(never)]
pub(crate) fn area2(a: Snapped, b: Snapped, c: Snapped) -> i64 {
    let ((ax, ay), (bx, by), (cx, cy)) = (a.bits(), b.bits(), c.bits());
    product::signed(bx.wrapping_sub(ax), cy.wrapping_sub(ay))
        - product::signed(cx.wrapping_sub(ax), by.wrapping_sub(ay))
}

/// A number with the sign of the doubled area. Where vertices are less than 128 px apart, 32 bits hold the products.
#[inline(always)]
pub(crate) fn facing(a: Snapped, b: Snapped, c: Snapped) -> i32 {
    let ((ax, ay), (bx, by), (cx, cy)) = (a.bits(), b.bits(), c.bits());
    let (dx1, dy1) = (bx.wrapping_sub(ax), by.wrapping_sub(ay));
    let (dx2, dy2) = (cx.wrapping_sub(ax), cy.wrapping_sub(ay));
    let beyond = |d: i32| d.wrapping_add(1 << 15);
    if (beyond(dx1) | beyond(dy1) | beyond(dx2) | beyond(dy2)) >> 16 == 0 {
        dx1 * dy2 - dx2 * dy1
    } else {
        area2(a, b, c).signum() as i32
    }
}

/// A triangle less than this apart on both axes, in steps of 1/256 px, is small: 32 px. Products of its edges fit 32
/// bits.
pub(crate) const SMALL: i32 = 32 << SUBPIXEL_BITS;

/// A triangle ready for traversal: snapped vertices inside the guard rectangle, in canonical order.
///
/// A [`Kernel`](crate::stages::Kernel) in assembly reads it where it lies: at bytes 0 to 23 column and row of each vertex, in
/// steps of 1/256 px, and at byte 24 the doubled area, an `i64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Setup {
    points: [Snapped; 3],
    area2: i64,
    small: bool,
}

impl Setup {
    /// The triangle of three vertices in canonical order: by y, then by x. Nothing where it has no area.
    #[inline]
    pub(crate) fn sorted(points: [Snapped; 3]) -> Option<Self> {
        let [a, b, c] = points;
        let ((ax, ay), (bx, by), (cx, cy)) = (a.bits(), b.bits(), c.bits());
        let (dx1, dy1, dx2, dy2) = (bx - ax, by - ay, cx - ax, cy - ay);
        // Sign bits: one test for all. The rows are in order.
        let beyond = |d: i32| (SMALL - 1 - d) | (SMALL - 1 + d);
        let small = beyond(dx1) | beyond(dx2) | beyond(dx2 - dx1) | (SMALL - 1 - dy2) >= 0;
        let area2 = if small { i64::from(dx1 * dy2 - dx2 * dy1) } else { area2(a, b, c) };
        if area2 == 0 { None } else { Some(Self { points, area2, small }) }
    }

    /// The triangle of three vertices in any order, and where in that order each of its own vertices stood.
    ///
    /// Nothing where the vertices have no area, are further apart than the largest guard rectangle (2^23 px^2, 8191
    /// columns or 4095 rows), or lie beyond ±2^22 px.
    ///
    /// ```
    /// use topleft::stages::{Setup, Snapped};
    ///
    /// let at = |x, y| Snapped::from_bits(x * 256, y * 256);
    /// let (setup, order) = Setup::new([at(9, 9), at(0, 0), at(0, 9)]).unwrap();
    /// assert_eq!(order, [1, 2, 0]);
    /// assert_eq!(setup.rows(), 0..9);
    /// assert!(Setup::new([at(0, 0), at(3, 3), at(9, 9)]).is_none());
    /// ```
    pub fn new(points: [Snapped; 3]) -> Option<(Self, [usize; 3])> {
        let [a, b, c] = points;
        let sorted = canonical([(a, 0), (b, 1), (c, 2)]);
        let (points, order) = (sorted.map(|(point, _)| point), sorted.map(|(_, place)| place));
        let extent = |ends: [i32; 3]| {
            let [a, b, c] = ends.map(i64::from);
            a.max(b).max(c) - a.min(b).min(c)
        };
        let (width, height) = (extent(points.map(|p| p.x.to_bits())), extent(points.map(|p| p.y.to_bits())));
        let near = |p: &Snapped| p.x.to_bits().unsigned_abs().max(p.y.to_bits().unsigned_abs()) <= 1 << 30;
        let fits = points.iter().all(near)
            && width <= 8191 << SUBPIXEL_BITS
            && height <= 4095 << SUBPIXEL_BITS
            && width * height <= 1 << 39;
        if fits { Self::sorted(points).map(|setup| (setup, order)) } else { None }
    }

    /// The vertices, in canonical order.
    pub const fn points(&self) -> [Snapped; 3] {
        self.points
    }

    /// The doubled area in steps of 2^-16 px^2: positive where the middle vertex is right of the long edge.
    pub const fn area2(&self) -> i64 {
        self.area2
    }

    /// Whether no two vertices are [`SMALL`] apart, or more, on an axis.
    #[inline]
    pub(crate) const fn is_small(&self) -> bool {
        self.small
    }

    /// The rows whose pixel centres lie between the top and the bottom vertex.
    #[inline]
    pub fn rows(&self) -> core::ops::Range<i32> {
        let [top, _, bottom] = self.points;
        first_centre(top.y.to_bits())..first_centre(bottom.y.to_bits())
    }

    /// The column and row of the pixel that planes start from: the one that holds the first vertex.
    #[inline]
    pub const fn anchor(&self) -> [i32; 2] {
        let [first, ..] = self.points;
        [first.x.to_bits() >> SUBPIXEL_BITS, first.y.to_bits() >> SUBPIXEL_BITS]
    }

    /// What turns values at the vertices into planes.
    #[inline]
    pub fn gradients(&self) -> Gradients {
        let [column, row] = self.anchor();
        self.gradients_from(column, row)
    }

    /// The same, of planes that start at another pixel: less than 2^13 columns and rows from the first vertex.
    #[inline]
    pub(crate) fn gradients_from(&self, column: i32, row: i32) -> Gradients {
        Gradients::new(&self.points, self.area2, self.small, column, row)
    }
}

/// Three points and what stands there, in the order by y, then x; those that are equal keep theirs.
#[inline(always)]
pub(crate) fn canonical<T>([a, b, c]: [(Snapped, T); 3]) -> [(Snapped, T); 3] {
    let before = |(p, _): &(Snapped, T), (q, _): &(Snapped, T)| p.order() < q.order();
    if before(&b, &a) {
        if before(&c, &b) {
            [c, b, a]
        } else if before(&c, &a) {
            [b, c, a]
        } else {
            [b, a, c]
        }
    } else if before(&c, &a) {
        [c, a, b]
    } else if before(&c, &b) {
        [a, c, b]
    } else {
        [a, b, c]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a field is moved: kernels in assembly have these numbers.
    #[test]
    fn assembly_finds_the_fields_where_they_were() {
        use core::mem::{offset_of, size_of};

        assert_eq!([offset_of!(Setup, points), offset_of!(Setup, area2)], [0, 24]);
        assert_eq!((offset_of!(Snapped, x), offset_of!(Snapped, y), size_of::<Snapped>()), (0, 4, 8));
    }

    #[test]
    fn canonical_order_does_not_depend_on_the_given_one() {
        let points = [Snapped::from_bits(5, 7), Snapped::from_bits(-5, 7), Snapped::from_bits(0, -300)];
        let expected = [points[2], points[1], points[0]];
        for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let (setup, _) = Setup::new(order.map(|i| points[i])).unwrap();
            assert_eq!(setup.points(), expected);
        }
    }

    // Red when 32 bits are taken to be enough for vertices further apart: `1 << 16` in `facing`, or one difference left out.
    #[test]
    fn facing_is_the_sign_of_the_doubled_area() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as i32
        };
        // Near and at the ends of what 16 bits hold, and all over the largest guard rectangle.
        let ends = [0, 1, -1, 0x7FFF, -0x8000, 0x8000, -0x8001, 0xFFFF, 0x1_0000, -0x1_0001];
        for round in 0..1_000_000 {
            let mut near = || match random() % 4 {
                0 => random() >> 11,
                1 => random() >> (11 + round % 20),
                _ => ends.get(random() as usize % ends.len()).copied().unwrap_or_default(),
            };
            let [a, b, c] = [(); 3].map(|()| Snapped::from_bits(near(), near()));
            assert_eq!(i64::from(facing(a, b, c).signum()), area2(a, b, c).signum(), "{a:?} {b:?} {c:?}");
        }
    }
}

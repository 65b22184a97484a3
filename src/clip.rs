//! Stage 3. Cuts triangles at the near and far planes, and at the guard rectangle.
//!
//! Takes three [`ClipVertex`]; gives a convex polygon of up to nine. Watertight by three rules:
//! what is outside is decided for each vertex and plane, never for a triangle; a new vertex is computed from the end of
//! the edge that is inside to the one that is outside, so both triangles of an edge compute the same one; and its
//! attributes are mixed by the same fraction as its position.

use heapless::Vec;

use crate::attributes::{Carried, Fraction};
use crate::math::product;
use crate::snapped::Snapped;
use crate::transform::{Position, Projection};

/// A vertex in clip space with what it carries.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClipVertex {
    pub(crate) position: Position,
    pub(crate) carried: Carried,
}

/// What a vertex between two others carries.
pub(crate) type Mix<'m> = &'m dyn Fn(&Carried, &Carried, Fraction) -> Carried;

/// Corners of what is left of a triangle, at most: three, and one more a plane.
pub(crate) const MOST_CORNERS: usize = 9;

/// What is left of a triangle.
pub(crate) type Polygon = Vec<ClipVertex, MOST_CORNERS>;

/// The planes that a vertex lies outside of, a bit each: near, far, left, right, top, bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Outcode(pub(crate) u8);

impl Outcode {
    #[inline]
    pub(crate) fn new(at: &Position, projection: &Projection) -> Self {
        if projection.surely_inside(at) { Self(0) } else { Self::of_distances(at, projection) }
    }

    /// Apart, as most vertices are surely inside.
    #[inline(never)]
    fn of_distances(at: &Position, projection: &Projection) -> Self {
        let mut code = 0;
        for plane in 0..PLANES {
            code |= u8::from(projection.distance(at, plane) < 0) << plane;
        }
        Self(code)
    }
}

/// Near, far, left, right, top, bottom.
const PLANES: u8 = 6;

/// What of the triangle in the first of two places is inside all planes that `crossed` names, in the triangle's order: in
/// either of them, as each plane cuts from one into the other.
pub(crate) fn clip<'p>(
    crossed: Outcode,
    projection: &Projection,
    mix: Mix<'_>,
    [polygon, kept]: &'p mut [Polygon; 2],
) -> &'p Polygon {
    let (mut polygon, mut kept) = (polygon, kept);
    for plane in 0..PLANES {
        if crossed.0 >> plane & 1 != 0 {
            cut(polygon, |vertex| projection.distance(&vertex.position, plane), mix, kept);
            core::mem::swap(&mut polygon, &mut kept);
        }
    }
    polygon
}

/// The place of the least vertex by where all are snapped to, row before column, and by what else tells them apart: a fan
/// from there is the same whichever vertex the polygon was found from, and whichever way round.
#[inline(never)]
pub(crate) fn least(polygon: &Polygon, snapped: &dyn Fn(&ClipVertex, usize) -> Snapped) -> usize {
    let (mut least, mut first) = ([i32::MAX; 6], 0);
    for (place, vertex) in polygon.iter().enumerate() {
        let (at, (x, y)) = (vertex.position, snapped(vertex, place).bits());
        let key = [y, x, at.w, at.z, at.x, at.y];
        if key < least {
            (least, first) = (key, place);
        }
    }
    first
}

/// One vertex more, of which there is room for as many as there can be: each plane adds at most one to a convex polygon,
/// which has three at first.
#[inline(never)]
pub(crate) fn add(polygon: &mut Polygon, vertex: &ClipVertex) {
    let _ = polygon.push(*vertex);
}

/// The part of a polygon where `distance` is not negative, as `kept`.
fn cut(polygon: &Polygon, distance: impl Fn(&ClipVertex) -> i64, mix: Mix<'_>, kept: &mut Polygon) {
    kept.clear();
    let Some(mut previous) = polygon.last() else { return };
    let mut before = distance(previous);
    for vertex in polygon {
        let here = distance(vertex);
        if (before < 0) != (here < 0) {
            let crossing = if before < 0 {
                crossing(vertex, here, previous, before, mix)
            } else {
                crossing(previous, before, vertex, here, mix)
            };
            add(kept, &crossing);
        }
        if here >= 0 {
            add(kept, vertex);
        }
        (previous, before) = (vertex, here);
    }
}

/// Where the edge from `inside` to `outside` crosses the plane.
fn crossing(
    inside: &ClipVertex,
    distance_inside: i64,
    outside: &ClipVertex,
    distance_outside: i64,
    mix: Mix<'_>,
) -> ClipVertex {
    let whole = distance_inside.abs_diff(distance_outside);
    let part = distance_inside.unsigned_abs();
    let at = fraction(part, whole);
    let (from, to) = (inside.position, outside.position);
    ClipVertex {
        position: Position {
            x: at.mix(from.x, to.x),
            y: at.mix(from.y, to.y),
            z: at.mix(from.z, to.z),
            w: at.mix(from.w, to.w),
        },
        carried: mix(&inside.carried, &outside.carried, at),
    }
}

/// `part / whole` of the 33 leading bits of both, rounded down: at most 1.
///
/// Bit by bit: few triangles are clipped, and a division of 64 bits would take a kilobyte of code.
fn fraction(part: u64, whole: u64) -> Fraction {
    let spare = product::leading_zeros(whole);
    let (mut rest, whole) =
        if spare < 31 { (part >> (31 - spare), whole >> (31 - spare)) } else { (part, whole) };
    if rest >= whole {
        return Fraction(if whole == 0 { 0 } else { 1 << 30 });
    }
    let mut bits = 0;
    for _ in 0..30 {
        (rest, bits) = (rest << 1, bits << 1);
        if rest >= whole {
            (rest, bits) = (rest - whole, bits | 1);
        }
    }
    Fraction(bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a bit is missing, or what is cut off before the division is not.
    #[test]
    fn a_fraction_is_a_quotient_rounded_down() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state ^ state >> 32
        };
        for round in 0..100_000 {
            let whole = random() >> (round % 64);
            let part = random().checked_rem(whole.saturating_add(1)).unwrap_or_default();
            let down = 31_u32.saturating_sub(whole.leading_zeros());
            let exact = (u128::from(part >> down) << 30).checked_div(u128::from(whole >> down));
            assert_eq!(fraction(part, whole).0 as u128, exact.unwrap_or_default(), "{part} / {whole}");
        }
        assert_eq!([fraction(0, 0), fraction(7, 7), fraction(0, 9)], [0, 1 << 30, 0].map(Fraction));
    }

    // Red when what is surely inside is so by one sign less, or `w` is not among them.
    #[test]
    fn what_is_surely_inside_is_inside_all_planes() {
        let viewport =
            crate::viewport::Viewport::new(embedded_graphics_core::geometry::Size::new(240, 200)).unwrap();
        let projection = Projection::centred(viewport);
        let mut state = 1_u64;
        let mut random = |ends: &[i32]| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let number = (state >> 32) as i32;
            ends.get(number as usize % 16).map_or(number >> 1 >> (state >> 20 & 31), |&end| end)
        };
        let mut sure = 0;
        for _ in 0..1_000_000 {
            // As far as a clip coordinate goes.
            let most = (1 << 30) + 3;
            let w = random(&[0, 1, -1, most, -most]);
            let mut other =
                || random(&[0, w, -w, w + 1, w - 1, 1 - w, -1 - w, most, -most]).clamp(-most, most);
            let at = Position { x: other(), y: other(), z: other(), w };
            let inside = (0..PLANES).all(|plane| projection.distance(&at, plane) >= 0);
            assert!(inside || !projection.surely_inside(&at), "{at:?}");
            sure += u32::from(projection.surely_inside(&at));
        }
        assert!(sure > 10_000, "{sure}");
    }
}

//! Stage 3. Cuts triangles at the near and far planes, and at the guard rectangle.
//!
//! Takes three [`ClipVertex`]; gives a convex polygon of up to nine. Watertight by three rules:
//! what is outside is decided for each vertex and plane, never for a triangle; a new vertex is computed from the end of
//! the edge that is inside to the one that is outside, so both triangles of an edge compute the same one; and its
//! attributes are mixed by the same fraction as its position.

use heapless::Vec;

use crate::attributes::{Carried, Fraction};
use crate::transform::{Position, Projection};

/// A vertex in clip space with what it carries.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClipVertex {
    pub(crate) position: Position,
    pub(crate) carried: Carried,
}

/// What a vertex between two others carries.
pub(crate) type Mix<'m> = &'m dyn Fn(&Carried, &Carried, Fraction) -> Carried;

/// Three vertices, and one more a plane.
pub(crate) type Polygon = Vec<ClipVertex, 9>;

/// The planes that a vertex lies outside of, a bit each: near, far, left, right, top, bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Outcode(pub(crate) u8);

impl Outcode {
    #[inline]
    pub(crate) fn new(at: &Position, projection: &Projection) -> Self {
        let mut code = u8::from(at.z < 0) | u8::from(at.w < at.z) << 1;
        if projection.surely_inside(at) {
            return Self(code);
        }
        let distances = distances(at, projection);
        for (plane, distance) in distances.into_iter().enumerate() {
            code |= u8::from(distance < 0) << plane;
        }
        Self(code)
    }
}

/// Distances to all planes, in any unit: negative outside.
#[inline]
fn distances(at: &Position, projection: &Projection) -> [i64; 6] {
    let [left, right, top, bottom] = projection.guard_distances(at);
    [i64::from(at.z), i64::from(at.w) - i64::from(at.z), left, right, top, bottom]
}

/// What is inside all planes that `crossed` names, in the order of the triangle.
pub(crate) fn clip(
    triangle: [ClipVertex; 3],
    crossed: Outcode,
    projection: &Projection,
    mix: Mix<'_>,
) -> Polygon {
    let mut polygon = Polygon::new();
    // Nine places hold three vertices, and each plane adds at most one to a convex polygon: `push` cannot fail.
    let _ = polygon.extend_from_slice(&triangle);
    for plane in 0..6 {
        if crossed.0 >> plane & 1 != 0 {
            let distance = |vertex: &ClipVertex| {
                distances(&vertex.position, projection).get(plane).copied().unwrap_or_default()
            };
            polygon = cut(&polygon, distance, mix);
        }
    }
    polygon
}

/// The same polygon, its least vertex by `key` first: a fan from there is the same whichever vertex the polygon was
/// found from, and whichever way round.
pub(crate) fn from_least<K: Ord>(polygon: &Polygon, key: impl Fn(&ClipVertex) -> K) -> Polygon {
    let least =
        polygon.iter().enumerate().min_by_key(|(_, vertex)| key(vertex)).map_or(0, |(place, _)| place);
    let mut turned = Polygon::new();
    let (before, from) = polygon.split_at_checked(least).unwrap_or_default();
    for vertex in from.iter().chain(before) {
        let _ = turned.push(*vertex);
    }
    turned
}

/// The part of a polygon where `distance` is not negative.
fn cut(polygon: &Polygon, distance: impl Fn(&ClipVertex) -> i64, mix: Mix<'_>) -> Polygon {
    let mut kept = Polygon::new();
    let Some(mut previous) = polygon.last() else { return kept };
    let mut before = distance(previous);
    for vertex in polygon {
        let here = distance(vertex);
        if (before < 0) != (here < 0) {
            let crossing = if before < 0 {
                crossing(vertex, here, previous, before, mix)
            } else {
                crossing(previous, before, vertex, here, mix)
            };
            let _ = kept.push(crossing);
        }
        if here >= 0 {
            let _ = kept.push(*vertex);
        }
        (previous, before) = (vertex, here);
    }
    kept
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
    // 30 fraction bits. Only here is a 64-bit division worth its price: few triangles are clipped.
    let spare = whole.leading_zeros();
    let (part, whole) =
        if spare < 31 { (part >> (31 - spare), whole >> (31 - spare)) } else { (part, whole) };
    let at = Fraction((part << 30).checked_div(whole).unwrap_or_default().min(1 << 30) as i32);
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

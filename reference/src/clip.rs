//! Stage 3. Sutherland and Hodgman's clipping of a triangle against planes in clip space.

use crate::matrix::Vec4;
use crate::transform::Viewport;

/// A vertex in clip space with what it carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipVertex<const N: usize> {
    /// x, y, z, w.
    pub position: Vec4,
    /// Linear in clip space.
    pub varyings: [f64; N],
}

/// A half space of clip space: what has `plane . position >= 0` stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane(pub Vec4);

/// z >= 0.
pub const NEAR: Plane = Plane([0.0, 0.0, 1.0, 0.0]);
/// z <= w.
pub const FAR: Plane = Plane([0.0, 0.0, -1.0, 1.0]);

/// The least w that is kept, as a share of the triangle's greatest |w|. Near and far together already leave w >= 0;
/// this leaves no division by zero.
const LEAST_W: f64 = 1.0 / (1_u64 << 40) as f64;

impl Plane {
    /// Positive inside, 0 on the plane.
    pub fn distance(&self, position: Vec4) -> f64 {
        let Self(plane) = self;
        plane[0] * position[0] + plane[1] * position[1] + plane[2] * position[2] + plane[3] * position[3]
    }
}

/// The four planes of a rectangle that is `margin` pixels larger than the viewport on each side.
pub fn guard(viewport: Viewport, margin: f64) -> [Plane; 4] {
    let x = 1.0 + 2.0 * margin / f64::from(viewport.width);
    let y = 1.0 + 2.0 * margin / f64::from(viewport.height);
    [
        Plane([1.0, 0.0, 0.0, x]),
        Plane([-1.0, 0.0, 0.0, x]),
        Plane([0.0, 1.0, 0.0, y]),
        Plane([0.0, -1.0, 0.0, y]),
    ]
}

/// The part of a triangle between near and far, in front of the eye and inside `more` planes: a convex polygon in the
/// triangle's own order, or nothing. A triangle that is inside stays as it is.
pub fn clip<const N: usize>(triangle: [ClipVertex<N>; 3], more: &[Plane]) -> Vec<ClipVertex<N>> {
    let mut polygon = triangle.to_vec();
    for plane in [NEAR, FAR].iter().chain(more) {
        polygon = cut(&polygon, |position| plane.distance(position));
    }
    let greatest = triangle.iter().map(|vertex| vertex.position[3].abs()).fold(0.0, f64::max);
    cut(&polygon, |position| position[3] - greatest * LEAST_W)
}

fn cut<const N: usize>(polygon: &[ClipVertex<N>], distance: impl Fn(Vec4) -> f64) -> Vec<ClipVertex<N>> {
    let mut kept = Vec::new();
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let (da, db) = (distance(a.position), distance(b.position));
        if da >= 0.0 {
            kept.push(a);
        }
        // Always from the vertex inside to the one outside, so that both triangles of an edge compute the same. A vertex
        // on the plane is the crossing itself.
        if da > 0.0 && db < 0.0 {
            kept.push(towards(a, b, da / (da - db)));
        } else if da < 0.0 && db > 0.0 {
            kept.push(towards(b, a, db / (db - da)));
        }
    }
    // A corner or an edge that only touches the plane is no polygon.
    if kept.len() < 3 { Vec::new() } else { kept }
}

fn towards<const N: usize>(inside: ClipVertex<N>, outside: ClipVertex<N>, t: f64) -> ClipVertex<N> {
    let lerp = |a: f64, b: f64| a + (b - a) * t;
    ClipVertex {
        position: std::array::from_fn(|i| lerp(inside.position[i], outside.position[i])),
        varyings: std::array::from_fn(|i| lerp(inside.varyings[i], outside.varyings[i])),
    }
}

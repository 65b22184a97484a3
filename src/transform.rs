//! Stage 2. From a mesh's `i16` positions to clip space, and from there to the screen.
//!
//! Takes a [`Mesh`], a [`Pose`] and a [`Camera`]; gives a [`Position`] a vertex.
//! A matrix element has 31 bits and a position 16, and their product is taken as two 32-bit ones: no 64-bit product,
//! no float. A clip coordinate is off by at most 3 steps (one truncation a product) plus the matrix's own rounding
//! (2^-30 of its largest element), where the largest that a vertex of the mesh can have is between 2^29 and 2^30.
//! The pose's part of that matrix is as fine as a [`Length`](crate::Length): a mesh stands, and is as large, as it says
//! to 2^-17 of the scene's unit.

use crate::attributes::Words;
use crate::math::format::{Clip, SUBPIXEL_BITS};
use crate::math::matrix::Matrix;
use crate::math::product;
use crate::math::recip::{self, Reciprocal};
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::snapped::Snapped;
use crate::viewport::Viewport;

/// A homogeneous position. x and y count from the centre of the viewport, in units of the projection's reach: a power
/// of two of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Position {
    pub(crate) x: Clip,
    pub(crate) y: Clip,
    pub(crate) z: Clip,
    pub(crate) w: Clip,
}

/// The matrix of one mesh in one frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transform {
    rows: [[i32; 4]; 4],
    pub(crate) projection: Projection,
    /// One over the w of all vertices, where there is no perspective.
    pub(crate) level_inverse: Reciprocal,
}

impl Transform {
    /// Through a camera's viewport and matrix: whatever camera it is, this is linked once.
    #[inline(never)]
    pub(crate) fn new(viewport: Viewport, matrix: &Matrix, mesh: &Mesh<'_>, pose: &Pose) -> Self {
        let projection = Projection::centred(viewport);
        let mut whole = matrix.times(&pose.of_box(mesh.centre(), mesh.half()));
        let rows = whole.rows_mut();
        // x and y in units of the reach: a power of two, so that the divide by w ends in a shift. Screen y grows down.
        let reach = projection.reach_log2 + 1;
        let factors = [viewport.width(), -viewport.height(), 1 << reach, 1 << reach];
        // The largest coordinate in the mesh's cube decides the power of two: 30 bits of it are kept.
        let mut largest = 0;
        for (row, factor) in rows.iter_mut().zip(factors) {
            let mut sum = 0;
            for element in row {
                *element = part(*element, factor, reach);
                sum += element.unsigned_abs();
            }
            largest |= sum;
        }
        let shift = product::leading_zeros(u64::from(largest)) as i32 - 34;
        for row in rows.iter_mut() {
            for (column, element) in row.iter_mut().enumerate() {
                let moved = if shift >= 0 { *element << shift } else { *element >> -shift };
                // A position counts 2^-16 of the cube instead of 2^-15, which the high half of a product gives.
                *element = moved << u32::from(column < 3);
            }
        }
        let &mut [_, _, _, [.., w]] = rows;
        Self { rows: *rows, projection, level_inverse: Projection::inverse(w) }
    }

    /// A vertex of the mesh in clip space.
    #[inline(always)]
    pub(crate) fn position(&self, vertex: [i16; 3]) -> Position {
        let [x, y, z, w] = &self.rows;
        Position {
            x: coordinate(x, vertex),
            y: coordinate(y, vertex),
            z: coordinate(z, vertex),
            w: coordinate(w, vertex),
        }
    }

    /// The same in less code, for few vertices.
    #[inline(never)]
    pub(crate) fn position_of_one(&self, vertex: &[i16; 3]) -> Position {
        #[inline(never)]
        fn one(row: &[i32; 4], vertex: &[i16; 3]) -> Clip {
            coordinate(row, *vertex)
        }
        let [x, y, z, w] = &self.rows;
        Position { x: one(x, vertex), y: one(y, vertex), z: one(z, vertex), w: one(w, vertex) }
    }

    /// Whether a box of positions lies outside one plane of the view as a whole.
    pub(crate) fn misses(&self, bounds: [[i16; 3]; 2]) -> bool {
        let [x, y, z, w] = &self.rows;
        let viewport = &self.projection.viewport;
        let (width, height) = (viewport.width(), viewport.height());
        let reach = 2 << self.projection.reach_log2;
        let beyond = |row, by, size| beyond([row, w], [by, size], &bounds);
        beyond(z, 1, 0)
            || beyond(z, -1, 1)
            || beyond(x, reach, width)
            || beyond(x, -reach, width)
            || beyond(y, reach, height)
            || beyond(y, -reach, height)
    }
}

/// `element * factor / 2^reach`, rounded down: for an element below 2^30, and a factor of at most 2^reach, which is at most 2^13.
#[inline]
fn part(element: i32, factor: i32, reach: u32) -> i32 {
    (((element >> 16) * factor) << (16 - reach)) + (((element & 0xFFFF) * factor) >> reach)
}

/// Whether a sum of two rows, each times a factor, is negative in all of a box: in the best corner of it.
#[inline(never)]
fn beyond([row, w]: [&[i32; 4]; 2], [by, size]: [i32; 2], [low, high]: &[[i16; 3]; 2]) -> bool {
    let mut best = 0;
    for (axis, (&r, &w)) in row.iter().zip(w).enumerate() {
        let slope = product::signed(r, by) + product::signed(w, size);
        best += match (low.get(axis), high.get(axis)) {
            (Some(&low), Some(&high)) => {
                product::signed((slope >> 16) as i32, i32::from(if slope < 0 { low } else { high }))
            }
            _ => slope,
        };
    }
    // Truncations of the three products and of the coordinates themselves.
    best < -i64::from(4 * (by.abs() + size) + (3 << 16))
}

/// Where w is less, its own error counts for too much.
const LEAST_W: Clip = 64;

impl Transform {
    /// Bounds of `1 - z / w`, in 32 fraction bits, of all that a list can keep of a box of positions: everything from the
    /// far to the near plane, where the box comes close to the eye's own plane.
    ///
    /// Where w is positive, the extremes of a quotient of two linear functions lie in corners. A vertex's z and w are off
    /// by up to 3 steps, by one more where an edge was cut, and so are a corner's: 2 * (4 + 4) / w together, a fifteenth
    /// more at the least w. Their reciprocals are up to 2^-26 too small, and quotients are rounded down.
    pub(crate) fn depths(&self, [low, high]: [[i16; 3]; 2]) -> [u32; 2] {
        let (mut least, mut greatest, mut least_w) = (u32::MAX, 0, Clip::MAX);
        for corner in 0..8 {
            let ([low_x, low_y, low_z], [high_x, high_y, high_z]) = (low, high);
            let pick = |bit: u8, low, high| if corner >> bit & 1 == 0 { low } else { high };
            let at = self.position_of_one(&[
                pick(0, low_x, high_x),
                pick(1, low_y, high_y),
                pick(2, low_z, high_z),
            ]);
            // What lies before the near plane is cut off there.
            let nearness =
                if at.z < 0 { u32::MAX } else { Projection::nearness(&at, Projection::inverse(at.w)) };
            (least, greatest, least_w) = (least.min(nearness), greatest.max(nearness), least_w.min(at.w));
        }
        if least_w < LEAST_W {
            return [0, u32::MAX];
        }
        let inverse = Projection::inverse(least_w);
        let margin = (product::unsigned(18, inverse.mantissa) << inverse.shift >> 30) as u32 + 70;
        [least.saturating_sub(margin), greatest.saturating_add(margin)]
    }
}

/// A row of the matrix times a vertex.
#[inline(always)]
fn coordinate([a, b, c, t]: &[i32; 4], [x, y, z]: [i16; 3]) -> Clip {
    high_product(*a, x.into())
        .wrapping_add(high_product(*b, y.into()))
        .wrapping_add(high_product(*c, z.into()))
        .wrapping_add(*t)
}

/// `factor * position / 2^16`, rounded down, from 32-bit products.
#[inline(always)]
fn high_product(factor: i32, position: i32) -> i32 {
    let low = (factor & 0xFFFF) * position;
    (factor >> 16).wrapping_mul(position).wrapping_add(low >> 16)
}

/// From clip space to the screen: `centre + x / w * reach`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Projection {
    pub(crate) viewport: Viewport,
    /// The viewport's centre, in steps of 1/256 px.
    centre: [Clip; 2],
    /// The guard rectangle's least and greatest x, and its y.
    guard: [[Clip; 2]; 2],
    /// x = w is this power of two of pixels from the centre.
    pub(crate) reach_log2: u32,
    /// Whether the guard rectangle reaches as far, on all sides.
    roomy: bool,
}

/// 1/w of a vertex as a small float: 26 bits or 27, shifted right by the last 5. All vertices of a mesh share its unit.
///
/// It is rounded down by at most 2^-25 of itself, as if the vertex had been moved by that part of its distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PerVertexInverse(u32);

impl PerVertexInverse {
    /// Of a mesh without perspective, where nothing is stored.
    pub const ONE: Self = Self(1 << 31);

    const SHIFT: u32 = 31;

    #[inline]
    pub(crate) fn new(inverse: Reciprocal) -> Self {
        // Leading zeros are 1 to 31 as w is positive: the greater, the nearer.
        Self(inverse.mantissa & !Self::SHIFT | (Self::SHIFT - inverse.shift.min(Self::SHIFT)))
    }

    /// Three of them where all are in one power of two already: in [2^30, 2^31], in 31 fraction bits of it.
    #[inline(always)]
    pub(crate) fn of_one_power(three: [Self; 3]) -> Option<[u32; 3]> {
        let [Self(a), Self(b), Self(c)] = three;
        if ((a ^ b) | (a ^ c)) & Self::SHIFT == 0 { Some([a, b, c]) } else { None }
    }

    /// Three of them in one power of two, at which the largest lies in [2^30, 2^31).
    #[inline]
    pub fn aligned(three: [Self; 3]) -> [i32; 3] {
        let least = three.iter().fold(Self::SHIFT, |least, inverse| least.min(inverse.0 & Self::SHIFT));
        three.map(|Self(word)| {
            let mantissa = (word & !Self::SHIFT) >> ((word & Self::SHIFT) - least);
            // A mantissa of 2^31 itself is one step too large.
            mantissa.min(i32::MAX.unsigned_abs()).cast_signed()
        })
    }
}

impl Words for PerVertexInverse {
    const WORDS: usize = 1;

    fn store(self, put: &mut impl FnMut(u32)) {
        put(self.0);
    }

    #[inline]
    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        words.next().map(Self)
    }
}

impl Projection {
    /// For cameras: the centre of the viewport is (0, 0), and the reach is at least half its longer side.
    pub(crate) fn centred(viewport: Viewport) -> Self {
        let (width, height) = (viewport.width(), viewport.height());
        // Of the power of two that the longest side fits in, half.
        let longest = width.max(height).max(2).unsigned_abs();
        let reach_log2 = 63 - product::leading_zeros(u64::from(longest - 1));
        let reach = 1 << (reach_log2 + SUBPIXEL_BITS);
        let (cx, cy) = (width << (SUBPIXEL_BITS - 1), height << (SUBPIXEL_BITS - 1));
        let projection = Self::from_centre(viewport, [cx, cy], reach_log2);
        // The guard rectangle has the same centre.
        let [[left, _], [top, _]] = projection.guard;
        Self { roomy: cx - left >= reach && cy - top >= reach, ..projection }
    }

    /// For flat drawings: x and y are pixels, w is one.
    pub(crate) fn of_pixels(viewport: Viewport) -> Self {
        Self::from_centre(viewport, [0, 0], 0)
    }

    #[inline]
    fn from_centre(viewport: Viewport, centre: [Clip; 2], reach_log2: u32) -> Self {
        let guard = |length| <[Clip; 2]>::from(viewport.guard(length));
        let guard = [guard(viewport.width()), guard(viewport.height())];
        Self { viewport, centre, guard, reach_log2, roomy: false }
    }

    /// Whether a position is easily seen to be inside all planes: most are.
    #[inline]
    pub(crate) fn surely_inside(&self, at: &Position) -> bool {
        // Sign bits: one test for all. Where a difference is too large for 32 bits, nothing is sure.
        let &Position { x, y, z, w } = at;
        let of = |d: Clip| w.wrapping_sub(d) | w.wrapping_add(d);
        self.roomy && w | z | w.wrapping_sub(z) | of(x) | of(y) >= 0
    }

    /// The distance to a plane, in any unit: negative outside. Near, far, left, right, top or bottom side of the guard
    /// rectangle. Linear in the position, so that clipping can take a proportion of it.
    #[inline(never)]
    pub(crate) fn distance(&self, at: &Position, plane: u8) -> i64 {
        let ([cx, cy], [[left, right], [top, bottom]]) = (self.centre, self.guard);
        let scale = SUBPIXEL_BITS + self.reach_log2;
        let (along, scale, side) = match plane {
            0 => (at.z, 0, 0),
            1 => (at.z, 0, 1),
            2 => (at.x, scale, left - cx),
            3 => (at.x, scale, right - cx),
            4 => (at.y, scale, top - cy),
            _ => (at.y, scale, bottom - cy),
        };
        let distance =
            product::up(i64::from(along).cast_unsigned(), scale).cast_signed() - product::signed(at.w, side);
        if plane & 1 == 0 { distance } else { -distance }
    }

    /// One over w, for [`project`](Self::project).
    #[inline(never)]
    pub(crate) fn inverse(w: Clip) -> Reciprocal {
        recip::vertex(w.max(1).unsigned_abs())
    }

    /// `1 - z / w` in 32 fraction bits, rounded down, for a position between the near and the far plane.
    #[inline]
    pub(crate) fn nearness(at: &Position, inverse: Reciprocal) -> u32 {
        let w_minus_z = at.w.wrapping_sub(at.z).max(0).unsigned_abs();
        // 1 / w = mantissa 2^(shift - 62): w has as many leading zeros as `shift`, so nothing is lost on the left.
        let product = product::up(product::unsigned(w_minus_z, inverse.mantissa), inverse.shift);
        (product >> 30).min(u64::from(u32::MAX)) as u32
    }

    /// A position that lies inside the guard rectangle, snapped to the screen: rounded once, to the nearest 1/256 px.
    #[inline]
    pub(crate) fn project(&self, at: &Position, inverse: Reciprocal) -> Snapped {
        let [cx, cy] = self.centre;
        // x / w = x * mantissa * 2^(shift - 62), in steps of 2^-8 of a pixel, times the reach.
        let down = 62 - SUBPIXEL_BITS - self.reach_log2 - inverse.shift;
        let snap = |c: Clip| {
            // A half is rounded up: down in size, where c is negative.
            let size = product::unsigned_down(c.unsigned_abs(), inverse.mantissa, (c < 0).into(), down - 1);
            let rounded = size.div_ceil(2).cast_signed();
            if c < 0 { rounded.wrapping_neg() } else { rounded }
        };
        // A vertex that was clipped to the guard rectangle can round to just outside of it; and a camera that claims to
        // be level, and is not, can put one anywhere.
        self.held(cx.wrapping_add(snap(at.x)), cy.wrapping_add(snap(at.y)))
    }

    /// A position in steps of 1/256 px, or the nearest inside the guard rectangle.
    #[inline]
    pub(crate) fn held(&self, x: Clip, y: Clip) -> Snapped {
        let [[left, right], [top, bottom]] = self.guard;
        Snapped::from_bits(x.max(left).min(right), y.max(top).min(bottom))
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::geometry::Size;

    use super::*;
    use crate::camera::{Camera as _, MatrixCamera, Perspective};
    use crate::math::format::Length;
    use crate::math::turn::Turn;

    // Red when a corner is left out, when there is no margin, and when what comes near the eye's plane has bounds.
    #[test]
    fn what_a_list_keeps_of_a_box_lies_within_its_depths() {
        let mut random = 1_u64;
        let mut next = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) as u32
        };
        let (mut seen, mut bounded) = (0, 0);
        for round in 0..20_000 {
            let far = [2.0, 30.0, 1000.0][round % 3];
            let size = Size::new(64, 64);
            let camera = Perspective::new(size, Turn::from_degrees(60), 0.5..far);
            // And where w says nothing of z.
            let any =
                Matrix::new([[(); 4]; 4].map(|row| row.map(|()| Length::from_bits(next() as i32 >> 14))));
            let matrix = if round % 5 == 0 { any } else { *camera.matrix() };
            let camera = MatrixCamera::<true>::new(size, matrix);
            // Level boxes have whole faces of one depth, where only rounding differs.
            let turn = Turn::new(if round % 2 == 0 { 0 } else { next() as u16 });
            let [x, y] = [next(), next()].map(|bits| Length::from_bits(bits as i32 % (1 << 17)));
            let away = Length::from_bits(-((next() >> (round % 14 + 9)) as i32));
            let pose = Pose::new().turned_y(turn).turned_x(turn).at([x, y, away]);
            let corners = [next(), next(), next(), next(), next(), next()].map(|bits| bits as i16);
            let [a, b, c, d, e, f] = corners;
            let positions = [[a, b, c], [d, e, f]];
            let mesh = Mesh::new(&positions, &[[0, 1, 0]]).unwrap();
            let half = Length::from_bits(1 + (next() >> (round % 11 + 11)) as i32);
            let mesh = mesh.with_box([Length::ZERO; 3], half);
            let viewport = camera.viewport().unwrap();
            let transform = Transform::new(viewport, camera.matrix(), &mesh, &pose);
            let [least, greatest] = transform.depths(mesh.bounds());
            let [low, high] = mesh.bounds();
            bounded += usize::from(least > 0 || greatest < u32::MAX);
            for _ in 0..30 {
                let kinds = next();
                let vertex = [0, 1, 2].map(|axis| match kinds >> (2 * axis) & 3 {
                    0 => low[axis],
                    1 => high[axis],
                    _ => {
                        let length = i64::from(high[axis]) - i64::from(low[axis]) + 1;
                        (i64::from(low[axis]) + i64::from(next()) % length) as i16
                    }
                });
                let at = transform.position(vertex);
                if at.z < 0 || at.z > at.w {
                    continue;
                }
                let nearness = Projection::nearness(&at, Projection::inverse(at.w));
                assert!(
                    least <= nearness && nearness <= greatest,
                    "{vertex:?}: {nearness} not in {least}..{greatest}"
                );
                seen += 1;
            }
        }
        assert!(seen > 100_000 && bounded > 5_000, "{seen} {bounded}");
    }

    // Red when a plane has the other sign, or the size of the other axis, or the worst corner of the box is looked at in
    // place of the best; and when nothing is ever missed.
    #[test]
    fn a_box_that_is_missed_lies_outside_one_plane() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as u32
        };
        let mut missed = [0; 6];
        for _ in 0..50_000 {
            let size = Size::new(20 + random() % 300, 20 + random() % 300);
            let camera = Perspective::new(size, Turn::from_degrees(60), 0.5..20.0);
            let at =
                [random(), random(), random()].map(|bits| Length::from_bits((bits as i32 >> 9) - (1 << 21)));
            let pose =
                Pose::new().turned_y(Turn::new(random() as u16)).turned_x(Turn::new(random() as u16)).at(at);
            let [a, b, c, d, e, f] = [(); 6].map(|()| random() as i16);
            let positions = [[a, b, c], [d, e, f]];
            let mesh = Mesh::new(&positions, &[[0, 1, 0]]).unwrap();
            let mesh = mesh.with_box([Length::ZERO; 3], Length::from_bits(1 + (random() >> 11) as i32));
            let viewport = camera.viewport().unwrap();
            let transform = Transform::new(viewport, camera.matrix(), &mesh, &pose);
            if !transform.misses(mesh.bounds()) {
                continue;
            }
            let [low, high] = mesh.bounds();
            let reach = 2 << transform.projection.reach_log2;
            let mut outside = [true; 6];
            for corner in 0..8 {
                let at = transform
                    .position([0, 1, 2].map(|k| if corner >> k & 1 == 0 { low[k] } else { high[k] }));
                let [x, y, z, w] = [at.x, at.y, at.z, at.w].map(i64::from);
                let (x, y) = (x * reach, y * reach);
                let (right, bottom) = (w * i64::from(size.width), w * i64::from(size.height));
                let distances = [z, w - z, right + x, right - x, bottom + y, bottom - y];
                for (outside, distance) in outside.iter_mut().zip(distances) {
                    *outside &= distance < 0;
                }
            }
            assert!(outside.contains(&true), "{at:?} {positions:?}");
            for (missed, outside) in missed.iter_mut().zip(outside) {
                *missed += usize::from(outside);
            }
        }
        assert!(missed.iter().all(|&missed| missed > 100), "{missed:?}");
    }

    // Red when the low half is left out, or is rounded another way.
    #[test]
    fn a_part_is_rounded_down() {
        let mut state = 1_u64;
        for round in 0..100_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let (element, reach) = ((state >> 32) as i32 >> (1 + round % 31), 1 + round as u32 % 13);
            for element in [element, (1 << 30) - 1, 1 - (1 << 30)] {
                let most = 1 << reach;
                for factor in [(state >> 8) as i32 & (most - 1), most - 1, most] {
                    for factor in [factor, -factor] {
                        let exact = (i64::from(element) * i64::from(factor)) >> reach;
                        assert_eq!(
                            i64::from(part(element, factor, reach)),
                            exact,
                            "{element} {factor} {reach}"
                        );
                    }
                }
            }
        }
    }

    // Red when a half is rounded away from zero, or the rest of a negative coordinate is dropped the other way.
    #[test]
    fn a_projected_coordinate_is_rounded_to_nearest_and_halves_up() {
        let viewport = Viewport::new(Size::new(240, 240)).unwrap();
        let projection = Projection::centred(viewport);
        let [cx, cy] = projection.centre;
        for bit in 6..30 {
            for k in 0..5_000 {
                // Powers of two, of which halves of a step are multiples; and others.
                let w = if k % 2 == 0 { 1 << bit } else { (1 << bit) + k % (1 << bit) };
                let [x, y] = [k, -k].map(|k: i32| {
                    let part = (i64::from(k) * i64::from(w)) >> (k.unsigned_abs() % 3 + 15);
                    part.clamp(-i64::from(w), i64::from(w)) as i32
                });
                let inverse = Projection::inverse(w);
                let scaled = |c: i32| {
                    // In steps of 1/256 px, with 62 - 8 - 7 - shift bits more.
                    let down = 47 - inverse.shift;
                    ((i128::from(c) * i128::from(inverse.mantissa) + (1 << (down - 1))) >> down) as i32
                };
                let snapped = projection.project(&Position { x, y, z: 0, w }, inverse);
                assert_eq!(snapped, Snapped::from_bits(cx + scaled(x), cy + scaled(y)), "{x} {y} / {w}");
            }
        }
    }
}

//! Where a mesh stands: turned, scaled, then moved.

use fixed::types::I2F30;

use crate::math::format::Length;
use crate::math::matrix::Matrix;
use crate::math::product;
use crate::math::turn::Turn;

/// Where a mesh stands in the scene: turned and scaled about the scene's origin, then moved. No float is involved.
///
/// Turns follow one another; each is about an axis of the scene, counter-clockwise for a viewer whom the axis points at.
///
/// ```
/// use topleft::{Length, Pose, Turn};
///
/// let pose = Pose::new()
///     .turned_y(Turn::from_degrees(90))
///     .scaled(Length::lit("2"))
///     .at([Length::ZERO, Length::ONE, Length::ZERO]);
/// // A quarter turn about y takes z to x.
/// assert_eq!(pose.apply([Length::ZERO, Length::ZERO, Length::ONE]).map(Length::to_num::<i32>), [2, 1, 0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pose {
    /// Rows of the rotation.
    rotation: [[I2F30; 3]; 3],
    scale: Length,
    position: [Length; 3],
}

impl Pose {
    /// As the mesh was made.
    pub const fn new() -> Self {
        let (i, o) = (I2F30::ONE, I2F30::ZERO);
        Self { rotation: [[i, o, o], [o, i, o], [o, o, i]], scale: Length::ONE, position: [Length::ZERO; 3] }
    }

    /// Moves the mesh's origin to `position`.
    #[must_use]
    pub const fn at(mut self, position: [Length; 3]) -> Self {
        self.position = position;
        self
    }

    /// Scales the mesh, the same along every axis. A negative scale turns it inside out.
    #[must_use]
    pub const fn scaled(mut self, scale: Length) -> Self {
        self.scale = scale;
        self
    }

    /// Turns about the scene's x axis, from y towards z.
    #[must_use]
    pub fn turned_x(mut self, turn: Turn) -> Self {
        let [x, y, z] = self.rotation;
        let (y, z) = rotated(turn, y, z);
        self.rotation = [x, y, z];
        self
    }

    /// Turns about the scene's y axis, from z towards x.
    #[must_use]
    pub fn turned_y(mut self, turn: Turn) -> Self {
        let [x, y, z] = self.rotation;
        let (z, x) = rotated(turn, z, x);
        self.rotation = [x, y, z];
        self
    }

    /// Turns about the scene's z axis, from x towards y.
    #[must_use]
    pub fn turned_z(mut self, turn: Turn) -> Self {
        let [x, y, z] = self.rotation;
        let (x, y) = rotated(turn, x, y);
        self.rotation = [x, y, z];
        self
    }

    /// Where a point of the mesh stands in the scene, rounded to nearest.
    pub fn apply(&self, point: [Length; 3]) -> [Length; 3] {
        let point = point.map(|c| scaled(c, self.scale));
        let turned = self.rotation.map(|row| dot(row, point));
        let [x, y, z] = turned;
        let [px, py, pz] = self.position;
        [x.saturating_add(px), y.saturating_add(py), z.saturating_add(pz)]
    }

    /// A direction of the scene as the mesh sees it, before its turns: the rotation backwards.
    ///
    /// `direction` has 30 fraction bits and length 1, and so has the result.
    pub(crate) fn to_model(self, direction: [i32; 3]) -> [i32; 3] {
        let [x, y, z] = direction.map(i64::from);
        let [r0, r1, r2] = self.rotation.map(|row| row.map(|c| i64::from(c.to_bits())));
        let column = |a: i64, b: i64, c: i64| ((a * x + b * y + c * z + (1 << 29)) >> 30) as i32;
        [column(r0[0], r1[0], r2[0]), column(r0[1], r1[1], r2[1]), column(r0[2], r1[2], r2[2])]
    }

    /// The matrix from the cube of a mesh, ±1, that has `half` its edge and this `centre`, to the scene.
    pub(crate) fn of_box(&self, centre: [Length; 3], half: Length) -> Matrix {
        let scale = scaled(half, self.scale).to_bits();
        let ([x, y, z], [r0, r1, r2]) = (self.apply(centre), self.rotation);
        let rows = [(r0, x), (r1, y), (r2, z), ([I2F30::ZERO; 3], Length::ONE)];
        let wide = rows.map(|(row, moved)| {
            // 14 fraction bits of the rotation are dropped: 32 are left, 16 of them from the scale.
            let [a, b, c] = row.map(|c| product::signed(c.to_bits(), scale) >> 14);
            [a, b, c, i64::from(moved.to_bits()) << 16]
        });
        Matrix::normalised(wide, 32)
    }
}

type Row = [I2F30; 3];

/// A length times the pose's scale, rounded down.
#[inline(never)]
fn scaled(length: Length, scale: Length) -> Length {
    length_of(product::signed(length.to_bits(), scale.to_bits()) >> 16)
}

/// A number of steps as a length, or the nearest length.
fn length_of(steps: i64) -> Length {
    Length::from_bits(steps.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32)
}

/// Two rows of a rotation, turned from the first towards the second; rounded to nearest.
fn rotated(turn: Turn, from: Row, to: Row) -> (Row, Row) {
    let (sin, cos) = (i64::from(turn.sin()), i64::from(turn.cos()));
    let mix = |u: i64, v: i64| {
        let [a0, a1, a2] = from.map(|c| i64::from(c.to_bits()) * u);
        let [b0, b1, b2] = to.map(|c| i64::from(c.to_bits()) * v);
        let sum = |a: i64, b: i64| I2F30::from_bits(((a + b + (1 << 29)) >> 30) as i32);
        [sum(a0, b0), sum(a1, b1), sum(a2, b2)]
    };
    (mix(cos, -sin), mix(sin, cos))
}

/// Rounded to nearest. Of each product, a step of the result and what is below it are added up apart: neither sum wraps.
fn dot(row: Row, vector: [Length; 3]) -> Length {
    let (mut steps, mut below) = (0, 1 << 29);
    for (r, v) in row.into_iter().zip(vector) {
        let product = product::signed(r.to_bits(), v.to_bits());
        steps += product >> 30;
        below += product as u32 & ((1 << 30) - 1);
    }
    length_of(steps + i64::from(below >> 30))
}

impl Default for Pose {
    fn default() -> Self {
        Self::new()
    }
}

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
        let [_, y, z] = &mut self.rotation;
        rotate(turn, y, z);
        self
    }

    /// Turns about the scene's y axis, from z towards x.
    #[must_use]
    pub fn turned_y(mut self, turn: Turn) -> Self {
        let [x, _, z] = &mut self.rotation;
        rotate(turn, z, x);
        self
    }

    /// Turns about the scene's z axis, from x towards y.
    #[must_use]
    pub fn turned_z(mut self, turn: Turn) -> Self {
        let [x, y, _] = &mut self.rotation;
        rotate(turn, x, y);
        self
    }

    /// Where a point of the mesh stands in the scene, rounded to nearest.
    pub fn apply(&self, point: [Length; 3]) -> [Length; 3] {
        let point = point.map(|c| scaled(c, self.scale).to_bits());
        let [x, y, z] = &self.rotation;
        let [px, py, pz] = self.position;
        let moved = |row, by: Length| Length::from_bits(dot(row, &point, by.to_bits()));
        [moved(x, px), moved(y, py), moved(z, pz)]
    }

    /// A direction of the scene as the mesh sees it, before its turns: the rotation backwards.
    ///
    /// `direction` has 30 fraction bits and length 1, and so has the result.
    pub(crate) fn to_model(self, direction: [i32; 3]) -> [i32; 3] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rotation;
        [[a, d, g], [b, e, h], [c, f, i]].map(|column| dot(&column, &direction, 0))
    }

    /// The matrix from the cube of a mesh, ±1, that has `half` its edge and this `centre`, to the scene.
    pub(crate) fn of_box(&self, centre: [Length; 3], half: Length) -> Matrix {
        let scale = scaled(half, self.scale).to_bits();
        let ([x, y, z], [r0, r1, r2]) = (self.apply(centre), self.rotation);
        let wide = [
            scaled_row(r0, scale, x),
            scaled_row(r1, scale, y),
            scaled_row(r2, scale, z),
            scaled_row([I2F30::ZERO; 3], scale, Length::ONE),
        ];
        Matrix::normalised(&wide, 32)
    }
}

type Row = [I2F30; 3];

/// A length times the pose's scale, rounded down.
#[inline(never)]
fn scaled(length: Length, scale: Length) -> Length {
    Length::from_bits(saturated(product::signed(length.to_bits(), scale.to_bits()) >> 16))
}

/// A row of a rotation times a scale, and how far it is moved, in 32 fraction bits: 14 of the rotation are dropped, and 16
/// come with the scale.
#[inline(never)]
fn scaled_row(row: Row, scale: i32, moved: Length) -> [i64; 4] {
    // Each where it belongs: three and one would be copied.
    core::array::from_fn(|column| match row.get(column) {
        Some(c) => product::signed(c.to_bits(), scale) >> 14,
        None => i64::from(moved.to_bits()) << 16,
    })
}

/// A number of steps, or the nearest of 32 bits.
#[inline(never)]
fn saturated(steps: i64) -> i32 {
    steps.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
}

/// Turns two rows of a rotation, from the first towards the second; rounded to nearest.
fn rotate(turn: Turn, from: &mut Row, to: &mut Row) {
    let (sin, cos) = (turn.sin(), turn.cos());
    for (a, b) in from.iter_mut().zip(to) {
        (*a, *b) = (mixed(*a, cos, *b, -sin), mixed(*a, sin, *b, cos));
    }
}

/// `a u + b v`, rounded to nearest.
#[inline(never)]
fn mixed(a: I2F30, u: i32, b: I2F30, v: i32) -> I2F30 {
    let sum = product::signed(a.to_bits(), u) + product::signed(b.to_bits(), v);
    I2F30::from_bits(((sum + (1 << 29)) >> 30) as i32)
}

/// From some steps on, rounded to nearest. Of each product, a step of the result and what is below it are added up apart:
/// neither sum wraps.
#[inline(never)]
fn dot(row: &Row, vector: &[i32; 3], from: i32) -> i32 {
    let (mut steps, mut below) = (i64::from(from), 1 << 29);
    for (r, &v) in row.iter().zip(vector) {
        let product = product::signed(r.to_bits(), v);
        steps += product >> 30;
        below += product as u32 & ((1 << 30) - 1);
    }
    saturated(steps + i64::from(below >> 30))
}

impl Default for Pose {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a point is held to 32 bits before it is moved, or is not held after.
    #[test]
    fn a_point_is_held_where_it_stands() {
        let corner = [Length::from_num(30_000), Length::from_num(30_000), Length::ZERO];
        let turned = Pose::new().turned_z(Turn::from_degrees(-45));
        let [x, ..] = turned.apply(corner);
        assert_eq!(x, Length::MAX);
        let [x, ..] = turned.at([Length::from_num(-20_000), Length::ZERO, Length::ZERO]).apply(corner);
        // 30 000 sqrt(2) - 20 000: of a sine and a cosine that are right to 2^-15, less than 2 off.
        assert!((x - Length::from_num(22_426.406)).abs() < Length::from_num(2), "{x}");
    }
}

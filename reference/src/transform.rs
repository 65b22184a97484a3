//! Stage 2. Model to clip space, and clip space to the screen.

use crate::matrix::{Matrix, Vec3, Vec4, cross, dot, normalise, sub};
use topleft::{Length, Mesh};

/// The depth code of the far plane. 0 is left for "nothing drawn here".
pub const FAR_CODE: f64 = 4.0;
/// Depth codes between the far and the near plane.
pub const CODES: f64 = 65_528.0;

/// A length of the library in the scene's unit, exactly.
pub fn length(value: Length) -> f64 {
    f64::from(value.to_bits()) / 65_536.0
}

/// Where a vertex of a mesh stands in the scene's unit: `centre + p / 32768 * half`, exactly.
///
/// # Panics
/// The mesh has no such vertex.
pub fn model_position(mesh: &Mesh<'_>, vertex: usize) -> Vec3 {
    let raw = mesh.positions()[vertex];
    let half = length(mesh.half());
    [0, 1, 2].map(|axis| length(mesh.centre()[axis]) + f64::from(raw[axis]) / 32_768.0 * half)
}

/// A stored normal: 127 is 1, and the length is what the rounding of its components made of it.
pub fn normal(raw: [i8; 3]) -> Vec3 {
    raw.map(|component| f64::from(component) / 127.0)
}

/// World to view space: the eye at the origin, looking along -Z, y up.
///
/// # Panics
/// `target` is at `eye`, or `up` lies along the line of sight.
pub fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Matrix {
    let forward = normalise(sub(target, eye));
    let right = normalise(cross(forward, up));
    let up = cross(right, forward);
    let row = |axis: Vec3| [axis[0], axis[1], axis[2], -dot(axis, eye)];
    Matrix([row(right), row(up), row(forward.map(|component| -component)), [0.0, 0.0, 0.0, 1.0]])
}

/// View to clip space with perspective. `fov_y` is the full angle between the top and the bottom edge in radians,
/// `aspect` is width / height. w is the distance along the line of sight; z is 0 at `near` and w at `far`.
pub fn perspective(fov_y: f64, aspect: f64, near: f64, far: f64) -> Matrix {
    let y = 1.0 / (fov_y / 2.0).tan();
    let depth = far / (far - near);
    Matrix([
        [y / aspect, 0.0, 0.0, 0.0],
        [0.0, y, 0.0, 0.0],
        [0.0, 0.0, -depth, -depth * near],
        [0.0, 0.0, -1.0, 0.0],
    ])
}

/// View to clip space without perspective: `height` scene units from the top to the bottom edge, `aspect` is
/// width / height. w is 1; z is 0 at `near` and 1 at `far`.
pub fn orthographic(height: f64, aspect: f64, near: f64, far: f64) -> Matrix {
    let range = far - near;
    Matrix([
        [2.0 / (height * aspect), 0.0, 0.0, 0.0],
        [0.0, 2.0 / height, 0.0, 0.0],
        [0.0, 0.0, -1.0 / range, -near / range],
        [0.0, 0.0, 0.0, 1.0],
    ])
}

/// Where a model stands in the world: scaled, then rotated, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Orthonormal rows.
    pub rotation: [Vec3; 3],
    /// The same on all axes.
    pub scale: f64,
    /// In the scene's unit.
    pub translation: Vec3,
}

impl Pose {
    /// Changes nothing.
    pub const IDENTITY: Self = Self {
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        scale: 1.0,
        translation: [0.0; 3],
    };

    /// Model to world space.
    pub fn matrix(&self) -> Matrix {
        let row = |i: usize| {
            let [x, y, z] = self.rotation[i].map(|component| component * self.scale);
            [x, y, z, self.translation[i]]
        };
        Matrix([row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]])
    }

    /// A direction of the world as the model sees it, for lighting with the model's own normals.
    pub fn direction_to_model(&self, direction: Vec3) -> Vec3 {
        [0, 1, 2].map(|i| dot(self.rotation.map(|row| row[i]), direction))
    }
}

/// The size of a target in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Viewport {
    /// Clip space to pixels: x to the right from the left edge, y down from the top edge. Not rounded.
    pub fn to_screen(&self, clip: Vec4) -> [f64; 2] {
        let (half_width, half_height) = (f64::from(self.width) / 2.0, f64::from(self.height) / 2.0);
        [half_width + clip[0] / clip[3] * half_width, half_height - clip[1] / clip[3] * half_height]
    }
}

/// The depth in codes, not rounded: 65532 on the near plane, 4 on the far one.
///
/// It is linear in screen space. What a pixel stores is [`crate::depth::code`] of it.
pub fn depth(clip: Vec4) -> f64 {
    FAR_CODE + CODES * (1.0 - clip[2] / clip[3])
}

/// 1/w of a vertex as the library documents its word: the upper 26 bits of the reciprocal over a shift of 5 bits.
///
/// # Panics
/// `w` is 0.
pub fn inverse_word(w: u32) -> u32 {
    let shift = w.leading_zeros();
    let mantissa = ((1_u128 << 62) / (u128::from(w) << shift)) as u32;
    mantissa & !31 | (31 - shift)
}

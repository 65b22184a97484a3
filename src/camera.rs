//! Cameras: the one file where floats may enter. Degrees and metres in, an integer matrix out, once a frame.
//!
//! The float work is additions, products and quotients, which are the same on every chip, with a processor for them
//! or without; what `micromath` serves is a rough inverse root that three Newton steps make exact.

#![cfg_attr(
    not(test),
    expect(
        clippy::disallowed_types,
        clippy::float_arithmetic,
        reason = "the camera is where floats may enter"
    )
)]

use core::ops::Range;

use embedded_graphics_core::geometry::Size;
use micromath::F32Ext;

use crate::math::matrix::Matrix;
use crate::math::turn::Turn;
use crate::viewport::{TooLarge, Viewport};

/// What the vertex stage asks of a camera.
///
/// Scenes are right-handed with y up; a camera looks along its own -z. Clip space has x and y in [-w, w], and z from 0
/// at the near plane to w at the far one.
pub trait Camera {
    /// Whether w differs between vertices. A camera that says no links no perspective.
    const PERSPECTIVE: bool;

    /// From the scene to clip space.
    fn matrix(&self) -> &Matrix;

    /// The part of the target that is drawn to.
    ///
    /// # Errors
    /// The target is too large for exact edge values.
    fn viewport(&self) -> Result<Viewport, TooLarge>;
}

/// A perspective camera at the origin, looking along -z, until [`look_at`](Self::look_at) moves it.
///
/// ```
/// use embedded_graphics_core::geometry::Size;
/// use topleft::{Perspective, Turn};
///
/// let camera = Perspective::new(Size::new(240, 240), Turn::from_degrees(50), 0.1..20.0)
///     .look_at([0.0, 2.0, 5.0], [0.0; 3]);
/// assert!(camera.is_valid());
/// assert!(!camera.look_at([1.0, 0.0, 0.0], [f32::NAN; 3]).is_valid());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Perspective(Placed);

/// A camera without perspective, at the origin, looking along -z, until [`look_at`](Self::look_at) moves it.
///
/// ```
/// use embedded_graphics_core::geometry::Size;
/// use topleft::Orthographic;
///
/// let camera = Orthographic::new(Size::new(240, 240), 4.0, 0.0..10.0).look_at([3.0, 3.0, 3.0], [0.0; 3]);
/// assert!(camera.is_valid());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orthographic(Placed);

/// A camera whose matrix was computed elsewhere, for a program without a float in it.
///
/// `PERSPECTIVE` must be true unless the last row of the matrix is 0, 0, 0 and a positive number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MatrixCamera<const PERSPECTIVE: bool> {
    matrix: Matrix,
    /// Of a camera in a `const`, what finds it is not linked.
    viewport: Result<Viewport, TooLarge>,
}

impl<const PERSPECTIVE: bool> MatrixCamera<PERSPECTIVE> {
    /// A camera for a target of `size` pixels that takes the scene to clip space by `matrix`.
    pub const fn new(size: Size, matrix: Matrix) -> Self {
        Self { matrix, viewport: Viewport::new(size) }
    }
}

impl<const PERSPECTIVE: bool> Camera for MatrixCamera<PERSPECTIVE> {
    const PERSPECTIVE: bool = PERSPECTIVE;

    fn matrix(&self) -> &Matrix {
        &self.matrix
    }

    fn viewport(&self) -> Result<Viewport, TooLarge> {
        self.viewport
    }
}

/// A projection, the view before it, and their product.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Placed {
    viewport: Result<Viewport, TooLarge>,
    projection: [[f32; 4]; 4],
    matrix: Matrix,
}

impl Perspective {
    /// A camera for a target of `size` pixels that sees `field_of_view` from top to bottom, and `depth` along its axis
    /// from the near to the far plane, in the scene's unit.
    ///
    /// The nearer the two planes are to each other, the finer is the depth buffer. Where `0 < near < far` does not
    /// hold, or the field of view is not between 0 and half a turn, the camera is not valid and draws nothing.
    pub fn new(size: Size, field_of_view: Turn, depth: Range<f32>) -> Self {
        let half = Turn::new(field_of_view.steps() / 2);
        let (near, far) = (depth.start, depth.end);
        let y = half.cos() as f32 / half.sin() as f32;
        let z = far / (far - near);
        let possible =
            field_of_view.steps() != 0 && field_of_view.steps() < 0x8000 && near > 0.0 && far > near;
        let projection = [
            [y * aspect(size), 0.0, 0.0, 0.0],
            [0.0, y, 0.0, 0.0],
            [0.0, 0.0, -z, -z * near],
            [0.0, 0.0, -1.0, 0.0],
        ];
        Self(Placed::new(size, if possible { projection } else { NOWHERE }))
    }

    /// Puts the camera at `eye` and turns it towards `target`, with the scene's y up.
    ///
    /// Straight up or down, the scene's -z is up. Where the two are one point or not finite, the camera is not valid.
    #[must_use]
    pub fn look_at(self, eye: [f32; 3], target: [f32; 3]) -> Self {
        Self(self.0.look_at(eye, target))
    }

    /// Whether there is such a camera. One that is not valid draws nothing.
    pub fn is_valid(&self) -> bool {
        self.0.matrix != Matrix::NOWHERE
    }
}

impl Orthographic {
    /// A camera for a target of `size` pixels that sees `height` from top to bottom, and `depth` along its axis from
    /// the near to the far plane, in the scene's unit.
    ///
    /// Where `near < far` does not hold, the height is not positive, or any of them is not finite, the camera is not
    /// valid and draws nothing.
    pub fn new(size: Size, height: f32, depth: Range<f32>) -> Self {
        let (near, far) = (depth.start, depth.end);
        let y = 2.0 / height;
        let z = 1.0 / (far - near);
        let projection = [
            [y * aspect(size), 0.0, 0.0, 0.0],
            [0.0, y, 0.0, 0.0],
            [0.0, 0.0, -z, -z * near],
            [0.0, 0.0, 0.0, 1.0],
        ];
        let possible = height > 0.0 && far > near && height.is_finite() && (far - near).is_finite();
        Self(Placed::new(size, if possible { projection } else { NOWHERE }))
    }

    /// Puts the camera at `eye` and turns it towards `target`, with the scene's y up.
    ///
    /// Straight up or down, the scene's -z is up. Where the two are one point or not finite, the camera is not valid.
    #[must_use]
    pub fn look_at(self, eye: [f32; 3], target: [f32; 3]) -> Self {
        Self(self.0.look_at(eye, target))
    }

    /// Whether there is such a camera. One that is not valid draws nothing.
    pub fn is_valid(&self) -> bool {
        self.0.matrix != Matrix::NOWHERE
    }
}

impl Camera for Perspective {
    const PERSPECTIVE: bool = true;

    fn matrix(&self) -> &Matrix {
        &self.0.matrix
    }

    fn viewport(&self) -> Result<Viewport, TooLarge> {
        self.0.viewport
    }
}

impl Camera for Orthographic {
    const PERSPECTIVE: bool = false;

    fn matrix(&self) -> &Matrix {
        &self.0.matrix
    }

    fn viewport(&self) -> Result<Viewport, TooLarge> {
        self.0.viewport
    }
}

const NOWHERE: [[f32; 4]; 4] = [[0.0; 4]; 4];

/// Height over width; an empty target counts as square.
fn aspect(size: Size) -> f32 {
    size.height.max(1) as f32 / size.width.max(1) as f32
}

impl Placed {
    #[inline(never)]
    fn new(size: Size, projection: [[f32; 4]; 4]) -> Self {
        Self { viewport: Viewport::new(size), projection, matrix: Matrix::from_floats(projection) }
    }

    #[inline(never)]
    fn look_at(self, eye: [f32; 3], target: [f32; 3]) -> Self {
        let back = unit(minus(eye, target));
        let vertical = (back[0].abs().to_bits() | back[2].abs().to_bits()) == 0;
        let up = if vertical { [0.0, 0.0, -1.0] } else { [0.0, 1.0, 0.0] };
        let right = unit(cross(up, back));
        let above = cross(back, right);
        let view = [right, above, back].map(|axis| {
            let [x, y, z] = axis;
            [x, y, z, -dot(axis, eye)]
        });
        let [r0, r1, r2] = view;
        let view = Matrix::from_floats([r0, r1, r2, [0.0, 0.0, 0.0, 1.0]]);
        Self { matrix: Matrix::from_floats(self.projection).times(&view), ..self }
    }
}

impl Matrix {
    /// A matrix of floats, row by row, to 29 bits of the largest. Usable in a `const`.
    ///
    /// An element that is not finite makes the whole [`Matrix::NOWHERE`].
    pub const fn from_floats(rows: [[f32; 4]; 4]) -> Self {
        /// Sign, exponent and mantissa of a finite float: it is `mantissa * 2^(exponent - 150)`.
        const fn parts(value: f32) -> (i64, i32) {
            let bits = value.to_bits();
            let exponent = (bits >> 23 & 0xFF) as i32;
            let mantissa = (bits & 0x7F_FFFF) as i64;
            let (mantissa, exponent) =
                if exponent == 0 { (mantissa, 1) } else { (mantissa | 0x80_0000, exponent) };
            (if bits >> 31 == 0 { mantissa } else { -mantissa }, exponent)
        }
        /// An element below the exponent of the largest: 24 bits and 32 more. What is that far below it vanishes, and so do
        /// zeros.
        #[inline(never)]
        const fn below(value: f32, largest: i32) -> i64 {
            let (mantissa, exponent) = parts(value);
            let below = largest - exponent;
            if below >= 0 && below < 63 { (mantissa << 32) >> below } else { 0 }
        }
        #[inline(never)]
        const fn aligned([a, b, c, d]: [f32; 4], largest: i32) -> [i64; 4] {
            [below(a, largest), below(b, largest), below(c, largest), below(d, largest)]
        }
        let mut largest = 0;
        let mut i = 0;
        while i < 16 {
            let element = rows[i / 4][i % 4];
            if !element.is_finite() {
                return Self::NOWHERE;
            }
            let (mantissa, exponent) = parts(element);
            if mantissa != 0 && exponent > largest {
                largest = exponent;
            }
            i += 1;
        }
        if largest == 0 {
            return Self::NOWHERE;
        }
        let [a, b, c, d] = rows;
        let wide = [aligned(a, largest), aligned(b, largest), aligned(c, largest), aligned(d, largest)];
        Self::normalised(&wide, 150 + 32 - largest)
    }
}

fn minus([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    [a - x, b - y, c - z]
}

fn dot([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> f32 {
    a * x + b * y + c * z
}

fn cross([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// The vector with length 1, to 2^-22; NaN where there is none.
fn unit(vector: [f32; 3]) -> [f32; 3] {
    // Scaled by the largest component first, so that no square overflows or vanishes.
    // Floats that are not negative are in the order of their bits, NaN after all others: no comparison of floats is linked.
    let [x, y, z] = vector.map(|c| c.abs().to_bits());
    let largest = f32::from_bits(x.max(y).max(z));
    let vector = vector.map(|c| c / largest);
    let square = dot(vector, vector);
    // 1 to 3 where there is a direction; `invsqrt` counts on a positive number.
    if !(0.5_f32.to_bits()..4.0_f32.to_bits()).contains(&square.to_bits()) {
        return [f32::NAN; 3];
    }
    // Off by 3.4 % at the most; three Newton steps leave 0.17 %, 4.6e-6 and 3e-11.
    let mut inverse = F32Ext::invsqrt(square);
    for _ in 0..3 {
        inverse *= 1.5 - 0.5 * square * inverse * inverse;
    }
    vector.map(|c| c * inverse)
}

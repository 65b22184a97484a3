//! Vectors as plain arrays, and 4x4 matrices that act on columns, written out.

/// x, y, z.
pub type Vec3 = [f64; 3];
/// x, y, z, w.
pub type Vec4 = [f64; 4];

/// The dot product.
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The right-handed cross product.
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `a - b`.
pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a` at length 1.
///
/// # Panics
/// `a` has no direction: its length is 0 or not finite.
pub fn normalise(a: Vec3) -> Vec3 {
    let length = dot(a, a).sqrt();
    assert!(length > 0.0 && length.is_finite(), "the vector {a:?} has no direction");
    a.map(|component| component / length)
}

/// A 4x4 matrix, row by row; it acts on a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix(pub [[f64; 4]; 4]);

impl Matrix {
    /// Changes nothing.
    pub const IDENTITY: Self =
        Self([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]);

    /// The product `self * v`.
    pub fn apply(&self, v: Vec4) -> Vec4 {
        self.0.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + row[3] * v[3])
    }

    /// The product of `self` and a point, which has w = 1.
    pub fn apply_point(&self, p: Vec3) -> Vec4 {
        self.apply([p[0], p[1], p[2], 1.0])
    }

    /// First `self`, then `next`: the product `next * self`.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let column = |j: usize| next.apply(self.0.map(|row| row[j]));
        let columns = [column(0), column(1), column(2), column(3)];
        let row = |i: usize| columns.map(|column| column[i]);
        Self([row(0), row(1), row(2), row(3)])
    }
}

/// The rotation by `radians` about `axis`, counter-clockwise as seen from the axis' tip (Rodrigues' formula).
///
/// # Panics
/// `axis` has no direction.
pub fn rotation(axis: Vec3, radians: f64) -> [Vec3; 3] {
    let [x, y, z] = normalise(axis);
    let (sin, cos) = radians.sin_cos();
    let rest = 1.0 - cos;
    [
        [cos + x * x * rest, x * y * rest - z * sin, x * z * rest + y * sin],
        [y * x * rest + z * sin, cos + y * y * rest, y * z * rest - x * sin],
        [z * x * rest - y * sin, z * y * rest + x * sin, cos + z * z * rest],
    ]
}

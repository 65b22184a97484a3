//! Any target and any camera.

use arbitrary::Arbitrary;
use embedded_graphics_core::geometry::Size;
use topleft::{Camera, Matrix, MatrixCamera, Orthographic, Perspective, Turn};

use crate::numbers::{Mostly, Number, Real};

/// Any size: most of them below 64, some up to 2^16, some beyond what can be drawn to.
pub(crate) type Target = Mostly<[u8; 2], Mostly<[u16; 2], [u32; 2]>>;

impl Target {
    pub(crate) fn size(self) -> Size {
        let [width, height] = match self {
            Self::Usual(size) => size.map(|length| u32::from(length % 64)),
            Self::Any(Mostly::Usual(size)) => size.map(u32::from),
            Self::Any(Mostly::Any(size)) => size,
        };
        Size::new(width, height)
    }
}

/// Any camera: one that looks at the origin from near by, or whatever the bits say.
pub(crate) type Lens = Mostly<Orbit, AnyLens>;

/// From a point up to 4 of the scene's unit away on each axis, with perspective or without.
#[derive(Arbitrary, Clone, Debug)]
pub(crate) struct Orbit {
    pub(crate) perspective: bool,
    pub(crate) eye: [i8; 3],
    /// Of the field of view, or of the height that is seen.
    pub(crate) wide: u8,
    pub(crate) near: u8,
}

#[derive(Arbitrary, Clone, Debug)]
pub(crate) enum AnyLens {
    Perspective { field: u16, depth: [Real; 2], look: Option<[[Real; 3]; 2]> },
    Orthographic { height: Real, depth: [Real; 2], look: Option<[[Real; 3]; 2]> },
    Matrix { perspective: bool, rows: [[Number; 4]; 4] },
}

/// One of two cameras: which keeps small what is compiled.
pub(crate) enum Seen {
    Perspective(MatrixCamera<true>),
    Level(MatrixCamera<false>),
}

impl Seen {
    fn by<C: Camera>(camera: &C, size: Size) -> Self {
        if C::PERSPECTIVE {
            Self::Perspective(MatrixCamera::new(size, *camera.matrix()))
        } else {
            Self::Level(MatrixCamera::new(size, *camera.matrix()))
        }
    }

    /// From the scene to clip space, unless the camera claims to be level and is not.
    pub(crate) fn matrix(&self) -> Option<&Matrix> {
        match self {
            Self::Perspective(camera) => Some(camera.matrix()),
            Self::Level(camera) => {
                Some(camera.matrix()).filter(|matrix| matches!(matrix.row(3), [0, 0, 0, _]))
            }
        }
    }
}

impl Lens {
    /// The camera for a target. It may be one that draws nothing, or that claims to be level and is not.
    pub(crate) fn camera(&self, size: Size) -> Seen {
        match self {
            Self::Usual(Orbit { perspective, eye, wide, near }) => {
                let eye = eye.map(|c| f32::from(c) / 32.0);
                let near = 0.01 + f32::from(*near) / 256.0;
                let depth = near..near + 6.0;
                if *perspective {
                    let field = Turn::from_degrees(5 + i32::from(*wide) * 2 / 3);
                    Seen::by(&Perspective::new(size, field, depth).look_at(eye, [0.0; 3]), size)
                } else {
                    let height = (f32::from(*wide) + 1.0) / 64.0;
                    Seen::by(&Orthographic::new(size, height, depth).look_at(eye, [0.0; 3]), size)
                }
            }
            Self::Any(AnyLens::Perspective { field, depth, look }) => {
                let [near, far] = depth.map(Real::value);
                let camera = Perspective::new(size, Turn::new(*field), near..far);
                let look = look.map(|look| look.map(|at| at.map(Real::value)));
                Seen::by(&look.map_or(camera, |[eye, target]| camera.look_at(eye, target)), size)
            }
            Self::Any(AnyLens::Orthographic { height, depth, look }) => {
                let [near, far] = depth.map(Real::value);
                let camera = Orthographic::new(size, height.value(), near..far);
                let look = look.map(|look| look.map(|at| at.map(Real::value)));
                Seen::by(&look.map_or(camera, |[eye, target]| camera.look_at(eye, target)), size)
            }
            Self::Any(AnyLens::Matrix { perspective, rows }) => {
                let matrix = Matrix::new(rows.map(|row| row.map(Number::length)));
                if *perspective {
                    Seen::Perspective(MatrixCamera::new(size, matrix))
                } else {
                    Seen::Level(MatrixCamera::new(size, matrix))
                }
            }
        }
    }
}

//! Stages 3 to 5 in one. Which pixel centres a face covers, without cutting it at any plane: by the signs of its edges
//! and planes at the centre in homogeneous coordinates, in exact integers.
//!
//! With `u_k` the way on the screen from the centre to corner k, times that corner's w, the point of the face that is
//! seen at the centre is the sum of the corners in parts of `e_0 = u_1 x u_2`, `e_1 = u_2 x u_0` and `e_2 = u_0 x u_1`.
//! It is on the face where all three have one sign, and between the planes where `e . z` and `e . (w - z)`, which add up
//! to `e . w`, have that sign too: there w is positive. Nothing is divided, so a corner may be anywhere, behind the eye
//! as well.

use crate::setup::Facing;
use crate::transform::Viewport;

/// A face in clip space, of which each coordinate is known to within an error.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    corners: [[i64; 4]; 3],
    error: i64,
}

/// What holds at a pixel's centre whatever the coordinates are within their error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sure {
    /// The face covers it, and shows this side.
    Inside(Facing),
    /// The face does not cover it.
    Outside,
}

/// A number and how far it may be off.
#[derive(Clone, Copy)]
struct About(i128, i128);

impl About {
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }

    fn minus(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 + other.1)
    }

    fn times(self, other: Self) -> Self {
        let error = self.0.abs() * other.1 + other.0.abs() * self.1 + self.1 * other.1;
        Self(self.0 * other.0, error)
    }

    /// 1 or -1 where that is sure.
    fn sign(self) -> i128 {
        if self.0.abs() > self.1 { self.0.signum() } else { 0 }
    }
}

impl Face {
    /// A face of these corners, x, y, z and w in any unit, of which each may be off by `error`; or nothing where a
    /// coordinate has more than 31 bits, or an error more than 16: products would not fit.
    pub fn new(corners: [[i64; 4]; 3], error: i64) -> Option<Self> {
        let fit = corners.iter().flatten().all(|c| c.unsigned_abs() <= 1 << 31);
        (fit && (0..1 << 16).contains(&error)).then_some(Self { corners, error })
    }

    /// What is sure at the centre of a pixel, wherever it is moved by `band` of 1/256 px or less on each axis. An error
    /// of x and of y counts in units of the screen's longer side: a library may keep them in larger ones than its half.
    ///
    /// # Panics
    /// The view is wider or higher than 64 pixels, or the pixel is outside of it.
    pub fn at(&self, view: Viewport, [x, y]: [u32; 2], band: i64) -> Option<Sure> {
        assert!(x < view.width && view.width <= 64 && y < view.height && view.height <= 64);
        let error = i128::from(self.error);
        // 1/256 px, and the screen's half on each axis.
        let half = [view.width, view.height].map(|side| i128::from(side) * 128);
        let reach = 2 * half[0].max(half[1]);
        let [cx, cy] = [i128::from(x), i128::from(y)].map(|c| c * 256 + 128);
        let centre = [cx - half[0], half[1] - cy].map(|c| About(c, band.into()));
        let ways = self.corners.map(|[x, y, _, w]| {
            let w = About(w.into(), error);
            let on_screen =
                [i128::from(x) * half[0], i128::from(y) * half[1]].map(|c| About(c, error * reach));
            [0, 1].map(|axis| on_screen[axis].minus(centre[axis].times(w)))
        });
        let cross = |p: [About; 2], q: [About; 2]| p[0].times(q[1]).minus(p[1].times(q[0]));
        let [u, v, w] = ways;
        let parts = [cross(v, w), cross(w, u), cross(u, v)];
        let sum = |coordinate: fn(i128, i128) -> i128, errors: i128| {
            let mut sum = About(0, 0);
            for (part, &[_, _, z, w]) in parts.iter().zip(&self.corners) {
                sum = sum.plus(part.times(About(coordinate(z.into(), w.into()), error * errors)));
            }
            sum
        };
        let [a, b, c] = parts.map(About::sign);
        let signs = [a, b, c, sum(|z, _| z, 1).sign(), sum(|z, w| w - z, 2).sign()];
        if signs.contains(&1) && signs.contains(&-1) {
            Some(Sure::Outside)
        } else if signs.contains(&0) {
            None
        } else {
            // y grows upwards here.
            Some(Sure::Inside(if a > 0 { Facing::Front } else { Facing::Back }))
        }
    }
}

//! Markers: shapes that differ without their colours, in colours that differ without their hue.

use super::canvas::{Canvas, Colour};

/// A shape and its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    corners: &'static [[i32; 2]],
    pub(crate) colour: Colour,
}

/// Whole for what was measured, hollow for a bound or a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fill {
    Whole,
    Hollow,
}

impl Shape {
    /// From dark to light.
    pub(crate) const SQUARE: Self =
        Self { corners: &[[-5, -5], [5, -5], [5, 5], [-5, 5]], colour: [40, 12, 84] };
    pub(crate) const CIRCLE: Self = Self { corners: &[], colour: [150, 20, 40] };
    pub(crate) const TRIANGLE: Self = Self { corners: &[[0, -7], [7, 5], [-7, 5]], colour: [0, 120, 160] };
    pub(crate) const DIAMOND: Self =
        Self { corners: &[[0, -7], [7, 0], [0, 7], [-7, 0]], colour: [215, 120, 30] };
    pub(crate) const DOWN: Self = Self { corners: &[[0, 7], [7, -5], [-7, -5]], colour: [120, 200, 100] };
    pub(crate) const STAR: Self = Self {
        corners: &[[0, -8], [3, -3], [8, 0], [3, 3], [0, 8], [-3, 3], [-8, 0], [-3, -3]],
        colour: [110, 110, 110],
    };
    /// All of them.
    pub(crate) const ALL: [Self; 6] =
        [Self::SQUARE, Self::CIRCLE, Self::TRIANGLE, Self::DIAMOND, Self::DOWN, Self::STAR];

    /// Draws it round a place.
    pub(crate) fn draw(self, canvas: &Canvas<'_>, [x, y]: [i32; 2], fill: Fill) {
        let filled = fill == Fill::Whole;
        if self.corners.is_empty() {
            canvas.circle([x, y], 6, self.colour, filled);
        } else {
            let corners: Vec<_> = self.corners.iter().map(|&[dx, dy]| [x + dx, y + dy]).collect();
            canvas.polygon(&corners, self.colour, filled);
        }
    }
}

//! Stage 4. Snapping to 1/256 pixel, the doubled area, facing and culling, and the fan of a clipped polygon.

/// A triangle on the screen: three corners in steps of 1/256 pixel, x to the right, y down.
pub type Triangle = [[i32; 2]; 3];

/// A pixel coordinate in steps of 1/256 pixel: rounded to nearest, ties towards +infinity (right, down), and
/// saturated to ±8 388 608 pixels. Nothing when it is not finite.
pub fn snap(pixels: f64) -> Option<i32> {
    if !pixels.is_finite() {
        return None;
    }
    let steps = pixels * 256.0;
    let below = steps.floor();
    // Not floor(steps + 0.5): that sum can round up by itself.
    let nearest = if steps - below >= 0.5 { below + 1.0 } else { below };
    // The cast saturates.
    Some(nearest as i32)
}

/// Twice the signed area in (1/256 px)^2: negative when the corners run counter-clockwise as seen on the screen.
pub fn area2(triangle: Triangle) -> i128 {
    let [a, b, c] = triangle.map(|corner| corner.map(i128::from));
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// Which side of a triangle the viewer sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Counter-clockwise on the screen.
    Front,
    /// Clockwise on the screen.
    Back,
    /// No area after snapping: covers nothing.
    Edge,
}

/// Which side of a snapped triangle the viewer sees.
pub fn facing(triangle: Triangle) -> Facing {
    match area2(triangle) {
        0 => Facing::Edge,
        area if area < 0 => Facing::Front,
        _ => Facing::Back,
    }
}

/// Which triangles are not drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cull {
    /// Those whose back is seen.
    #[default]
    Back,
    /// Those whose front is seen.
    Front,
    /// Only those without area.
    None,
}

impl Cull {
    /// Whether a triangle seen from this side is drawn.
    pub fn keeps(self, facing: Facing) -> bool {
        match facing {
            Facing::Front => self != Self::Front,
            Facing::Back => self != Self::Back,
            Facing::Edge => false,
        }
    }
}

/// The triangles of a snapped convex polygon, as indices of its corners: a fan from the corner with the least y, of
/// several the one with the least x, of equal ones the first.
pub fn fan(corners: &[[i32; 2]]) -> Vec<[usize; 3]> {
    let count = corners.len();
    let Some(least) = (0..count).min_by_key(|&i| (corners[i][1], corners[i][0])) else {
        return Vec::new();
    };
    (1..count.saturating_sub(1)).map(|i| [least, (least + i) % count, (least + i + 1) % count]).collect()
}

//! The walk by the size of the box: boxes for the smallest triangles, spans for all others.

use super::{BoxWalk, DrawSpan, Spans, Traversal, Window};
use crate::math::format::SUBPIXEL_BITS;
use crate::setup::Setup;

/// [`BoxWalk`] for triangles that are at most 4 px wide and high, [`Spans`] for all others: the same pixels.
///
/// Spans have two or three slopes to find before their first row, and a box three edge functions to step at every pixel.
/// Where the box has 16 pixels or fewer it is cheaper, and choosing takes a test of most other triangles. Both walks are
/// linked.
///
/// ```
/// use topleft::{BySize, Depth16, DrawList};
///
/// let list = DrawList::<u16, Depth16, BySize>::with_traversal(&mut [], &mut []);
/// assert_eq!(list.stats().drawn, 0);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct BySize;

/// The greatest width and height of a triangle whose box is walked, in steps of 1/256 px.
const LARGEST: i32 = 4 << SUBPIXEL_BITS;

impl Traversal for BySize {
    #[inline]
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        if is_tiny(setup) {
            BoxWalk::spans(setup, window, target)
        } else {
            Spans::spans(setup, window, target)
        }
    }
}

#[inline(always)]
fn is_tiny(setup: &Setup) -> bool {
    let [a, b, c] = setup.points();
    // The rows are in order, and most triangles are too high.
    if c.y.to_bits() - a.y.to_bits() > LARGEST {
        return false;
    }
    let (a, b, c) = (a.x.to_bits(), b.x.to_bits(), c.x.to_bits());
    a.max(b).max(c) - a.min(b).min(c) <= LARGEST
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::snapped::Snapped;

    // Red when one of the axes is not looked at, or one of the vertices.
    #[test]
    fn a_triangle_is_tiny_up_to_4_pixels_on_both_axes() {
        let tiny = |corners: [[i32; 2]; 3]| {
            let (setup, _) = Setup::new(corners.map(|[x, y]| Snapped::from_bits(x, y))).expect("an area");
            is_tiny(&setup)
        };
        // Each of the three, from the top down, is once at a side that moves, mirrored or not.
        for corners in [
            [[0, 0], [900, 10], [1024, 1024]],
            [[0, 0], [1024, 500], [10, 1024]],
            [[1024, 0], [10, 900], [0, 1024]],
        ] {
            for mirror in [1, -1] {
                let at = |wide: i32, high: i32| {
                    let far = |c: i32, more: i32| if c == 1024 { c + more } else { c };
                    corners.map(|[x, y]| [mirror * far(x, wide), far(y, high)])
                };
                assert!(tiny(at(0, 0)));
                assert!(!tiny(at(1, 0)) && !tiny(at(0, 1)));
            }
        }
    }
}

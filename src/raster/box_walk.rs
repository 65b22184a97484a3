//! The bounding-box walk: three edge functions at every pixel.

use super::{DrawSpan, Span, Traversal, Window};
use crate::math::format::{HALF_PIXEL, SUBPIXEL_BITS, SUBPIXELS};
use crate::setup::Setup;
use crate::snapped::{Snapped, first_centre};

/// Tests the three edge functions at every pixel centre of the bounding box.
///
/// Same pixels as [`Spans`](super::Spans), without any division. Cheaper than those up to about 4 px only, and dearer the larger
/// a triangle is: [`BySize`](super::BySize) picks.
#[derive(Clone, Copy, Debug, Default)]
pub struct BoxWalk;

impl Traversal for BoxWalk {
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        let [a, b, c] = setup.points();
        let (ax, bx, cx) =
            (first_centre(a.x.to_bits()), first_centre(b.x.to_bits()), first_centre(c.x.to_bits()));
        let left = ax.min(bx).min(cx).max(window.columns.start);
        // A vertex exactly on a centre covers nothing to its right: the first centre at or beyond it is the end.
        let right = ax.max(bx).max(cx).min(window.columns.end);
        let rows = setup.rows();
        let (top, bottom) = (rows.start.max(window.rows.start), rows.end.min(window.rows.end));
        if left >= right || top >= bottom {
            return Ok(());
        }
        // Clockwise as seen, so that all three are positive inside.
        let (b, c) = if setup.area2() > 0 { (b, c) } else { (c, b) };
        let new = |from, to| EdgeFunction::new(from, to, left, top);
        let (mut p, mut q, mut r) = (new(a, b), new(b, c), new(c, a));
        for y in top..bottom {
            let (mut u, mut v, mut w, mut x) = (p.value, q.value, r.value, left);
            // All three are at least zero where none has its sign bit set.
            while x < right && u | v | w < 0 {
                core::hint::black_box(());
                (u, v, w) = (u.wrapping_sub(p.dy), v.wrapping_sub(q.dy), w.wrapping_sub(r.dy));
                x += 1;
            }
            let start = x;
            while x < right && u | v | w >= 0 {
                core::hint::black_box(());
                (u, v, w) = (u.wrapping_sub(p.dy), v.wrapping_sub(q.dy), w.wrapping_sub(r.dy));
                x += 1;
            }
            if start < x {
                target.draw(Span { y, start, end: x })?;
            }
            p.value = p.value.wrapping_add(p.dx);
            q.value = q.value.wrapping_add(q.dx);
            r.value = r.value.wrapping_add(r.dx);
        }
        Ok(())
    }
}

/// `E' = floor((E - bias) / 256)` with `E = dx (Py - Ay) - dy (Px - Ax)`: at least zero inside, or on a top or left edge.
///
/// At pixel centres E is the same modulo 256, so dividing by it loses nothing, and E' steps by dx and dy themselves.
/// It fits an `i32` inside the guard rectangle; what wraps is beyond the bounding box and is not used.
#[derive(Clone, Copy, Debug)]
struct EdgeFunction {
    value: i32,
    dx: i32,
    dy: i32,
}

impl EdgeFunction {
    /// The edge between two vertices, at the centre of the pixel in column `x` and row `y`.
    #[inline]
    fn new(from: Snapped, to: Snapped, x: i32, y: i32) -> Self {
        let ((ax, ay), (bx, by)) = (from.bits(), to.bits());
        let (dx, dy) = (bx - ax, by - ay);
        let top_left = dy < 0 || (dy == 0 && dx > 0);
        // From the vertex to the centre of its own pixel, and from there by whole pixels.
        let to_centre = |coordinate: i32| HALF_PIXEL - (coordinate & (SUBPIXELS - 1));
        let within = dx * to_centre(ay) - dy * to_centre(ax) - i32::from(!top_left);
        let columns = x - (ax >> SUBPIXEL_BITS);
        let rows = y - (ay >> SUBPIXEL_BITS);
        let value = dx
            .wrapping_mul(rows)
            .wrapping_sub(dy.wrapping_mul(columns))
            .wrapping_add(within >> SUBPIXEL_BITS);
        Self { value, dx, dy }
    }
}

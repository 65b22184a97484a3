//! The span walk: two edges from row to row, without any test or rounding a pixel.

use core::marker::PhantomData;
use core::ops::Range;

use super::edge::{Dda, ShortEdge};
use super::kernel::{self, Kernel};
use super::small_triangle::SmallTriangle;
use super::trapezoids::Trapezoids;
use super::{DrawSpan, Traversal, Window};
use crate::setup::Setup;

/// Walks the rows of a triangle with an exact integer edge on either side: no test and no rounding per pixel.
///
/// With the top-left rule both ends of a span are the same function of an edge, the first pixel centre at or right of
/// it, whichever side the triangle is on: so neighbours cannot disagree. Edges are integer DDAs, or one addition a row
/// where the triangle is small enough for that to be exact as well.
///
/// The cheapest for all but the smallest triangles: up to 4 px [`BySize`](super::BySize) is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spans;

impl Traversal for Spans {
    #[inline]
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        match &Sides::new(setup, window) {
            Sides::None => Ok(()),
            Sides::Short(trapezoids) => trapezoids.rows(&window.columns, target),
            Sides::Long(trapezoids) => trapezoids.rows(&window.columns, target),
        }
    }
}

/// [`Spans`], with small triangles drawn by a chip's own [`Kernel`], where it has what they need: the same bytes, faster.
#[derive(Clone, Copy, Debug, Default)]
pub struct SpansBy<K>(PhantomData<K>);

impl<K: Kernel> Traversal for SpansBy<K> {
    #[inline]
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        if !target.has_kernels() {
            return Spans::spans(setup, window, target);
        }
        let (top, bottom) = short_rows(setup, window);
        let trapezoids = if top < bottom {
            let found = K::sides(SmallTriangle::new(setup, top..bottom));
            let trapezoids = found.trapezoids();
            if target.rows::<K>(kernel::Sides { trapezoids, columns: &window.columns }) {
                return Ok(());
            }
            // One walk is linked for each shader, not two: that of the stages that no kernel takes the place of.
            Trapezoids::from_short(trapezoids)
        } else {
            let rows = rows(setup, window);
            if rows.is_empty() {
                return Ok(());
            }
            long(setup, rows)
        };
        trapezoids.rows(&window.columns, target)
    }
}

/// A triangle's edges. Whatever is drawn between them, this is linked once.
enum Sides {
    /// It crosses no row of the window.
    None,
    Short(Trapezoids<ShortEdge>),
    Long(Trapezoids<Dda>),
}

impl Sides {
    #[inline(never)]
    fn new(setup: &Setup, window: &Window) -> Self {
        let rows = rows(setup, window);
        if rows.is_empty() {
            Self::None
        } else if ShortEdge::suits(setup, &window.columns) {
            Self::Short(Trapezoids::new(setup, rows))
        } else {
            Self::Long(Trapezoids::new(setup, rows))
        }
    }
}

/// Sides that are walked exactly, linked once.
#[inline(never)]
fn long(setup: &Setup, rows: Range<i32>) -> Trapezoids<Dda> {
    Trapezoids::new(setup, rows)
}

/// The rows of a window that a triangle crosses.
#[inline(always)]
fn rows(setup: &Setup, window: &Window) -> Range<i32> {
    let rows = setup.rows();
    rows.start.max(window.rows.start)..rows.end.min(window.rows.end)
}

/// The same from one to another, of triangles whose edges are short: none of all others.
#[inline(never)]
fn short_rows(setup: &Setup, window: &Window) -> (i32, i32) {
    if ShortEdge::suits(setup, &window.columns) {
        let Range { start, end } = rows(setup, window);
        (start, end)
    } else {
        (0, 0)
    }
}

//! Spans of single triangles against the crossings of edges in 128-bit integers.

use reference::raster::row_span;
use reference::setup::{Triangle, area2};
use topleft::stages::{Span, Traversal, Window};

use super::winding::setup;

/// Nothing where the spans of a traversal are those of the reference.
pub(crate) fn compare<T: Traversal>(
    triangle: Triangle,
    window: &Window,
    expected: &[Span],
) -> Result<(), String> {
    let Some(setup) = setup(triangle) else {
        return if area2(triangle) == 0 { Ok(()) } else { Err("a triangle with an area is left out".into()) };
    };
    let mut rest = expected.iter();
    T::walk(&setup, window, |span| match rest.next() {
        Some(&right) if right == span => Ok(()),
        right => Err(format!("{} has {span:?} instead of {right:?}", std::any::type_name::<T>())),
    })?;
    match rest.next() {
        None => Ok(()),
        Some(span) => Err(format!("{} misses {span:?}", std::any::type_name::<T>())),
    }
}

/// The exact spans of a triangle inside a window.
pub(crate) fn expected(triangle: Triangle, window: &Window) -> Vec<Span> {
    if area2(triangle) == 0 {
        return Vec::new();
    }
    let span = |y: i32| {
        let (start, end) = row_span(triangle, i64::from(y))?;
        let start = start.max(i64::from(window.columns.start)) as i32;
        let end = end.min(i64::from(window.columns.end)) as i32;
        (start < end).then_some(Span { y, start, end })
    };
    window.rows.clone().filter_map(span).collect()
}

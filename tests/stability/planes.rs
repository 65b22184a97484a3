//! What the library interpolates over a triangle.

use core::convert::Infallible;

use reference::setup::Triangle;
use topleft::Spans;
use topleft::stages::{Setup, Snapped, Traversal, Varying, Window};

/// Calls `each` with column, row and value at each pixel of a triangle in a window; not at all for one without an area.
pub(crate) fn values<V: Varying>(
    triangle: Triangle,
    values: [V; 3],
    window: &Window,
    mut each: impl FnMut(i32, i32, V),
) {
    let corners = triangle.map(|[x, y]| Snapped::from_bits(x, y));
    let Some((setup, order)) = Setup::new(corners) else { return };
    let gradients = setup.gradients();
    let plane = V::plane(&gradients, order.map(|i| values[i]));
    let [ax, ay] = gradients.anchor();
    let Ok(()) = Spans::walk(&setup, window, |span| {
        let mut value = plane.at(span.start - ax, span.y - ay);
        for x in span.start..span.end {
            each(x, span.y, value);
            value = value.plus(plane.dx);
        }
        Ok::<_, Infallible>(())
    });
}

//! Hits of triangles, and what they must be: the winding number of what bounds them, in 128-bit integers.

use reference::setup::Triangle;
use topleft::stages::{Setup, Snapped, Traversal, Window};

/// A directed edge in 1/256 px.
pub(crate) type Edge = [[i32; 2]; 2];

/// How often the edges wind round each pixel centre, counter-clockwise as seen; the edges form closed loops.
///
/// By the top-left rule an edge counts for all centres at or right of it, in the rows with centres from its upper end on
/// and above its lower one.
pub(crate) fn winding_of(edges: &[Edge], width: usize, height: usize) -> Vec<i32> {
    let mut grid = vec![0; width * height];
    for &[from, to] in edges {
        // Down on the left side of what is counter-clockwise.
        let (upper, lower, sign) = if from[1] < to[1] { (from, to, 1) } else { (to, from, -1) };
        let [ux, uy] = upper.map(i128::from);
        let [lx, ly] = lower.map(i128::from);
        for (y, row) in grid.chunks_mut(width).enumerate() {
            let centre = y as i128 * 256 + 128;
            if uy <= centre && centre < ly {
                // The least x with (256 x + 128 - ux) (ly - uy) >= (lx - ux) (centre - uy).
                let right = (lx - ux) * (centre - uy) + (ux - 128) * (ly - uy);
                let first = -(-right).div_euclid(256 * (ly - uy));
                if let Some(cell) = row.get_mut(first.max(0) as usize) {
                    *cell += sign;
                }
            }
        }
    }
    for row in grid.chunks_mut(width) {
        let mut sum = 0;
        for cell in row {
            sum += *cell;
            *cell = sum;
        }
    }
    grid
}

/// The triangle as set-up knows it, or nothing where it has no area.
pub(crate) fn setup(triangle: Triangle) -> Option<Setup> {
    Setup::new(triangle.map(|[x, y]| Snapped::from_bits(x, y))).map(|(setup, _)| setup)
}

/// Front hits minus back hits, and all hits, of each pixel.
pub(crate) struct Grids {
    pub(crate) signed: Vec<i32>,
    pub(crate) all: Vec<i32>,
}

/// Walks the triangles over a frame.
pub(crate) fn hits<T: Traversal>(
    triangles: impl IntoIterator<Item = Triangle>,
    width: usize,
    height: usize,
) -> Grids {
    let mut grids = Grids { signed: vec![0; width * height], all: vec![0; width * height] };
    let window = Window { columns: 0..width as i32, rows: 0..height as i32 };
    for triangle in triangles {
        let Some(setup) = setup(triangle) else { continue };
        let sign = if reference::setup::area2(triangle) < 0 { 1 } else { -1 };
        let Ok(()) = T::walk::<std::convert::Infallible>(&setup, &window, |span| {
            for x in span.start..span.end {
                let pixel = span.y as usize * width + x as usize;
                grids.signed[pixel] += sign;
                grids.all[pixel] += 1;
            }
            Ok(())
        });
    }
    grids
}

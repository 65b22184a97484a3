//! Rows of whole pixels, both ends included: how small 3D libraries for displays fill a triangle (embedded-3dgfx,
//! embedded-gfx; `TinyGL` includes the last row and column too).

use crate::setup::Triangle;
use crate::transform::Viewport;
use std::ops::RangeInclusive;

/// Pixels of one row, the last one included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The row.
    pub y: i32,
    /// The first column.
    pub first: i32,
    /// The last column.
    pub last: i32,
}

/// The rows of a triangle whose vertices are cut down to whole pixels: from the top vertex to the bottom one, from edge
/// to edge. Neighbours share the pixels of their edge.
pub fn rows(triangle: Triangle) -> Vec<Row> {
    let mut corners = triangle.map(|corner| corner.map(|c| i64::from(c >> 8)));
    corners.sort_by_key(|&[_, y]| y);
    let [top, middle, bottom] = corners;
    let along = |from: [i64; 2], to: [i64; 2], y: i64| {
        let height = (to[1] - from[1]).max(1);
        from[0] + (to[0] - from[0]) * (y - from[1]) / height
    };
    let row = |y: i64| {
        let short = if y < middle[1] { along(top, middle, y) } else { along(middle, bottom, y) };
        let long = along(top, bottom, y);
        let mut ends = [short, long];
        if top[1] == bottom[1] {
            ends = [top[0].min(middle[0]).min(bottom[0]), top[0].max(middle[0]).max(bottom[0])];
        }
        Row { y: y as i32, first: ends[0].min(ends[1]) as i32, last: ends[0].max(ends[1]) as i32 }
    };
    (top[1]..=bottom[1]).map(row).collect()
}

/// How many triangles hit each pixel, in rows from the top.
pub fn counts(triangles: &[Triangle], viewport: Viewport) -> Vec<u32> {
    count(triangles, viewport, |first, last, width| (first.max(0), last.min(width - 1)))
}

/// The same where the ends of a row are held inside the target one by one (embedded-3dgfx): what lies left or right of
/// the target is drawn on its first or last column.
pub fn counts_held_at_the_border(triangles: &[Triangle], viewport: Viewport) -> Vec<u32> {
    count(triangles, viewport, |first, last, width| (first.clamp(0, width - 1), last.clamp(0, width - 1)))
}

fn count(triangles: &[Triangle], viewport: Viewport, ends: impl Fn(i32, i32, i32) -> (i32, i32)) -> Vec<u32> {
    let (width, height) = (viewport.width.cast_signed(), viewport.height.cast_signed());
    let mut counts = vec![0; (viewport.width * viewport.height) as usize];
    for Row { y, first, last } in triangles.iter().flat_map(|&triangle| rows(triangle)) {
        if (0..height).contains(&y) {
            let (first, last) = ends(first, last, width);
            for x in first..=last {
                counts[(y * width + x) as usize] += 1;
            }
        }
    }
    counts
}

/// The columns and rows of a triangle's box inside the target, the last ones included: `min(right, width - 1)` in
/// unsigned numbers, which has no last column for a target without any.
pub fn box_inside(triangle: Triangle, viewport: Viewport) -> [RangeInclusive<u32>; 2] {
    [(0, viewport.width), (1, viewport.height)].map(|(axis, size)| {
        let ends = triangle.map(|corner| (corner[axis] >> 8).max(0).unsigned_abs());
        let (low, high) = (ends[0].min(ends[1]).min(ends[2]), ends[0].max(ends[1]).max(ends[2]));
        // In C this is what `width - 1` is; in Rust it stops a debug build.
        low..=high.min(size.wrapping_sub(1))
    })
}

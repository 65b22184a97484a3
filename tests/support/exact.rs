//! Spans of single triangles, and hits of meshes, against the crossings of edges in 128-bit integers.

use reference::raster::row_span;
use reference::setup::{Triangle, area2};
use topleft::stages::{Span, Traversal, Window};
use topleft::{BoxWalk, Camera, Mesh, Pose, Spans};

use super::counter::{ALL, WINDING, draw_by};
use super::polygons::{Polygons, polygons};
use super::same;
use super::winding::{setup, winding_of};

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

/// A mesh's polygons and the exact hits of each pixel, where both traversals agree with them.
pub(crate) fn compare_mesh(
    camera: &impl Camera,
    mesh: &Mesh<'_>,
    pose: &Pose,
) -> Result<(Polygons, Vec<i32>), String> {
    let size = camera.viewport().map_err(|error| error.to_string())?.size();
    let [width, height] = [size.width, size.height].map(|length| length as usize);
    let polygons = polygons(camera, mesh, pose);
    let expected = [exact_hits(&polygons, width, height), winding_of(&polygons.edges(), width, height)];
    agree::<Spans>(camera, mesh, pose, &expected)?;
    agree::<BoxWalk>(camera, mesh, pose, &expected)?;
    let [hits, _] = expected;
    Ok((polygons, hits))
}

/// A traversal hits each pixel as often as is exact, and the fronts less the backs are its winding number.
fn agree<T: Traversal>(
    camera: &impl Camera,
    mesh: &Mesh<'_>,
    pose: &Pose,
    [hits, winding]: &[Vec<i32>; 2],
) -> Result<(), String> {
    let by = std::any::type_name::<T>();
    let width = camera.viewport().map_or(1, |viewport| viewport.size().width as usize);
    same(&format!("hits by {by}"), width, &draw_by::<T>(camera, mesh, pose, ALL).hits, hits)?;
    same(&format!("winding by {by}"), width, &draw_by::<T>(camera, mesh, pose, WINDING).hits, winding)
}

/// How many of the triangles cover each pixel of a frame, row by row, in 128-bit integers.
fn exact_hits(polygons: &Polygons, width: usize, height: usize) -> Vec<i32> {
    let mut hits = vec![0; width * height];
    for triangle in polygons.triangles().filter(|&triangle| area2(triangle) != 0) {
        let rows = triangle.map(|[_, y]| y.div_euclid(256));
        let [first, last] = [rows.iter().min(), rows.iter().max()].map(|row| row.copied().unwrap_or(0));
        for y in first.max(0)..(last + 1).min(height as i32) {
            let Some((start, end)) = row_span(triangle, y.into()) else { continue };
            let [start, end] = [start, end].map(|x| x.clamp(0, width as i64) as usize);
            let row = y as usize * width;
            for hit in &mut hits[row + start..row + end] {
                *hit += 1;
            }
        }
    }
    hits
}

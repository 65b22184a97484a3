//! Single triangles on a target, against 128-bit integers.

use embedded_graphics_core::Drawable;
use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use reference::raster::covers;
use reference::setup::Triangle;
use topleft::{Attribute, Coord, Point, ShadedTriangle, Texture, Wrap};

use crate::counting::Counting;
use crate::edges::to_edges;
use crate::support::tolerance::FLAT_CLIPPED;

/// Draws a triangle all ways, which hit the same pixels: the target holds how often.
pub(crate) fn draw_all_ways(
    points: [Point; 3],
    texels: [[i32; 2]; 3],
    texture: &Texture<'_>,
    target: &mut Counting,
) {
    let colours = [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE];
    let texels = texels.map(|texel| texel.map(Attribute::from_bits));
    let clamped = texture.with_wrap(Wrap::Clamp);
    let mut hits = Vec::new();
    for triangle in [
        ShadedTriangle::flat(points, Rgb565::RED),
        ShadedTriangle::new(points, colours),
        ShadedTriangle::textured(points, texels, texture),
        ShadedTriangle::textured(points, texels, &clamped),
    ] {
        target.hits.fill(0);
        let Ok(()) = triangle.draw(target);
        assert!(hits.is_empty() || hits == target.hits, "all ways hit the same pixels");
        hits.clone_from(&target.hits);
    }
}

/// Draws a triangle in 1/256 px all ways. What it hits is exact as far as it is not clipped at the guard rectangle.
pub(crate) fn compare(
    points: Triangle,
    texels: [[i32; 2]; 3],
    texture: &Texture<'_>,
    target: &mut Counting,
) -> Result<(), String> {
    let corners = points.map(|[x, y]| Point::new(Coord::from_bits(x), Coord::from_bits(y)));
    draw_all_ways(corners, texels, texture, target);
    let margin = 1024 * 256;
    let Size { width, height } = target.area.size;
    let whole = points.iter().all(|&[x, y]| {
        (-margin..=width as i32 * 256 + margin).contains(&x)
            && (-margin..=height as i32 * 256 + margin).contains(&y)
    });
    for (index, &hits) in target.hits.iter().enumerate() {
        let (x, y) = ((index as u32 % width) as i64, (index as u32 / width) as i64);
        if hits == u32::from(covers(points, x, y)) {
            continue;
        }
        // Clipped at the guard rectangle, an edge is rounded there.
        let far = to_edges(points, x, y);
        if whole || hits > 1 || far > FLAT_CLIPPED {
            return Err(format!("{hits} hits at {x}, {y} of {:?}, {far} steps from an edge", target.area));
        }
    }
    Ok(())
}

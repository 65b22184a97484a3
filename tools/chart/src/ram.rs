//! Bytes of RAM that each way to draw takes: what a list and a strip ask for where they are given nothing.

use embedded_graphics_core::geometry::Size;
use topleft::stages::Shader;
use topleft::{
    Affine, Depth, Depth16, DrawError, DrawList, Flat, Gouraud, Length, ListTriangle, Material, Mesh,
    NoDepth, Orthographic, PerPixel, Pose, Strip, StripError, Subspans, Sun, Texture, Textured,
};

use crate::table::Table;

/// Columns and rows of the strip.
const STRIP: [u16; 2] = [240, 16];
/// Vertices of the list.
const VERTICES: usize = 1000;

/// By way to draw: what a vertex and a triangle of a list take, and a pixel of a strip, whose colours are RGB565; then a
/// strip of 240x16 with a list of 1000 vertices, without its triangles, which take the same in all ways.
pub(crate) fn table() -> Table {
    let mut table = Table::new(&["shading", "vertex_bytes", "triangle_bytes", "pixel_bytes", "ram_bytes"]);
    let mut row = |shading: &str, vertex: usize, pixel: usize| {
        let all = VERTICES * vertex + usize::from(STRIP[0]) * usize::from(STRIP[1]) * pixel;
        let bytes = [vertex, size_of::<ListTriangle>(), pixel, all].map(|bytes| bytes.to_string());
        table.rows.push(std::iter::once(shading.to_owned()).chain(bytes).collect());
    };
    let colour = size_of::<u16>();
    let with_depth = colour + depth_bytes();
    let flat = Flat::new(Material::OfMesh);
    row("flat", vertex_bytes::<NoDepth>(&flat), colour);
    row("flat+depth", vertex_bytes::<Depth16>(&flat), with_depth);
    row("gouraud+depth", vertex_bytes::<Depth16>(&Gouraud::unlit(&Material::OfMesh)), with_depth);
    let affine = Textured::new(&Texture::WHITE, Affine);
    row("affine+depth", vertex_bytes::<Depth16>(&affine), with_depth);
    let lit = affine.lit_by(&Sun::new([Length::ONE; 3]));
    row("lit-affine+depth", vertex_bytes::<Depth16>(&lit), with_depth);
    let subspans = Textured::new(&Texture::WHITE, Subspans::Of16);
    row("perspective-subspan-16+depth", vertex_bytes::<Depth16>(&subspans), with_depth);
    let per_pixel = Textured::new(&Texture::WHITE, PerPixel);
    row("perspective-pixel+depth", vertex_bytes::<Depth16>(&per_pixel), with_depth);
    table
}

/// Of each of the vertices that a list has no words for.
fn vertex_bytes<D: Depth>(shader: &impl Shader<'static, u16>) -> usize {
    let camera = Orthographic::new(Size::new(8, 8), 4.0, -2.0..2.0);
    let mesh = Mesh::new(&[[0; 3]; VERTICES], &[[0, 1, 2]]).expect("a face of its vertices");
    let mut list: DrawList<'_, u16, D> = DrawList::new(&mut [], &mut []);
    match list.draw(&camera, &mesh, &Pose::new(), shader) {
        Err(DrawError::Full { words, .. }) => words * size_of::<u32>() / VERTICES,
        other => panic!("a list without a word took {VERTICES} vertices: {other:?}"),
    }
}

/// Of each of the pixels that a strip has no depths for.
fn depth_bytes() -> usize {
    let mut colours = vec![0_u16; usize::from(STRIP[0]) * usize::from(STRIP[1])];
    let (pixels, none) = (colours.len(), &mut [0_u16; 0]);
    let strip = Strip::new(STRIP[0], &mut colours).expect("whole rows");
    match strip.with_depth(none) {
        Err(StripError::Short { needed, .. }) => needed * size_of::<u16>() / pixels,
        Ok(strip) => panic!("a strip without a depth took {} rows", strip.height()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a word of a vertex is left out, as 1/w; when words count as bytes, or vertices of other colours or depths;
    // when a strip's depths are left out.
    #[test]
    fn bytes_are_those_that_the_lists_documentation_tells() {
        let rows = table().rows;
        let of = |shading: &str| rows.iter().find(|row| row[0] == shading).unwrap()[1..].join(" ");
        // x and y, and a word for each of: depth, colour or 1/w or light, u and v.
        assert_eq!(of("flat"), format!("8 14 2 {}", 240 * 16 * 2 + 8000));
        assert_eq!(of("flat+depth"), format!("12 14 4 {}", 240 * 16 * 4 + 12_000));
        assert_eq!(of("gouraud+depth"), format!("16 14 4 {}", 240 * 16 * 4 + 16_000));
        assert_eq!(of("affine+depth"), format!("20 14 4 {}", 240 * 16 * 4 + 20_000));
        for with_a_sixth in ["lit-affine+depth", "perspective-subspan-16+depth", "perspective-pixel+depth"] {
            assert_eq!(of(with_a_sixth), format!("24 14 4 {}", 240 * 16 * 4 + 24_000));
        }
    }
}

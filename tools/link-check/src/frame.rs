//! Meshes, by way of a list and strips.

use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use scenes::mesh::CUBE;
use scenes::texture::BRICK;
use topleft::stages::{Shader, Traversal};
use topleft::{
    Affine, Aligned, BySize, Camera, ColourError, Cull, Depth, Depth16, DepthFloat, Divided, DrawError,
    DrawList, Flat, Gouraud, Hiding, Length, ListStorage, ListTriangle, Material, Matrix, MatrixCamera, Mesh,
    NoDepth, Painter, PerPixel, Pixel, Portable, Pose, Strip, Subspans, Sun, Texture, Textured, Turn, Within,
    Wrap,
};

use crate::screen::{SIZE, Screen};

const WIDTH: usize = SIZE.width as usize;
const ROWS: usize = 8;

/// From floats, but in a `const`: a perspective of 53 degrees, 4 units away, from 1 to 9.
const FAR_AWAY: Matrix = Matrix::from_floats([
    [2.0, 0.0, 0.0, 0.0],
    [0.0, 2.0, 0.0, 0.0],
    [0.0, 0.0, -1.125, 3.375],
    [0.0, 0.0, -1.0, 4.0],
]);

/// So near that the near plane cuts the cube.
const NEAR: Matrix = {
    const O: Length = Length::ZERO;
    const I: Length = Length::ONE;
    Matrix::new([
        [I, O, O, O],
        [O, I, O, O],
        [O, O, Length::lit("-1.125"), Length::lit("0.5")],
        [O, O, Length::NEG_ONE, Length::lit("1.5")],
    ])
};

/// A blob: one triangle with colours at its vertices.
static BLOB: Aligned<[u8; 75]> = Aligned(
    *b"TLMH\x01\0\x08\0\x03\0\0\0\x01\0\0\0\0\0\0\0\
       \0\0\0\0\0\0\0\0\0\0\0\0\0\0\x01\0\
       \x01\x80\x01\x80\0\0\xFF\x7F\x01\x80\0\0\0\0\xFF\x7F\0\0\0\0\
       \0\0\x01\0\x02\0\0\0\
       \xFF\0\0\0\xFF\0\0\0\xFF\0\0",
);

/// A texture's blob: two texels.
static TEXELS: Aligned<[u8; 16]> = Aligned(*b"TLTX\x01\0\x01\0\x02\0\x01\0\xFF\xFF\x1F\0");

/// Rgb565 with depth, every kind of shader.
pub(crate) fn with_depth(screen: &mut Screen) -> Result<(), Infallible> {
    let mut storage: ListStorage<2400, 200> = ListStorage::new();
    let (mut colours, mut depths) = ([Rgb565::BLACK; WIDTH * ROWS], [0; WIDTH * ROWS]);
    let mut list: DrawList<'_, Rgb565, Depth16> = storage.list();
    black_box(every_shader(&mut list)).ok();
    if let Ok(strip) = Strip::new(SIZE.width as u16, &mut colours)
        && let Ok(strip) = strip.with_depth(&mut depths)
    {
        let mut strip = strip.with_background(black_box(Rgb565::BLUE));
        list.present(&mut strip, screen)?;
    }
    black_box(list.stats());
    list.clear();
    Ok(())
}

/// Rgb565 without depth, every kind of shader.
pub(crate) fn without_depth(screen: &mut Screen) -> Result<(), Infallible> {
    let mut storage: ListStorage<2400, 200> = ListStorage::new();
    let mut colours = [Rgb565::BLACK; WIDTH * ROWS];
    let mut list: DrawList<'_, Rgb565, NoDepth> = storage.list();
    black_box(every_shader(&mut list)).ok();
    if let Ok(mut strip) = Strip::new(SIZE.width as u16, &mut colours) {
        list.present(&mut strip, screen)?;
    }
    Ok(())
}

/// Rgb565 with depth as small floats, every kind of shader.
pub(crate) fn with_depth_float(screen: &mut Screen) -> Result<(), Infallible> {
    let mut storage: ListStorage<2400, 200> = ListStorage::new();
    let (mut colours, mut depths) = ([Rgb565::BLACK; WIDTH * ROWS], [0; WIDTH * ROWS]);
    let mut list: DrawList<'_, Rgb565, DepthFloat> = storage.list();
    black_box(every_shader(&mut list)).ok();
    if let Ok(strip) = Strip::new(SIZE.width as u16, &mut colours)
        && let Ok(mut strip) = strip.with_depth_float(&mut depths)
    {
        list.present(&mut strip, screen)?;
    }
    Ok(())
}

/// Rgb565 in painter's order, every kind of shader, by a scratch that may be too short.
pub(crate) fn in_painters_order(screen: &mut Screen) -> Result<(), Infallible> {
    let mut storage: ListStorage<2400, 200> = ListStorage::new();
    let mut scratch = [[0; 3]; 200];
    let mut colours = [Rgb565::BLACK; WIDTH * ROWS];
    let mut list: DrawList<'_, Rgb565, Painter> = storage.list();
    black_box(every_shader(&mut list)).ok();
    black_box(list.sort(scratch.get_mut(..black_box(200)).unwrap_or_default())).ok();
    if let Ok(strip) = Strip::new(SIZE.width as u16, &mut colours) {
        list.present(&mut strip.for_painter(), screen)?;
    }
    Ok(())
}

/// Which way hides what is hidden.
pub(crate) fn cheapest() {
    let (mesh, poses) = (black_box(&CUBE), black_box([Pose::new(); 2]));
    let things = poses.each_ref().map(|pose| (mesh, pose));
    let camera = MatrixCamera::<true>::new(black_box(SIZE), black_box(FAR_AWAY));
    black_box(Hiding::cheapest(&camera, black_box(&things), black_box(Length::ONE)));
    let camera = MatrixCamera::<false>::new(black_box(SIZE), black_box(Matrix::IDENTITY));
    black_box(Hiding::cheapest(&camera, black_box(&things), black_box(Length::ONE)));
}

/// Bare 16-bit cells, pixels found by walking boxes or spans, rows rendered one strip at a time.
pub(crate) fn by_boxes(screen: &mut Screen) -> Result<(), Infallible> {
    let (mut words, mut triangles) = ([0; 600], [ListTriangle::EMPTY; 60]);
    let (mut colours, mut depths) = ([0_u16; WIDTH * ROWS], [0; WIDTH * ROWS]);
    let mut list = DrawList::<u16, Depth16, BySize>::with_traversal(&mut words, &mut triangles);
    black_box(every_shader(&mut list)).ok();
    if let Ok(strip) = Strip::new(SIZE.width as u16, &mut colours)
        && let Ok(mut strip) = strip.with_depth(&mut depths)
    {
        strip.clear();
        list.render(black_box(16..24), &mut strip);
        black_box(strip.colours());
    }
    black_box(screen);
    Ok(())
}

/// The cube by every shader through both kinds of camera, and the blob.
fn every_shader<'a, P: Pixel, D: Depth, T: Traversal>(
    list: &mut DrawList<'a, P, D, T>,
) -> Result<(), DrawError> {
    let sun = Sun::new(black_box([Length::ONE; 3])).with_ambient(black_box(20));
    let brass = Material::from(black_box(Rgb565::YELLOW));
    let texture: Texture<'a> = black_box(BRICK).with_wrap(black_box(Wrap::Clamp));
    let mesh = black_box(&CUBE);
    draw(list, mesh, &Flat::new(brass))?;
    draw(list, mesh, &Flat::new(black_box(Material::OfMesh)).lit_by(&sun))?;
    draw(list, mesh, &Gouraud::new(&sun, &brass))?;
    draw(list, mesh, &Gouraud::new(&sun, &brass).within(black_box(ColourError::default())))?;
    draw(list, mesh, &Textured::new(&texture, Affine))?;
    draw(list, mesh, &Textured::new(&texture, PerPixel))?;
    draw(list, mesh, &Textured::new(&texture, black_box(Subspans::Of16)))?;
    draw(list, mesh, &Textured::new(&texture, black_box(Within::default())))?;
    draw(list, mesh, &Textured::new(&texture, Divided::<Portable>::new()))?;
    draw(list, mesh, &Textured::new(&texture, Affine).lit_by(&sun))?;
    draw(list, mesh, &Textured::new(&texture, PerPixel).lit_by(&sun))?;
    draw(list, mesh, &Textured::new(&texture, black_box(Within::default())).lit_by(&sun))?;
    if let Ok(mesh) = Mesh::from_bytes(black_box(&BLOB.0)) {
        draw(list, &mesh, &Gouraud::unlit(&Material::OfMesh))?;
    }
    if let Ok(texture) = Texture::from_bytes(black_box(&TEXELS.0)) {
        draw(list, mesh, &Textured::new(&texture, PerPixel))?;
    }
    Ok(())
}

/// A mesh, turned, scaled and moved, seen with perspective and without.
fn draw<'a, P: Pixel, D: Depth, T: Traversal, S: Shader<'a, P>>(
    list: &mut DrawList<'a, P, D, T>,
    mesh: &Mesh<'_>,
    shader: &S,
) -> Result<(), DrawError> {
    let [x, y, z] = black_box([Turn::from_degrees(20), Turn::new(1000), Turn::ZERO]);
    let pose = Pose::new()
        .turned_x(x)
        .turned_y(y)
        .turned_z(z)
        .scaled(black_box(Length::ONE))
        .at(black_box([Length::ZERO; 3]));
    let with_perspective = |matrix| MatrixCamera::<true>::new(black_box(SIZE), black_box(matrix));
    list.set_cull(black_box(Cull::Back));
    draw_by(list, &with_perspective(FAR_AWAY), mesh, &pose, shader)?;
    draw_by(list, &with_perspective(NEAR.times(&black_box(Matrix::IDENTITY))), mesh, &pose, shader)?;
    let level = MatrixCamera::<false>::new(black_box(SIZE), black_box(Matrix::IDENTITY));
    draw_by(list, &level, mesh, &pose, shader)
}

fn draw_by<'a, C: Camera, P: Pixel, D: Depth, T: Traversal, S: Shader<'a, P>>(
    list: &mut DrawList<'a, P, D, T>,
    camera: &C,
    mesh: &Mesh<'_>,
    pose: &Pose,
    shader: &S,
) -> Result<(), DrawError> {
    match list.draw(camera, mesh, pose, shader) {
        Err(DrawError::Full { triangles, .. }) => {
            black_box(triangles);
            Ok(())
        }
        other => other,
    }
}

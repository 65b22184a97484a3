//! What the images share: a mesh, two cameras, and the memory that is drawn with.
//!
//! Each image of `src/bin` draws a cube in one way. `nothing` has the same start, mesh and memory, and draws nothing: what
//! another has more is the code of the way to draw, and of whatever else only that code calls.
#![no_std]

use core::hint::black_box;

use embedded_graphics_core::geometry::Size;
use topleft::stages::{Shader, Traversal};
use topleft::{
    Affine, Camera, Depth, DrawError, DrawList, Flat, Gouraud, Length, ListTriangle, Material, Matrix,
    MatrixCamera, Mesh, PerPixel, Perspective, Pose, Strip, Sun, Texture, Textured, Turn,
};

/// Pixels of the panel.
pub const PANEL: Size = Size::new(240, 240);
/// Pixels of a strip of 16 rows.
pub const CELLS: usize = 240 * 16;

const fn matrix(rows: [[i32; 4]; 4]) -> Matrix {
    let mut elements = [[Length::ZERO; 4]; 4];
    let mut i = 0;
    while i < 16 {
        elements[i / 4][i % 4] = Length::from_bits(rows[i / 4][i % 4]);
        i += 1;
    }
    Matrix::new(elements)
}

/// Without perspective: the cube fills half of the panel.
pub const FRONT: MatrixCamera<false> =
    MatrixCamera::new(PANEL, matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 1], [0, 0, 0, 2]]));
/// With perspective: 90 degrees, the cube in the middle of what is seen.
pub const EYE: MatrixCamera<true> =
    MatrixCamera::new(PANEL, matrix([[3, 0, 0, 0], [0, 3, 0, 0], [0, 0, -4, 8], [0, 0, -3, 9]]));

/// A list's storage and a strip's colours and depths. All images link it, whatever they use of it.
#[derive(Debug)]
pub struct Memory {
    /// Of the list's vertices.
    pub words: [u32; 400],
    /// Of the list.
    pub triangles: [ListTriangle; 48],
    /// Of the strip.
    pub colours: [u16; CELLS],
    /// Of the strip.
    pub depths: [u16; CELLS],
}

impl Memory {
    /// Memory that nothing is drawn in.
    pub const fn new() -> Self {
        Self {
            words: [0; 400],
            triangles: [ListTriangle::EMPTY; 48],
            colours: [0; CELLS],
            depths: [0; CELLS],
        }
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new()
    }
}

/// The cube, of which the compiler knows nothing.
pub fn mesh() -> &'static Mesh<'static> {
    black_box(&scenes::mesh::CUBE)
}

/// A texture of four texels, so that it is the code which is measured. The compiler knows nothing of it either.
pub fn texture() -> Option<Texture<'static>> {
    static TEXELS: [u16; 4] = [0xF800, 0x07E0, 0x001F, 0xFFFF];
    Texture::new(2, 2, black_box(&TEXELS)).ok()
}

/// Draws the cube into a list and each strip of it.
pub fn draw<'a, D: Depth, T: Traversal, C: Camera, S: Shader<'a, u16>>(
    list: &mut DrawList<'a, u16, D, T>,
    strip: &mut Strip<'_, u16, D>,
    camera: &C,
    shader: &S,
) {
    if add(list, camera, shader).is_ok() {
        render(list, strip);
    }
}

/// Draws the cube into a list.
///
/// # Errors
/// Those of the list.
pub fn add<'a, D: Depth, T: Traversal, C: Camera, S: Shader<'a, u16>>(
    list: &mut DrawList<'a, u16, D, T>,
    camera: &C,
    shader: &S,
) -> Result<(), DrawError> {
    list.draw(black_box(camera), mesh(), &pose(), shader)
}

/// The cube, turned. All images that draw a mesh link it once.
#[inline(never)]
fn pose() -> Pose {
    Pose::new().turned_y(black_box(Turn::from_degrees(30)))
}

/// Draws each strip of a list.
pub fn render<D: Depth, T: Traversal>(list: &mut DrawList<'_, u16, D, T>, strip: &mut Strip<'_, u16, D>) {
    for top in (0..PANEL.height as i32).step_by(usize::from(strip.height())) {
        strip.clear();
        list.render_next(top..top + i32::from(strip.height()), strip);
        black_box(strip.colours());
    }
}

/// A scene as people ship it: flat and Gouraud under a sun, and an affine texture, with depth, before a camera in perspective
/// that is given in floats; in one list.
pub fn demo<T: Traversal>(memory: &mut Memory) {
    let Ok(strip) = Strip::new(240, &mut memory.colours) else { return };
    let Ok(mut strip) = strip.with_depth(&mut memory.depths) else { return };
    let Some(texture) = texture() else { return };
    let camera = Perspective::new(PANEL, Turn::from_degrees(45), 1.0..9.0)
        .look_at(black_box([1.0, 2.0, 4.0]), [0.0; 3]);
    let sun = Sun::new(black_box([Length::ONE; 3]));
    let list = &mut DrawList::<_, _, T>::with_traversal(&mut memory.words, &mut memory.triangles);
    let added = add(list, &camera, &Flat::new(Material::OfMesh).lit_by(&sun)).is_ok()
        && add(list, &camera, &Gouraud::new(&sun, &Material::OfMesh)).is_ok()
        && add(list, &camera, &Textured::new(&texture, Affine)).is_ok();
    if added {
        render(list, &mut strip);
    }
}

/// An image: what a chip needs to start it, and its one way to draw.
#[macro_export]
macro_rules! image {
    ($draw:expr) => {
        #[cfg(target_os = "none")]
        mod image {
            use super::*;
            use cortex_m as _;
            use panic_halt as _;

            /// The boot ROM of an RP2040 copies it to RAM, and it sets up the flash; elsewhere it is left out.
            #[cfg(armv6m)]
            #[expect(unsafe_code, reason = "the boot ROM wants it in the first 256 bytes of flash")]
            #[unsafe(link_section = ".boot2")]
            #[used]
            static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

            #[cortex_m_rt::entry]
            fn main() -> ! {
                static mut MEMORY: footprint::Memory = footprint::Memory::new();
                let draw: fn(&'static mut footprint::Memory) = $draw;
                draw(MEMORY);
                loop {
                    cortex_m::asm::wfi();
                }
            }
        }

        #[cfg(not(target_os = "none"))]
        fn main() {
            let _: fn(&'static mut footprint::Memory) = $draw;
            eprintln!("this is an image for a chip: firmware/measure.sh builds it");
            std::process::exit(2);
        }
    };
}

/// One after the other: flat and an affine texture without depth; flat, Gouraud, and a texture with a reciprocal a pixel with
/// depth.
pub fn methods<T: Traversal>(memory: &mut Memory) {
    let Memory { words, triangles, colours, depths } = memory;
    let Some(texture) = texture() else { return };
    let flat = Flat::new(Material::OfMesh);
    let Ok(mut strip) = Strip::new(240, colours) else { return };
    let mut list = DrawList::<_, _, T>::with_traversal(words, triangles);
    draw(&mut list, &mut strip, &FRONT, &flat);
    draw(&mut list, &mut strip, &FRONT, &Textured::new(&texture, Affine));
    drop(list);
    let Ok(mut strip) = strip.with_depth(depths) else { return };
    let mut list = DrawList::<_, _, T>::with_traversal(words, triangles);
    draw(&mut list, &mut strip, &FRONT, &flat);
    draw(&mut list, &mut strip, &FRONT, &Gouraud::unlit(&Material::OfMesh));
    draw(&mut list, &mut strip, &EYE, &Textured::new(&texture, PerPixel));
}

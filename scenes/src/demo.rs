//! The scene for a first look: an island on a turning board, a thousand triangles, meant for 30 frames a second of a Cortex-M0+.
//!
//! What it costs is decided here and in the meshes: the size of the board on the screen, the ways of shading, and the
//! counts in `tools/meshpack/src/make/island/`.

use topleft::{Cull, Length, Material, Mesh, Turn};

use crate::mesh::{ISLAND_BOATS, ISLAND_LAND, ISLAND_LIGHTHOUSE, ISLAND_PROPS, ISLAND_SEA};
use crate::scene::{Camera, Object, Scene, Spin};
use crate::shade::{Look, Method, Shade};
use crate::texture::WAVES;

/// From the middle of the board: the nearer, the more pixels.
const DISTANCE: &str = "4.82";
/// Degrees above the sea: the higher, the more of the triangles face the viewer, and the more pixels are sea and not sky.
const PITCH: i32 = 30;
/// Degrees from top to bottom. From far away through a narrow angle, a board of as many pixels is wider and less high: it lies
/// in fewer strips.
const FIELD_OF_VIEW: i32 = 25;

/// The nearest first, roughly: what is hidden later costs a depth and no colour.
pub(crate) const DEMO: Scene = Scene {
    name: "demo",
    about: "an island with a lighthouse, and boats that sail round it",
    camera: Camera::Orbit {
        target: [Length::ZERO, Length::lit("0.1"), Length::ZERO],
        distance: Length::lit(DISTANCE),
        pitch: Turn::from_degrees(PITCH),
        field_of_view: FIELD_OF_VIEW,
        depth: (3.3, 5.9),
    },
    background: [28, 34, 66],
    objects: &[
        part(&ISLAND_LIGHTHOUSE, Shade::Gouraud, Spin::Upright),
        part(&ISLAND_PROPS, Shade::Flat, Spin::Upright),
        part(&ISLAND_LAND, Shade::Flat, Spin::Upright),
        part(&ISLAND_BOATS, Shade::Flat, Spin::Twice),
        part(&ISLAND_SEA, Shade::Textured, Spin::Upright),
    ],
};

/// In the mesh's own colours, or under waves: the sea's triangles are small enough for them without perspective.
const fn part(mesh: &'static Mesh<'static>, shade: Shade, spin: Spin) -> Object {
    let look = Look { material: Material::OfMesh, texture: WAVES, shade, method: Method::Affine };
    Object {
        mesh,
        at: [Length::ZERO; 3],
        scale: Length::ONE,
        spin,
        lean: [Turn::ZERO; 3],
        look,
        cull: Cull::Back,
    }
}

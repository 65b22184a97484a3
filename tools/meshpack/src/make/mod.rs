//! The repository's own meshes and textures, made from formulas and from published numbers.

mod corridor;
mod cube;
mod dial;
mod floor;
mod globe;
mod grid;
mod icosphere;
mod island;
mod ladder;
mod star;
mod surface;
mod teapot;
mod texture;
mod torus_knot;

use crate::quantise::Packed;
use crate::read_image::PackedTexture;
use std::path::PathBuf;

/// A mesh or a texture of the repository, and its place in the `scenes` package.
#[derive(Clone, Debug)]
pub struct Made<T> {
    /// The module's name, and the file's without `.rs`.
    pub module: &'static str,
    /// The constant's name.
    pub name: &'static str,
    /// What it is, in one line.
    pub doc: &'static str,
    /// The thing itself.
    pub packed: T,
}

/// The meshes of the repository.
pub fn made_meshes() -> Vec<Made<Packed>> {
    let mesh = |module, name, doc, packed| Made { module, name, doc, packed };
    vec![
        mesh(
            "corridor",
            "CORRIDOR",
            "Four walls 2 units apart along the z axis from 0.5 to -11.5, seen from inside, and the one at the end.",
            corridor::make(),
        ),
        mesh(
            "cube",
            "CUBE",
            "A cube from -1 to 1: a colour and a texture's whole image on each side.",
            cube::make(),
        ),
        mesh(
            "dial",
            "DIAL",
            "A gauge of 224 pixels: a disc, ticks and a needle, a quarter of a unit above each other.",
            dial::make(),
        ),
        mesh(
            "floor",
            "FLOOR",
            "A level square from -2 to 2 at y = 0, 8 x 8 tiles, four repeats of a texture each way.",
            floor::make(),
        ),
        mesh(
            "globe",
            "GLOBE",
            "A sphere of radius 1 in 25 rings of 24 slices, four repeats of a texture round it.",
            globe::make(),
        ),
        mesh(
            "grid240",
            "GRID240",
            "512 jittered triangles that cover 240x240 pixels once: 1 unit is 1 pixel, the screen's centre is the \
             origin, y up.",
            grid::make(),
        ),
        mesh(
            "grid240_tilted",
            "GRID240_TILTED",
            "The triangles of `GRID240` on a plane that recedes, for a camera at the origin that sees 90 degrees: w is 1 \
             at the bottom of the screen and 4 at the top.",
            grid::tilted(),
        ),
        mesh(
            "ground",
            "GROUND",
            "A level square from -1 to 1 of two faces, eight repeats of a texture each way.",
            corridor::ground(),
        ),
        mesh(
            "icosphere",
            "ICOSPHERE",
            "A sphere of radius 1, an icosahedron split twice.",
            icosphere::make(2),
        ),
        mesh(
            "icosphere_fine",
            "ICOSPHERE_FINE",
            "A sphere of radius 1, an icosahedron split three times.",
            icosphere::make(3),
        ),
        mesh(
            "island_boats",
            "ISLAND_BOATS",
            "Boats on their way round the island: a colour a face.",
            island::boats(),
        ),
        mesh(
            "island_land",
            "ISLAND_LAND",
            "An island on a board of radius 1, in the colours of its height; the sea is at y = 0.",
            island::land(),
        ),
        mesh("island_lighthouse", "ISLAND_LIGHTHOUSE", "The island's lighthouse.", island::lighthouse()),
        mesh(
            "island_props",
            "ISLAND_PROPS",
            "What stands on the island, and the edge of its board: a colour a face.",
            island::props(),
        ),
        mesh(
            "island_sea",
            "ISLAND_SEA",
            "The sea from the island's coast to the edge of the board.",
            island::sea(),
        ),
        mesh(
            "ladder",
            "LADDER",
            "Six pairs of parallel faces one unit before an eye at the origin, from 5 % to 0.1 % of it apart.",
            ladder::make(),
        ),
        mesh(
            "star",
            "STAR",
            "360 needles round a hub in the plane z = 0, half a degree wide at a quarter of their length.",
            star::make(),
        ),
        mesh(
            "teapot",
            "TEAPOT",
            "Newell's teapot at a third of his unit: its axis is the y axis, the spout points to +x, y from -0.525 \
             to 0.525.",
            teapot::make(),
        ),
        mesh(
            "torus_knot",
            "TORUS_KNOT",
            "The (2, 3) torus knot as a tube within -1 to 1, its colours going once round the rainbow.",
            torus_knot::make(),
        ),
    ]
}

/// The textures of the repository.
pub fn made_textures() -> Vec<Made<PackedTexture>> {
    let texture = |module, name, doc, packed| Made { module, name, doc, packed };
    vec![
        texture("brick", "BRICK", "Bricks in a running bond, eight courses high.", texture::brick()),
        texture("checker", "CHECKER", "A board of 8 x 8 squares in two colours.", texture::checker()),
        texture(
            "test_card",
            "TEST_CARD",
            "A card that shows mirroring and turning: a grid, an F, and another colour in each corner.",
            texture::test_card(),
        ),
        texture("waves", "WAVES", "Water with crests that repeat in both directions.", texture::waves()),
    ]
}

/// All generated Rust files of the `scenes` package, by their paths in its `src`.
pub fn generated() -> Vec<(PathBuf, String)> {
    let (meshes, textures) = (made_meshes(), made_textures());
    let mesh_names: Vec<_> = meshes.iter().map(|made| (made.module, made.name)).collect();
    let texture_names: Vec<_> = textures.iter().map(|made| (made.module, made.name)).collect();
    let mesh_files = meshes.iter().map(|made| {
        (PathBuf::from(format!("mesh/{}.rs", made.module)), made.packed.to_rust(made.name, made.doc))
    });
    let texture_files = textures.iter().map(|made| {
        (PathBuf::from(format!("texture/{}.rs", made.module)), made.packed.to_rust(made.name, made.doc))
    });
    mesh_files
        .chain(texture_files)
        .chain([
            ("mesh/mod.rs".into(), list("The meshes of the scenes, made by `meshpack make`.", &mesh_names)),
            (
                "texture/mod.rs".into(),
                list("The textures of the scenes, made by `meshpack make`.", &texture_names),
            ),
        ])
        .collect()
}

/// A module that lists others.
fn list(doc: &str, names: &[(&str, &str)]) -> String {
    let modules: String = names.iter().map(|(module, _)| format!("mod {module};\n")).collect();
    let exports: String = names.iter().map(|(module, name)| format!("pub use {module}::{name};\n")).collect();
    format!("//! {doc}\n\n{modules}\n{exports}")
}

//! Meshes and textures from files, as scenes. They live until the program ends.

use std::path::Path;

use scenes::mesh::FLOOR;
use scenes::texture::{BRICK, CHECKER};
use scenes::{Camera, Look, Method, Object, Scene, Shade, Spin};
use topleft::{Cull, Length, Material, Mesh, Texture, Turn};

/// An image as a texture.
pub(crate) fn texture(path: impl AsRef<Path>) -> Result<Texture<'static>, String> {
    let packed = meshpack::read_texture(path).map_err(|error| error.to_string())?;
    Ok(Box::leak(Box::new(packed)).texture())
}

/// The same scene, its turning objects with another texture.
pub(crate) fn with_texture(scene: Scene, texture: Option<Texture<'static>>) -> Scene {
    let Some(texture) = texture else { return scene };
    let takes = |object: &Object| object.spin != Spin::Still && !object.mesh.uvs().is_empty();
    if !scene.objects.iter().any(takes) {
        eprintln!("{}: nothing that turns has texture coordinates: drawn without the texture", scene.name);
    }
    let objects = scene.objects.iter().map(|object| {
        let look = Look { texture, shade: Shade::Lit, ..object.look };
        if takes(object) { Object { look, ..*object } } else { *object }
    });
    Scene { objects: Vec::leak(objects.collect()), ..scene }
}

/// A mesh file, standing on a floor and turning.
pub(crate) fn mesh(path: &Path, texture: Option<Texture<'static>>) -> Result<Scene, String> {
    let model = meshpack::read_mesh(path).map_err(|error| error.to_string())?;
    for warning in &model.warnings {
        eprintln!("{warning}");
    }
    let texture = match (texture, model.textures.first()) {
        (None, Some(named)) => {
            // A texture that the file names is a help, not a demand: without it the mesh is still shown.
            self::texture(named).inspect_err(|error| eprintln!("{error}: drawn without it")).ok()
        }
        (given, _) => given,
    };
    if texture.is_some() && model.uvs.is_empty() {
        eprintln!("{}: has no texture coordinates: drawn without the texture", path.display());
    }
    if model.textures.len() > 1 {
        eprintln!("{}: names {} textures: the first is drawn", path.display(), model.textures.len());
    }
    let packed = model.fit(1.0).quantise().map_err(|error| error.to_string())?;
    let mesh: &'static Mesh<'static> = Box::leak(Box::new(Box::leak(Box::new(packed)).mesh()));
    let material = if mesh.vertex_colours().is_empty() && mesh.face_colours().is_empty() {
        Material::Colour([0xD0, 0xC8, 0xB8])
    } else {
        Material::OfMesh
    };
    let shade = match texture {
        Some(_) if !mesh.uvs().is_empty() => Shade::Lit,
        _ if !mesh.face_colours().is_empty() => Shade::Flat,
        _ => Shade::Gouraud,
    };
    let look = Look { material, texture: texture.unwrap_or(BRICK), shade, method: Method::PerPixel };
    let floor = Look { texture: CHECKER, shade: Shade::Textured, ..look };
    let [[_, low, _], _] = mesh.bounds();
    let bottom = mesh.half().saturating_mul(Length::from_bits(i32::from(low) * 2));
    let place = |y| [Length::ZERO, y, Length::ZERO];
    let object = Object {
        mesh,
        at: place(Length::ZERO),
        scale: Length::ONE,
        spin: Spin::Upright,
        lean: [Turn::ZERO; 3],
        look,
        // Files are not always closed: both sides are shown.
        cull: Cull::None,
    };
    let floor = Object {
        mesh: &FLOOR,
        at: place(bottom),
        spin: Spin::Still,
        lean: [Turn::ZERO; 3],
        look: floor,
        cull: Cull::Back,
        ..object
    };
    let name = path.file_stem().map_or_else(|| "mesh".into(), |stem| stem.to_string_lossy().into_owned());
    Ok(Scene {
        name: String::leak(name),
        about: "a mesh from a file",
        camera: Camera::Orbit {
            target: place(Length::lit("-0.1")),
            distance: Length::lit("4.6"),
            pitch: Turn::from_degrees(18),
            field_of_view: 40,
            depth: (1.0, 8.0),
        },
        background: [16, 20, 40],
        objects: Vec::leak(vec![floor, object]),
    })
}

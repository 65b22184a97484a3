//! The reader of blobs.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::Size;
use scenes::mesh::CUBE;
use scenes::texture::BRICK;
use topleft::{Aligned, BlobError, Cull, Depth16, Length, Material, Mesh, NoDepth, Pose, Sun, Texture, Turn};

use crate::lens::{Lens, Orbit};
use crate::picture::{Item, Look, Picture};

/// Most bytes that are read, and most faces that are drawn.
const MOST_BYTES: usize = 8192;
const MOST_FACES: usize = 64;

/// So near that its near plane may cut what stands in the cube from -1 to 1.
const EYE: Lens = Lens::Usual(Orbit { perspective: true, eye: [10, 20, 40], wide: 90, near: 120 });

/// Reads any bytes as a mesh and as a texture, wherever they start, draws what they are, and gives back how many pixels
/// that is.
///
/// # Panics
/// Where they start decides on what they are, or what they are cannot be drawn.
pub fn check_blob(bytes: &[u8]) -> usize {
    let bytes = &bytes[..bytes.len().min(MOST_BYTES)];
    let [even, odd, longer] =
        [(2, 0), (1, 0), (0, 5)].map(|(before, after)| Placed::new(bytes, before, after));
    let aligned = Placed::new(bytes, 0, 0);
    let mesh = Mesh::from_bytes(aligned.bytes());
    // Meshes have no equality; all they hold is in what they print.
    let printed = |placed: &Placed| match Mesh::from_bytes(placed.bytes()) {
        Ok(mesh) => Ok(format!("{mesh:?}")),
        Err(error) => Err(error),
    };
    let texture = Texture::from_bytes(aligned.bytes());
    compare("mesh", &printed(&aligned), [&even, &odd, &longer].map(printed));
    compare("texture", &texture, [&even, &odd, &longer].map(|placed| Texture::from_bytes(placed.bytes())));
    assert!(mesh.is_err() || texture.is_err(), "both a mesh and a texture");
    let mut pixels = 0;
    if let Ok(mesh) = mesh {
        let count = mesh.positions().len();
        assert!(mesh.faces().iter().flatten().all(|&vertex| usize::from(vertex) < count));
        if mesh.faces().len() <= MOST_FACES {
            pixels += draw(mesh, BRICK);
        }
    }
    if let Ok(texture) = texture {
        assert_eq!(texture.texels().len(), usize::from(texture.width()) * usize::from(texture.height()));
        pixels += draw(CUBE, texture);
    }
    pixels
}

/// Bytes some way behind a multiple of 4.
struct Placed {
    buffer: Box<Aligned<[u8; MOST_BYTES + 8]>>,
    before: usize,
    length: usize,
}

impl Placed {
    fn new(bytes: &[u8], before: usize, after: usize) -> Self {
        let mut buffer = Box::new(Aligned([0xA5; MOST_BYTES + 8]));
        buffer.0[before..before + bytes.len()].copy_from_slice(bytes);
        Self { buffer, before, length: bytes.len() + after }
    }

    fn bytes(&self) -> &[u8] {
        &self.buffer.0[self.before..self.before + self.length]
    }
}

/// Bytes at another even place are the same; at an odd one they may be refused; and what follows is not read.
fn compare<T: PartialEq + std::fmt::Debug>(
    what: &str,
    aligned: &Result<T, BlobError>,
    [even, odd, longer]: [Result<T, BlobError>; 3],
) {
    assert_eq!(&even, aligned, "a {what} at an even place");
    assert!(odd == *aligned || odd == Err(BlobError::Misaligned), "a {what} at an odd place: {odd:?}");
    assert!(longer == *aligned || aligned.is_err(), "a {what} with more behind it: {longer:?}");
}

/// Draws a mesh in all ways and by all shaders.
fn draw(mesh: Mesh<'_>, texture: Texture<'_>) -> usize {
    let size = Size::new(40, 30);
    let sun = Sun::new([Length::ONE; 3]);
    let mut pixels = 0;
    // Where the blob says that it stands, and where it is seen.
    for mesh in [mesh, mesh.with_box([Length::ZERO; 3], Length::ONE)] {
        let item = |look| Item {
            mesh,
            pose: Pose::new().turned_y(Turn::from_degrees(20)),
            cull: Cull::None,
            look,
            material: Material::OfMesh,
            sun,
            texture,
        };
        let vertices = mesh.positions().len() * 8 * Look::ALL.len();
        let picture = Picture {
            size,
            camera: EYE.camera(size),
            items: Look::ALL.into_iter().map(item).collect(),
            storage: [vertices + 10_000, 1_000],
            columns: 40,
            rows: 0..30,
            height: 7,
            display: [40, 30],
        };
        let check = || {
            picture.check::<Rgb888, NoDepth>()?;
            Ok::<_, String>(picture.check::<Rgb565, Depth16>()?.seen())
        };
        pixels += check().unwrap_or_else(|error| panic!("{error}"));
    }
    pixels
}

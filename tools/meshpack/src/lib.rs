//! Packs meshes and images for topleft: OBJ and STL files become meshes, images become RGB565 textures, and both are
//! drawn at once, or written as a `const` Rust file or as a blob that firmware reads in place.
//!
//! ```no_run
//! let packed = meshpack::read_mesh("teapot.obj")?.fit(1.0).quantise()?;
//! println!("{packed}");
//! let mesh: topleft::Mesh<'_> = packed.mesh();
//! # Ok::<(), meshpack::Error>(())
//! ```

mod error;
mod make;
mod model;
mod normals;
mod output;
mod polygon;
mod quantise;
mod read_image;
mod read_obj;
mod read_stl;
mod scan_obj;
mod write_blob;
mod write_rust;

pub use error::{Error, Problem};
pub use make::{Made, generated, made_meshes, made_textures};
pub use model::Model;
pub use output::write_all;
pub use quantise::{Packed, QuantisationError};
pub use read_image::{PackedTexture, read_texture};
pub use read_obj::read_obj;
pub use read_stl::read_stl;

use std::path::Path;

/// Reads a mesh file by the end of its name: `.obj` or `.stl`, in small or capital letters.
///
/// # Errors
/// Another end, or what [`read_obj`] and [`read_stl`] give.
pub fn read_mesh(path: impl AsRef<Path>) -> Result<Model, Error> {
    let path = path.as_ref();
    let end = path.extension().unwrap_or_default();
    if end.eq_ignore_ascii_case("obj") {
        read_obj(path)
    } else if end.eq_ignore_ascii_case("stl") {
        read_stl(path)
    } else {
        Err(Error::file(path, Problem::UnknownType))
    }
}

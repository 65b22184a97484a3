//! Reads Wavefront OBJ with its materials.

use crate::error::{Error, Problem};
use crate::model::{Corner, Model, Welder};
use crate::scan_obj::{Plain, plain};
use std::cell::RefCell;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use tobj::{LoadOptions, MTLLoadResult, Material};

/// Reads an OBJ file: positions, normals, texture coordinates and vertex colours, the faces of all its groups, and
/// from its materials a colour for each face (`Kd`) and the images they name (`map_Kd`).
///
/// Polygons become triangles, those with dents too. Normals that the file lacks are computed, smooth. Texture coordinates are turned
/// upside down, because v grows up in OBJ and down in the library. A material file that is missing or wrong is a
/// warning; lines, points and curves are passed over.
///
/// # Errors
/// A file that cannot be read, is empty, is no UTF-8 text or no mesh; or a line with too few numbers, with something
/// that is no finite number, with an index out of range, or with a texture coordinate beyond 32 repeats.
pub fn read_obj(path: impl AsRef<Path>) -> Result<Model, Error> {
    let path = path.as_ref();
    let bytes = fs::read(path).map_err(|error| Error::Read(path.into(), error))?;
    let plain = plain(path, &bytes)?;

    let library = RefCell::new(MaterialFiles::new(path));
    let options = LoadOptions { triangulate: true, single_index: true, ..LoadOptions::default() };
    let loaded =
        tobj::load_obj_buf(&mut plain.text.as_bytes(), &options, |name| library.borrow_mut().load(name));
    let (groups, materials) =
        loaded.map_err(|error| Error::file(path, Problem::Parser(error.to_string())))?;
    // Material files that cannot be used are warnings of the library's already.
    let materials = materials.unwrap_or_default();
    let library = library.into_inner();

    let mut welder = Welder::default();
    let coloured = materials.iter().any(|material| material.diffuse.is_some());
    for tobj::Model { mesh, .. } in &groups {
        let material = mesh.material_id.and_then(|id| materials.get(id));
        let face_colour = coloured.then(|| colour(material));
        for face in mesh.indices.as_chunks::<3>().0 {
            welder.face(face.map(|index| corner(mesh, index as usize, &plain)), face_colour);
        }
    }
    let textures =
        library.textures(materials.iter().filter_map(|material| material.diffuse_texture.as_deref()));
    Ok(Model { textures, warnings: library.warnings, ..welder.finish(path) })
}

fn corner(mesh: &tobj::Mesh, index: usize, plain: &Plain) -> Corner {
    let uv = mesh.texcoords.as_chunks().0.get(index);
    let normal = mesh.normals.as_chunks().0.get(index);
    let colour = mesh.vertex_color.as_chunks::<3>().0.get(index);
    Corner {
        position: mesh.positions.as_chunks().0.get(index).copied().unwrap_or_default(),
        normal: normal.copied().filter(|_| plain.normals),
        uv: uv.map(|&[u, v]| [u, 1.0 - v]).filter(|_| plain.uvs),
        colour: colour.zip(plain.colours).map(|(colour, full)| colour.map(|value| channel(value / full))),
    }
}

/// The diffuse colour of a material; white where there is none.
fn colour(material: Option<&Material>) -> [u8; 3] {
    material.and_then(|material| material.diffuse).map_or([255; 3], |diffuse| diffuse.map(channel))
}

/// A colour channel from 0..1 to 0..=255, to nearest.
fn channel(value: f64) -> u8 {
    (value * 255.0).round() as u8
}

/// The material files beside an OBJ file.
struct MaterialFiles {
    folder: PathBuf,
    warnings: Vec<String>,
    /// Where the file of the last materials stands: image names are relative to it.
    image_folder: PathBuf,
}

impl MaterialFiles {
    fn new(source: &Path) -> Self {
        let folder = source.parent().unwrap_or(Path::new("")).to_path_buf();
        Self { image_folder: folder.clone(), folder, warnings: Vec::new() }
    }

    /// Reads the material files that a `mtllib` line names: one whose name may have spaces, or several.
    fn load(&mut self, names: &Path) -> MTLLoadResult {
        let names = names.to_string_lossy().replace('\\', "/");
        let whole = self.folder.join(&names);
        let paths: Vec<PathBuf> = if whole.exists() {
            vec![whole]
        } else {
            names.split_whitespace().map(|name| self.folder.join(name)).collect()
        };
        let mut text = String::new();
        for path in paths {
            match fs::read(&path) {
                Ok(bytes) => {
                    self.image_folder = path.parent().unwrap_or(&self.folder).to_path_buf();
                    text += &self.plain(&path, &String::from_utf8_lossy(&bytes));
                }
                Err(error) => {
                    self.warnings.push(Error::Read(path, error).to_string());
                }
            }
        }
        tobj::load_mtl_buf(&mut text.as_bytes())
    }

    /// Names, `Kd` and `map_Kd` alone: the parser gives up a whole file for one line that it does not understand.
    fn plain(&mut self, path: &Path, text: &str) -> String {
        let mut plain = String::new();
        for (index, line) in text.lines().enumerate() {
            let (keyword, rest) = line.trim().split_once(char::is_whitespace).unwrap_or_default();
            let rest = rest.trim();
            let written = match keyword {
                "newmtl" if !rest.is_empty() => writeln!(plain, "newmtl {rest}"),
                "Kd" => match diffuse(rest) {
                    Some([r, g, b]) => writeln!(plain, "Kd {r:?} {g:?} {b:?}"),
                    None => {
                        let problem = Problem::NotANumber { keyword: "Kd".into(), value: rest.into() };
                        self.warnings.push(Error::line(path, index + 1, problem).to_string());
                        Ok(())
                    }
                },
                "map_Kd" => match image_name(rest) {
                    Some(name) => writeln!(plain, "map_Kd {name}"),
                    None => Ok(()),
                },
                _ => Ok(()),
            };
            written.expect("a String takes all text");
        }
        plain
    }

    /// The images named, each once, where they should stand.
    fn textures<'a>(&self, names: impl Iterator<Item = &'a str>) -> Vec<PathBuf> {
        let mut textures = Vec::new();
        for name in names {
            let path = self.image_folder.join(name);
            if !textures.contains(&path) {
                textures.push(path);
            }
        }
        textures
    }
}

/// One number for all channels, or three.
fn diffuse(text: &str) -> Option<[f64; 3]> {
    let words = text.split_whitespace().take_while(|word| !word.starts_with('#'));
    match *crate::scan_obj::numbers("Kd", words, 1).ok()? {
        [grey] => Some([grey; 3]),
        [r, g, b, ..] => Some([r, g, b]),
        _ => None,
    }
}

/// The file name after options such as `-s 1 1 1` or `-clamp on`.
fn image_name(mut text: &str) -> Option<String> {
    while text.starts_with('-') {
        text = after_word(text);
        while text
            .split_whitespace()
            .next()
            .is_some_and(|word| word.parse::<f64>().is_ok() || word == "on" || word == "off")
        {
            text = after_word(text);
        }
    }
    if text.is_empty() { None } else { Some(text.replace('\\', "/")) }
}

fn after_word(text: &str) -> &str {
    text.split_once(char::is_whitespace).map_or("", |(_, rest)| rest.trim_start())
}

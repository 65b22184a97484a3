//! Writes a mesh or a texture as a Rust file whose constant is checked when it is compiled.

use crate::quantise::Packed;
use crate::read_image::PackedTexture;
use std::fmt::{Display, Write};
use topleft::Wrap;

/// Columns of a line of numbers.
const WIDTH: usize = 110;

impl Packed {
    /// A Rust file with `pub const NAME: Mesh<'static>` and the arrays that it borrows.
    ///
    /// `name` has to be a Rust constant's name, and `doc` is one line about the mesh.
    pub fn to_rust(&self, name: &str, doc: &str) -> String {
        let mut file = format!(
            "//! {doc}\n//!\n//! {} vertices, {} faces, {} bytes. Written by `meshpack`: change what it was made from.\n\n\
             use topleft::{{Length, Mesh, MeshError}};\n\n/// {doc}\n",
            self.positions.len(),
            self.faces.len(),
            self.bytes()
        );
        let calls = self.calls();
        let (last, first) = calls.split_last().map_or(("mesh", &[][..]), |(last, first)| (last, first));
        put(&mut file, format_args!("pub const {name}: Mesh<'static> = {{"));
        put(&mut file, format_args!("    let mesh = checked(Mesh::new(&POSITIONS, &FACES));"));
        put(&mut file, format_args!("    let centre = [{}];", self.centre.map(length).join(", ")));
        let with_box = format!("mesh.with_box(centre, {})", length(self.half));
        if calls.is_empty() {
            put(&mut file, format_args!("    {with_box}"));
        } else {
            put(&mut file, format_args!("    let mesh = {with_box};"));
            for call in first {
                put(&mut file, format_args!("    let mesh = {call};"));
            }
            put(&mut file, format_args!("    {last}"));
        }
        file += "};\n\n\
                 const fn checked(mesh: Result<Mesh<'static>, MeshError>) -> Mesh<'static> {\n    \
                 match mesh {\n        Ok(mesh) => mesh,\n        \
                 Err(_) => panic!(\"an index or a length of this mesh is wrong\"),\n    }\n}\n";

        rows(&mut file, "POSITIONS", "[i16; 3]", &self.positions);
        rows(&mut file, "FACES", "[u16; 3]", &self.faces);
        rows(&mut file, "NORMALS", "[i8; 3]", &self.normals);
        rows(&mut file, "FACE_NORMALS", "[i8; 3]", &self.face_normals);
        rows(&mut file, "UVS", "[i16; 2]", &self.uvs);
        rows(&mut file, "VERTEX_COLOURS", "[u8; 3]", &self.vertex_colours);
        rows(&mut file, "FACE_COLOURS", "[u8; 3]", &self.face_colours);
        file
    }

    /// The calls that give the mesh its attributes.
    fn calls(&self) -> Vec<String> {
        let uvs = format!("checked(mesh.with_uvs(&UVS, {}))", self.uv_exponent);
        let calls = [
            (self.normals.len(), "checked(mesh.with_normals(&NORMALS))"),
            (self.face_normals.len(), "checked(mesh.with_face_normals(&FACE_NORMALS))"),
            (self.uvs.len(), &uvs),
            (self.vertex_colours.len(), "checked(mesh.with_vertex_colours(&VERTEX_COLOURS))"),
            (self.face_colours.len(), "checked(mesh.with_face_colours(&FACE_COLOURS))"),
        ];
        calls.iter().filter(|(length, _)| *length > 0).map(|(_, call)| (*call).to_owned()).collect()
    }
}

impl PackedTexture {
    /// A Rust file with `pub const NAME: Texture<'static>` and the texels that it borrows.
    ///
    /// `name` has to be a Rust constant's name, and `doc` is one line about the texture.
    pub fn to_rust(&self, name: &str, doc: &str) -> String {
        let (width, height) = (self.width, self.height);
        let wrap = match self.wrap {
            Wrap::Repeat => "Repeat",
            Wrap::Clamp => "Clamp",
        };
        let mut file = format!(
            "//! {doc}\n//!\n//! {width}x{height} texels, {} bytes. Written by `meshpack`: change what it was made from.\n\n\
             use topleft::{{Texture, Wrap}};\n\n/// {doc}\n\
             pub const {name}: Texture<'static> = match Texture::new({width}, {height}, &TEXELS) {{\n    \
             Ok(texture) => texture.with_wrap(Wrap::{wrap}),\n    \
             Err(_) => panic!(\"the size of this texture is wrong\"),\n}};\n",
            self.bytes()
        );
        let texels: Vec<String> = self.texels.iter().map(|texel| format!("{texel:#06x}")).collect();
        array(&mut file, "TEXELS", "u16", &texels);
        file
    }
}

fn length(length: topleft::Length) -> String {
    format!("Length::from_bits({})", length.to_bits())
}

fn rows<T: Display, const N: usize>(file: &mut String, name: &str, kind: &str, rows: &[[T; N]]) {
    let row = |row: &[T; N]| format!("[{}]", row.each_ref().map(T::to_string).join(", "));
    array(file, name, kind, &rows.iter().map(row).collect::<Vec<_>>());
}

/// A static array, unless it is empty.
fn array(file: &mut String, name: &str, kind: &str, entries: &[String]) {
    if entries.is_empty() {
        return;
    }
    put(file, format_args!("\n#[rustfmt::skip]\nstatic {name}: [{kind}; {}] = [", entries.len()));
    let mut line = String::new();
    for entry in entries {
        if 4 + line.len() + entry.len() + 2 > WIDTH {
            put(file, format_args!("   {line}"));
            line.clear();
        }
        line += " ";
        line += entry;
        line += ",";
    }
    put(file, format_args!("   {line}\n];"));
}

fn put(file: &mut String, line: std::fmt::Arguments<'_>) {
    file.write_fmt(line).expect("a String takes all text");
    file.push('\n');
}

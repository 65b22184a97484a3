//! A level square from -1 to 1 of two faces, eight repeats of a texture each way.
//!
//! 4 vertices, 2 faces, 70 bytes. Written by `meshpack`: change what it was made from.

use topleft::{Length, Mesh, MeshError};

/// A level square from -1 to 1 of two faces, eight repeats of a texture each way.
pub const GROUND: Mesh<'static> = {
    let mesh = checked(Mesh::new(&POSITIONS, &FACES));
    let centre = [Length::from_bits(0), Length::from_bits(0), Length::from_bits(0)];
    let mesh = mesh.with_box(centre, Length::from_bits(65538));
    let mesh = checked(mesh.with_normals(&NORMALS));
    let mesh = checked(mesh.with_face_normals(&FACE_NORMALS));
    checked(mesh.with_uvs(&UVS, 4))
};

const fn checked(mesh: Result<Mesh<'static>, MeshError>) -> Mesh<'static> {
    match mesh {
        Ok(mesh) => mesh,
        Err(_) => panic!("an index or a length of this mesh is wrong"),
    }
}

#[rustfmt::skip]
static POSITIONS: [[i16; 3]; 4] = [
    [-32767, 0, -32767], [-32767, 0, 32767], [32767, 0, 32767], [32767, 0, -32767],
];

#[rustfmt::skip]
static FACES: [[u16; 3]; 2] = [
    [0, 1, 2], [0, 2, 3],
];

#[rustfmt::skip]
static NORMALS: [[i8; 3]; 4] = [
    [0, 127, 0], [0, 127, 0], [0, 127, 0], [0, 127, 0],
];

#[rustfmt::skip]
static FACE_NORMALS: [[i8; 3]; 2] = [
    [0, 127, 0], [0, 127, 0],
];

#[rustfmt::skip]
static UVS: [[i16; 2]; 4] = [
    [0, 0], [0, 16384], [16384, 16384], [16384, 0],
];

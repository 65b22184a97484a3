//! A cube from -1 to 1: a colour and a texture's whole image on each side.
//!
//! 24 vertices, 12 faces, 456 bytes. Written by `meshpack`: change what it was made from.

use topleft::{Length, Mesh, MeshError};

/// A cube from -1 to 1: a colour and a texture's whole image on each side.
pub const CUBE: Mesh<'static> = {
    let mesh = checked(Mesh::new(&POSITIONS, &FACES));
    let centre = [Length::from_bits(0), Length::from_bits(0), Length::from_bits(0)];
    let mesh = mesh.with_box(centre, Length::from_bits(65538));
    let mesh = checked(mesh.with_normals(&NORMALS));
    let mesh = checked(mesh.with_face_normals(&FACE_NORMALS));
    let mesh = checked(mesh.with_uvs(&UVS, 1));
    checked(mesh.with_face_colours(&FACE_COLOURS))
};

const fn checked(mesh: Result<Mesh<'static>, MeshError>) -> Mesh<'static> {
    match mesh {
        Ok(mesh) => mesh,
        Err(_) => panic!("an index or a length of this mesh is wrong"),
    }
}

#[rustfmt::skip]
static POSITIONS: [[i16; 3]; 24] = [
    [-32767, 32767, 32767], [-32767, -32767, 32767], [32767, -32767, 32767], [32767, 32767, 32767],
    [32767, 32767, 32767], [32767, -32767, 32767], [32767, -32767, -32767], [32767, 32767, -32767],
    [32767, 32767, -32767], [32767, -32767, -32767], [-32767, -32767, -32767], [-32767, 32767, -32767],
    [-32767, 32767, -32767], [-32767, -32767, -32767], [-32767, -32767, 32767], [-32767, 32767, 32767],
    [-32767, 32767, -32767], [-32767, 32767, 32767], [32767, 32767, 32767], [32767, 32767, -32767],
    [-32767, -32767, 32767], [-32767, -32767, -32767], [32767, -32767, -32767], [32767, -32767, 32767],
];

#[rustfmt::skip]
static FACES: [[u16; 3]; 12] = [
    [0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7], [8, 9, 10], [8, 10, 11], [12, 13, 14], [12, 14, 15],
    [16, 17, 18], [16, 18, 19], [20, 21, 22], [20, 22, 23],
];

#[rustfmt::skip]
static NORMALS: [[i8; 3]; 24] = [
    [0, 0, 127], [0, 0, 127], [0, 0, 127], [0, 0, 127], [127, 0, 0], [127, 0, 0], [127, 0, 0], [127, 0, 0],
    [0, 0, -127], [0, 0, -127], [0, 0, -127], [0, 0, -127], [-127, 0, 0], [-127, 0, 0], [-127, 0, 0],
    [-127, 0, 0], [0, 127, 0], [0, 127, 0], [0, 127, 0], [0, 127, 0], [0, -127, 0], [0, -127, 0],
    [0, -127, 0], [0, -127, 0],
];

#[rustfmt::skip]
static FACE_NORMALS: [[i8; 3]; 12] = [
    [0, 0, 127], [0, 0, 127], [127, 0, 0], [127, 0, 0], [0, 0, -127], [0, 0, -127], [-127, 0, 0],
    [-127, 0, 0], [0, 127, 0], [0, 127, 0], [0, -127, 0], [0, -127, 0],
];

#[rustfmt::skip]
static UVS: [[i16; 2]; 24] = [
    [0, 0], [0, 16384], [16384, 16384], [16384, 0], [0, 0], [0, 16384], [16384, 16384], [16384, 0], [0, 0],
    [0, 16384], [16384, 16384], [16384, 0], [0, 0], [0, 16384], [16384, 16384], [16384, 0], [0, 0],
    [0, 16384], [16384, 16384], [16384, 0], [0, 0], [0, 16384], [16384, 16384], [16384, 0],
];

#[rustfmt::skip]
static FACE_COLOURS: [[u8; 3]; 12] = [
    [214, 64, 60], [214, 64, 60], [64, 160, 84], [64, 160, 84], [232, 140, 44], [232, 140, 44],
    [66, 98, 200], [66, 98, 200], [240, 236, 220], [240, 236, 220], [240, 208, 64], [240, 208, 64],
];

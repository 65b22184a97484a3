//! Four walls 2 units apart along the z axis from 0.5 to -11.5, seen from inside, and the one at the end.
//!
//! 20 vertices, 10 faces, 350 bytes. Written by `meshpack`: change what it was made from.

use topleft::{Length, Mesh, MeshError};

/// Four walls 2 units apart along the z axis from 0.5 to -11.5, seen from inside, and the one at the end.
pub const CORRIDOR: Mesh<'static> = {
    let mesh = checked(Mesh::new(&POSITIONS, &FACES));
    let centre = [Length::from_bits(0), Length::from_bits(0), Length::from_bits(-360448)];
    let mesh = mesh.with_box(centre, Length::from_bits(393228));
    let mesh = checked(mesh.with_normals(&NORMALS));
    let mesh = checked(mesh.with_face_normals(&FACE_NORMALS));
    checked(mesh.with_uvs(&UVS, 3))
};

const fn checked(mesh: Result<Mesh<'static>, MeshError>) -> Mesh<'static> {
    match mesh {
        Ok(mesh) => mesh,
        Err(_) => panic!("an index or a length of this mesh is wrong"),
    }
}

#[rustfmt::skip]
static POSITIONS: [[i16; 3]; 20] = [
    [-5461, 5461, 32767], [-5461, -5461, 32767], [-5461, -5461, -32767], [-5461, 5461, -32767],
    [5461, 5461, -32767], [5461, -5461, -32767], [5461, -5461, 32767], [5461, 5461, 32767],
    [-5461, -5461, -32767], [-5461, -5461, 32767], [5461, -5461, 32767], [5461, -5461, -32767],
    [-5461, 5461, 32767], [-5461, 5461, -32767], [5461, 5461, -32767], [5461, 5461, 32767],
    [-5461, 5461, -32767], [-5461, -5461, -32767], [5461, -5461, -32767], [5461, 5461, -32767],
];

#[rustfmt::skip]
static FACES: [[u16; 3]; 10] = [
    [0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7], [8, 9, 10], [8, 10, 11], [12, 13, 14], [12, 14, 15],
    [16, 17, 18], [16, 18, 19],
];

#[rustfmt::skip]
static NORMALS: [[i8; 3]; 20] = [
    [127, 0, 0], [127, 0, 0], [127, 0, 0], [127, 0, 0], [-127, 0, 0], [-127, 0, 0], [-127, 0, 0],
    [-127, 0, 0], [0, 127, 0], [0, 127, 0], [0, 127, 0], [0, 127, 0], [0, -127, 0], [0, -127, 0],
    [0, -127, 0], [0, -127, 0], [0, 0, 127], [0, 0, 127], [0, 0, 127], [0, 0, 127],
];

#[rustfmt::skip]
static FACE_NORMALS: [[i8; 3]; 10] = [
    [127, 0, 0], [127, 0, 0], [-127, 0, 0], [-127, 0, 0], [0, 127, 0], [0, 127, 0], [0, -127, 0],
    [0, -127, 0], [0, 0, 127], [0, 0, 127],
];

#[rustfmt::skip]
static UVS: [[i16; 2]; 20] = [
    [0, 0], [0, 4096], [24576, 4096], [24576, 0], [0, 0], [0, 4096], [24576, 4096], [24576, 0], [0, 0],
    [0, 24576], [4096, 24576], [4096, 0], [0, 0], [0, 24576], [4096, 24576], [4096, 0], [0, 0], [0, 4096],
    [4096, 4096], [4096, 0],
];

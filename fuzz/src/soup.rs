//! Any mesh and any texture.

use arbitrary::{Arbitrary, Unstructured};
use topleft::{Mesh, Texture, Wrap};

use crate::numbers::{Mostly, Number};

/// Most vertices and faces of one mesh: more of them would find nothing more, and slower.
const MOST: u8 = 24;
/// Most texels of a texture, as a power of two.
const MOST_TEXELS_LOG2: u8 = 12;

/// A mesh of any numbers.
#[derive(Clone, Debug)]
pub(crate) struct Soup {
    /// The centre of the mesh's cube, and half its edge: usually the origin, and one.
    cube: Mostly<(), ([Number; 3], Number)>,
    uv_exponent: u8,
    /// A bit for each attribute that is there.
    attributes: u8,
    vertices: Vec<Vertex>,
    faces: Vec<Face>,
}

#[derive(Arbitrary, Clone, Debug)]
struct Vertex {
    position: [i16; 3],
    normal: [i8; 3],
    uv: [i16; 2],
    colour: [u8; 3],
}

#[derive(Arbitrary, Clone, Debug)]
struct Face {
    corners: [u8; 3],
    normal: [i8; 3],
    colour: [u8; 3],
}

/// With counts of their own: slices that may end after each entry hardly ever get long.
impl<'a> Arbitrary<'a> for Soup {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        let (cube, uv_exponent, attributes) = bytes.arbitrary()?;
        let [vertices, faces] = <[u8; 2]>::arbitrary(bytes)?.map(|count| count % MOST);
        Ok(Self {
            cube,
            uv_exponent,
            attributes,
            vertices: (0..vertices).map(|_| bytes.arbitrary()).collect::<Result<_, _>>()?,
            faces: (0..faces).map(|_| bytes.arbitrary()).collect::<Result<_, _>>()?,
        })
    }
}

/// The slices of a mesh.
#[derive(Default)]
pub(crate) struct Slices {
    positions: Vec<[i16; 3]>,
    normals: Vec<[i8; 3]>,
    uvs: Vec<[i16; 2]>,
    colours: Vec<[u8; 3]>,
    faces: Vec<[u16; 3]>,
    face_normals: Vec<[i8; 3]>,
    face_colours: Vec<[u8; 3]>,
}

impl Soup {
    pub(crate) fn slices(&self) -> Slices {
        let mut slices = Slices::default();
        for vertex in &self.vertices {
            slices.positions.push(vertex.position);
            slices.normals.push(vertex.normal);
            slices.uvs.push(vertex.uv);
            slices.colours.push(vertex.colour);
        }
        let Some(count) = u16::try_from(slices.positions.len()).ok().filter(|&count| count > 0) else {
            return slices;
        };
        for face in &self.faces {
            slices.faces.push(face.corners.map(|corner| u16::from(corner) % count));
            slices.face_normals.push(face.normal);
            slices.face_colours.push(face.colour);
        }
        slices
    }

    /// The mesh that they make.
    pub(crate) fn mesh<'a>(&self, slices: &'a Slices) -> Mesh<'a> {
        let has = |attribute: u32| self.attributes >> attribute & 1 != 0;
        let made = || {
            let mut mesh = Mesh::new(&slices.positions, &slices.faces)?;
            if has(0) {
                mesh = mesh.with_normals(&slices.normals)?;
            }
            if has(1) {
                mesh = mesh.with_uvs(&slices.uvs, self.uv_exponent % 6)?;
            }
            if has(2) {
                mesh = mesh.with_vertex_colours(&slices.colours)?;
            }
            if has(3) {
                mesh = mesh.with_face_normals(&slices.face_normals)?;
            }
            if has(4) {
                mesh = mesh.with_face_colours(&slices.face_colours)?;
            }
            Ok::<_, topleft::MeshError>(mesh)
        };
        let mesh = made().expect("every index is a vertex, and every slice has its length");
        match self.cube {
            Mostly::Usual(()) => mesh,
            Mostly::Any((centre, half)) => mesh.with_box(centre.map(Number::length), half.length()),
        }
    }
}

/// A texture of any size, and of texels that tell where they are.
#[derive(Arbitrary, Clone, Debug)]
pub(crate) struct Image {
    sizes_log2: [u8; 2],
    clamp: bool,
}

impl Image {
    fn sizes(&self) -> [u16; 2] {
        let [width, height] = self.sizes_log2.map(|log2| log2 % 11);
        [1 << width, 1 << height.min(MOST_TEXELS_LOG2 - width)]
    }

    pub(crate) fn texels(&self) -> Vec<u16> {
        let [width, height] = self.sizes();
        (0..u32::from(width) * u32::from(height))
            .map(|i| (i.wrapping_mul(0x9E37_79B9) >> 16) as u16)
            .collect()
    }

    pub(crate) fn texture<'a>(&self, texels: &'a [u16]) -> Texture<'a> {
        let [width, height] = self.sizes();
        let texture = Texture::new(width, height, texels).expect("powers of two, and as many texels");
        texture.with_wrap(if self.clamp { Wrap::Clamp } else { Wrap::Repeat })
    }
}

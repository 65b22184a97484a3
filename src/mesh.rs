//! Stage 1. Borrowed meshes: checked once when they are made, so that no later stage can fail on them.

use crate::math::format::Length;

/// Most vertices of one mesh: indices are `u16`.
pub const MAX_VERTICES: usize = 65_535;

/// Largest exponent of texture coordinates: ±32 repeats of the texture.
pub const MAX_UV_EXPONENT: u8 = 5;

/// A triangle mesh borrowed from flash.
///
/// Positions are `i16`: the mesh's own cube from -1 to 1 in steps of 2^-15. The cube's centre and half edge, in the
/// scene's unit, are folded into the matrix when the mesh is drawn, so they cost nothing per vertex.
/// Front faces are counter-clockwise as the viewer sees them. All checks are `const`, so a mesh in a `const` item
/// that has an index out of range does not compile.
///
/// ```
/// use topleft::{Length, Mesh};
///
/// const POSITIONS: [[i16; 3]; 3] = [[-32767, -32767, 0], [32767, -32767, 0], [0, 32767, 0]];
/// let mesh = Mesh::new(&POSITIONS, &[[0, 1, 2]]).unwrap().with_box([Length::ZERO; 3], Length::lit("1.5"));
/// assert_eq!(mesh.faces().len(), 1);
/// assert!(Mesh::new(&POSITIONS, &[[0, 1, 3]]).is_err());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a> {
    positions: &'a [[i16; 3]],
    faces: &'a [[u16; 3]],
    normals: &'a [[i8; 3]],
    face_normals: &'a [[i8; 3]],
    uvs: &'a [[i16; 2]],
    /// A whole word, which is copied as one: three bytes of padding would be by a call.
    uv_exponent: u32,
    vertex_colours: &'a [[u8; 3]],
    face_colours: &'a [[u8; 3]],
    centre: [Length; 3],
    half: Length,
    /// Least and greatest position on each axis.
    bounds: [[i16; 3]; 2],
}

/// Why slices do not make a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshError {
    /// There are more than [`MAX_VERTICES`] vertices: this many.
    TooManyVertices(usize),
    /// A face names a vertex that is not there.
    IndexOutOfRange {
        /// The face, counted from 0.
        face: usize,
        /// The vertex it names.
        index: u16,
    },
    /// An attribute has not one entry for each vertex, or for each face.
    LengthMismatch {
        /// Entries given.
        given: usize,
        /// Entries needed.
        needed: usize,
    },
    /// The exponent of the texture coordinates is above [`MAX_UV_EXPONENT`].
    UvExponent(u8),
}

impl core::fmt::Display for MeshError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::TooManyVertices(count) => {
                write!(f, "{count} vertices, and at most {MAX_VERTICES} can be named")
            }
            Self::IndexOutOfRange { face, index } => {
                write!(f, "face {face} names vertex {index}, which is not there")
            }
            Self::LengthMismatch { given, needed } => {
                write!(f, "{given} entries of an attribute, {needed} needed")
            }
            Self::UvExponent(exponent) => {
                write!(
                    f,
                    "an exponent of {exponent} for texture coordinates, at most {MAX_UV_EXPONENT} allowed"
                )
            }
        }
    }
}

impl core::error::Error for MeshError {}

impl<'a> Mesh<'a> {
    /// A mesh of `positions` and of `faces` that name them, in the cube from -1 to 1 round the origin.
    ///
    /// # Errors
    /// More than [`MAX_VERTICES`] vertices, or a face with an index out of range.
    pub const fn new(positions: &'a [[i16; 3]], faces: &'a [[u16; 3]]) -> Result<Self, MeshError> {
        if let Err(error) = check_faces(positions.len(), faces) {
            return Err(error);
        }
        Ok(Self {
            positions,
            faces,
            normals: &[],
            face_normals: &[],
            uvs: &[],
            uv_exponent: 0,
            vertex_colours: &[],
            face_colours: &[],
            centre: [Length::ZERO; 3],
            half: Length::ONE,
            bounds: bounds(positions),
        })
    }

    /// Places the mesh's cube: a position `p` stands at `centre + p / 32768 * half` in the scene's unit.
    #[must_use]
    pub const fn with_box(mut self, centre: [Length; 3], half: Length) -> Self {
        self.centre = centre;
        self.half = half;
        self
    }

    /// Unit normals, one a vertex: 127 is 1.
    ///
    /// # Errors
    /// Not as many normals as vertices.
    pub const fn with_normals(mut self, normals: &'a [[i8; 3]]) -> Result<Self, MeshError> {
        self.normals = normals;
        self.check(normals.len(), self.positions.len())
    }

    /// Unit normals, one a face: 127 is 1.
    ///
    /// # Errors
    /// Not as many normals as faces.
    pub const fn with_face_normals(mut self, normals: &'a [[i8; 3]]) -> Result<Self, MeshError> {
        self.face_normals = normals;
        self.check(normals.len(), self.faces.len())
    }

    /// Texture coordinates, one a vertex: `raw * 2^exponent / 32768` of the texture's width and height.
    ///
    /// (0, 0) is the top left corner of the texture's first texel, and v grows down, as the rows of an image do.
    ///
    /// # Errors
    /// Not as many coordinates as vertices, or an exponent above [`MAX_UV_EXPONENT`].
    pub const fn with_uvs(mut self, uvs: &'a [[i16; 2]], exponent: u8) -> Result<Self, MeshError> {
        if exponent > MAX_UV_EXPONENT {
            return Err(MeshError::UvExponent(exponent));
        }
        self.uvs = uvs;
        self.uv_exponent = exponent as u32;
        self.check(uvs.len(), self.positions.len())
    }

    /// Colours, one a vertex: red, green, blue.
    ///
    /// # Errors
    /// Not as many colours as vertices.
    pub const fn with_vertex_colours(mut self, colours: &'a [[u8; 3]]) -> Result<Self, MeshError> {
        self.vertex_colours = colours;
        self.check(colours.len(), self.positions.len())
    }

    /// Colours, one a face: red, green, blue.
    ///
    /// # Errors
    /// Not as many colours as faces.
    pub const fn with_face_colours(mut self, colours: &'a [[u8; 3]]) -> Result<Self, MeshError> {
        self.face_colours = colours;
        self.check(colours.len(), self.faces.len())
    }

    const fn check(self, given: usize, needed: usize) -> Result<Self, MeshError> {
        if given == needed { Ok(self) } else { Err(MeshError::LengthMismatch { given, needed }) }
    }

    /// The vertices' positions in the mesh's cube.
    pub const fn positions(&self) -> &'a [[i16; 3]] {
        self.positions
    }

    /// The faces: three vertices each, counter-clockwise from outside.
    pub const fn faces(&self) -> &'a [[u16; 3]] {
        self.faces
    }

    /// The vertices' normals, or nothing.
    pub const fn normals(&self) -> &'a [[i8; 3]] {
        self.normals
    }

    /// The faces' normals, or nothing.
    pub const fn face_normals(&self) -> &'a [[i8; 3]] {
        self.face_normals
    }

    /// The vertices' texture coordinates, or nothing.
    pub const fn uvs(&self) -> &'a [[i16; 2]] {
        self.uvs
    }

    /// The exponent of the texture coordinates: they span ±2^exponent repeats.
    pub const fn uv_exponent(&self) -> u8 {
        self.uv_exponent as u8
    }

    /// The vertices' colours, or nothing.
    pub const fn vertex_colours(&self) -> &'a [[u8; 3]] {
        self.vertex_colours
    }

    /// The faces' colours, or nothing.
    pub const fn face_colours(&self) -> &'a [[u8; 3]] {
        self.face_colours
    }

    /// The centre of the mesh's cube in the scene's unit.
    pub const fn centre(&self) -> [Length; 3] {
        self.centre
    }

    /// Half the edge of the mesh's cube in the scene's unit.
    pub const fn half(&self) -> Length {
        self.half
    }

    /// The least and the greatest position on each axis, for rejecting a whole mesh.
    pub const fn bounds(&self) -> [[i16; 3]; 2] {
        self.bounds
    }
}

/// Whether faces can name as many vertices, and name no others.
pub(crate) const fn check_faces(vertices: usize, faces: &[[u16; 3]]) -> Result<(), MeshError> {
    if vertices > MAX_VERTICES {
        return Err(MeshError::TooManyVertices(vertices));
    }
    let mut rest = faces;
    let mut face = 0;
    while let [[a, b, c], tail @ ..] = rest {
        let largest = if *a > *b { *a } else { *b };
        let largest = if largest > *c { largest } else { *c };
        if largest as usize >= vertices {
            return Err(MeshError::IndexOutOfRange { face, index: largest });
        }
        rest = tail;
        face += 1;
    }
    Ok(())
}

const fn bounds(positions: &[[i16; 3]]) -> [[i16; 3]; 2] {
    const fn least(a: i16, b: i16) -> i16 {
        if a < b { a } else { b }
    }
    const fn greatest(a: i16, b: i16) -> i16 {
        if a > b { a } else { b }
    }
    // Written out: an array of six bytes is copied by a call.
    let [mut low, mut high] = match positions {
        [[x, y, z], ..] => [[*x, *y, *z], [*x, *y, *z]],
        [] => [[0; 3]; 2],
    };
    let mut rest = positions;
    while let [[x, y, z], tail @ ..] = rest {
        low = [least(low[0], *x), least(low[1], *y), least(low[2], *z)];
        high = [greatest(high[0], *x), greatest(high[1], *y), greatest(high[2], *z)];
        rest = tail;
    }
    [low, high]
}

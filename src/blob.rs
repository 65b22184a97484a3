//! Stage 1. Meshes and textures read in place from the bytes that `meshpack` writes, checked like all others.
//!
//! All numbers are little-endian. Every section starts at a multiple of 4 bytes, and the bytes between sections are
//! not read, nor is what follows the last one.
//!
//! A mesh:
//!
//! | offset | type | what |
//! |---|---|---|
//! | 0 | `[u8; 4]` | `TLMH` |
//! | 4 | `u16` | version, 1 |
//! | 6 | `u16` | attributes: 1 normals, 2 face normals, 4 texture coordinates, 8 vertex colours, 16 face colours |
//! | 8 | `u32` | vertices |
//! | 12 | `u32` | faces |
//! | 16 | `u32` | exponent of the texture coordinates |
//! | 20 | `[i32; 3]` | centre, the bits of a [`Length`] |
//! | 32 | `i32` | half edge, the bits of a [`Length`] |
//! | 36 | `[i16; 3]` x vertices | positions |
//! | | `[u16; 3]` x faces | faces |
//! | | `[i8; 3]` x vertices | normals, if there are any |
//! | | `[i8; 3]` x faces | face normals, if there are any |
//! | | `[i16; 2]` x vertices | texture coordinates, if there are any |
//! | | `[u8; 3]` x vertices | vertex colours, if there are any |
//! | | `[u8; 3]` x faces | face colours, if there are any |
//!
//! A texture:
//!
//! | offset | type | what |
//! |---|---|---|
//! | 0 | `[u8; 4]` | `TLTX` |
//! | 4 | `u16` | version, 1 |
//! | 6 | `u16` | beyond the edges: 0 repeat, 1 clamp |
//! | 8 | `u16` | width |
//! | 10 | `u16` | height |
//! | 12 | `u16` x width x height | RGB565 texels, in rows from the top |

use crate::math::format::Length;
use crate::mesh::{Mesh, MeshError};
use crate::texture::{Texture, TextureError, Wrap};
use bytemuck::AnyBitPattern;

const MESH_MAGIC: [u8; 4] = *b"TLMH";
const TEXTURE_MAGIC: [u8; 4] = *b"TLTX";
const VERSION: u16 = 1;

const NORMALS: u16 = 1;
const FACE_NORMALS: u16 = 2;
const UVS: u16 = 4;
const VERTEX_COLOURS: u16 = 8;
const FACE_COLOURS: u16 = 16;
const ALL_ATTRIBUTES: u16 = NORMALS | FACE_NORMALS | UVS | VERTEX_COLOURS | FACE_COLOURS;

/// Bytes that start at a multiple of 4, as a blob must: those of `include_bytes!` may start anywhere.
///
/// ```
/// use topleft::{Aligned, BlobError, Texture};
///
/// // In a program: &Aligned(*include_bytes!("brick.texture"))
/// static BRICK: &Aligned<[u8]> = &Aligned(*b"TLTX\x01\0\0\0\x02\0\x01\0\xFF\xFF\x1F\0");
///
/// let texture = Texture::from_bytes(&BRICK.0).unwrap();
/// assert_eq!((texture.width(), texture.height()), (2, 1));
/// assert_eq!(texture.texels(), [0xFFFF, 0x001F]);
/// assert_eq!(Texture::from_bytes(&BRICK.0[1..]).unwrap_err(), BlobError::BadMagic(*b"LTX\x01"));
/// ```
#[repr(C, align(4))]
#[derive(Debug)]
pub struct Aligned<T: ?Sized>(pub T);

/// Why bytes are not a mesh or a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlobError {
    /// The first four bytes are not those of the format.
    BadMagic([u8; 4]),
    /// Another version of the format.
    Version(u16),
    /// Attributes that this version does not have.
    Attributes(u16),
    /// Neither repeat nor clamp.
    Wrap(u16),
    /// The bytes end before the data does.
    Truncated {
        /// Bytes needed up to the end of the section that is cut.
        needed: usize,
        /// Bytes given.
        given: usize,
    },
    /// The bytes do not start at an even address; see [`Aligned`].
    Misaligned,
    /// The processor is big-endian, and the data is not.
    BigEndian,
    /// The sections are there, but are not a mesh.
    Mesh(MeshError),
    /// The texels are there, but are not a texture.
    Texture(TextureError),
}

impl From<MeshError> for BlobError {
    fn from(error: MeshError) -> Self {
        Self::Mesh(error)
    }
}

impl From<TextureError> for BlobError {
    fn from(error: TextureError) -> Self {
        Self::Texture(error)
    }
}

impl core::fmt::Display for BlobError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::BadMagic(magic) => write!(f, "the bytes start with {magic:?}"),
            Self::Version(version) => write!(f, "version {version} of the format, {VERSION} can be read"),
            Self::Attributes(attributes) => write!(f, "unknown attributes {attributes:#x}"),
            Self::Wrap(wrap) => write!(f, "{wrap} is neither repeat nor clamp"),
            Self::Truncated { needed, given } => write!(f, "{given} bytes, {needed} needed"),
            Self::Misaligned => write!(f, "the bytes do not start at an even address"),
            Self::BigEndian => write!(f, "the data is little-endian, and the processor is not"),
            Self::Mesh(error) => error.fmt(f),
            Self::Texture(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for BlobError {}

impl<'a> Mesh<'a> {
    /// Reads a mesh in place from the blob that `meshpack` wrote. Nothing is copied.
    ///
    /// # Errors
    /// Bytes that are not such a blob, or are cut, or at an odd address; every index is checked, as [`Mesh::new`] does.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, BlobError> {
        let mut sections = Sections::new(bytes, MESH_MAGIC)?;
        let [attributes] = sections.header()?;
        let attributes = u16::from_le_bytes(attributes);
        if attributes & !ALL_ATTRIBUTES != 0 {
            return Err(BlobError::Attributes(attributes));
        }
        let [vertices, faces, exponent, x, y, z, half] = sections.header()?;
        let (vertices, faces) = (count(vertices), count(faces));
        let exponent = u8::try_from(u32::from_le_bytes(exponent)).unwrap_or(u8::MAX);
        let [x, y, z, half] = [x, y, z, half].map(|bits| Length::from_bits(i32::from_le_bytes(bits)));

        let positions = sections.take(vertices)?;
        let mut mesh = Self::new(positions, sections.take(faces)?)?.with_box([x, y, z], half);
        if attributes & NORMALS != 0 {
            mesh = mesh.with_normals(sections.take(vertices)?)?;
        }
        if attributes & FACE_NORMALS != 0 {
            mesh = mesh.with_face_normals(sections.take(faces)?)?;
        }
        if attributes & UVS != 0 {
            mesh = mesh.with_uvs(sections.take(vertices)?, exponent)?;
        }
        if attributes & VERTEX_COLOURS != 0 {
            mesh = mesh.with_vertex_colours(sections.take(vertices)?)?;
        }
        if attributes & FACE_COLOURS != 0 {
            mesh = mesh.with_face_colours(sections.take(faces)?)?;
        }
        Ok(mesh)
    }
}

impl<'a> Texture<'a> {
    /// Reads a texture in place from the blob that `meshpack` wrote. Nothing is copied.
    ///
    /// # Errors
    /// Bytes that are not such a blob, or are cut, or at an odd address; sizes are checked, as [`Texture::new`] does.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, BlobError> {
        let mut sections = Sections::new(bytes, TEXTURE_MAGIC)?;
        let [wrap, width, height] = sections.header()?.map(u16::from_le_bytes);
        let wrap = match wrap {
            0 => Wrap::Repeat,
            1 => Wrap::Clamp,
            other => return Err(BlobError::Wrap(other)),
        };
        let texels = sections.take(usize::from(width).saturating_mul(usize::from(height)))?;
        Ok(Self::new(width, height, texels)?.with_wrap(wrap))
    }
}

/// A count that no memory can hold becomes one that is found missing.
fn count(bytes: [u8; 4]) -> usize {
    usize::try_from(u32::from_le_bytes(bytes)).unwrap_or(usize::MAX)
}

/// The part of a blob that is not read yet.
struct Sections<'a> {
    rest: &'a [u8],
    given: usize,
}

impl<'a> Sections<'a> {
    fn new(bytes: &'a [u8], magic: [u8; 4]) -> Result<Self, BlobError> {
        if cfg!(target_endian = "big") {
            return Err(BlobError::BigEndian);
        }
        let mut sections = Self { rest: bytes, given: bytes.len() };
        let [found] = sections.header()?;
        if found != magic {
            return Err(BlobError::BadMagic(found));
        }
        let [version] = sections.header()?.map(u16::from_le_bytes);
        if version != VERSION {
            return Err(BlobError::Version(version));
        }
        Ok(sections)
    }

    /// `N` numbers of the header, of `SIZE` bytes each, wherever they stand.
    fn header<const N: usize, const SIZE: usize>(&mut self) -> Result<[[u8; SIZE]; N], BlobError> {
        let mut numbers = [[0; SIZE]; N];
        for number in &mut numbers {
            let Some((bytes, rest)) = self.rest.split_first_chunk() else {
                return Err(self.truncated(SIZE));
            };
            (*number, self.rest) = (*bytes, rest);
        }
        Ok(numbers)
    }

    /// The next section, of `count` entries.
    fn take<T: AnyBitPattern>(&mut self, count: usize) -> Result<&'a [T], BlobError> {
        if count == 0 {
            return Ok(&[]);
        }
        let length = count.saturating_mul(size_of::<T>());
        let Some((section, rest)) = self.rest.split_at_checked(length) else {
            return Err(self.truncated(length));
        };
        // The next section starts at a multiple of 4. The last one may end the bytes without it.
        let padding = rest.len().wrapping_sub(self.given) % 4;
        self.rest = rest.get(padding..).unwrap_or_default();
        bytemuck::try_cast_slice(section).map_err(|_| BlobError::Misaligned)
    }

    fn truncated(&self, length: usize) -> BlobError {
        let read = self.given.saturating_sub(self.rest.len());
        BlobError::Truncated { needed: read.saturating_add(length), given: self.given }
    }
}

//! Writes a mesh or a texture as the blob that the library reads in place. The library's `blob` module has the layout.

use crate::quantise::Packed;
use crate::read_image::PackedTexture;
use topleft::Wrap;

const VERSION: u16 = 1;

impl Packed {
    /// The blob that [`topleft::Mesh::from_bytes`] reads.
    pub fn to_blob(&self) -> Vec<u8> {
        let lengths = [
            self.normals.len(),
            self.face_normals.len(),
            self.uvs.len(),
            self.vertex_colours.len(),
            self.face_colours.len(),
        ];
        let flags =
            lengths.iter().enumerate().map(|(bit, length)| u16::from(*length > 0) << bit).sum::<u16>();
        let mut blob = b"TLMH".to_vec();
        blob.extend(VERSION.to_le_bytes());
        blob.extend(flags.to_le_bytes());
        for count in [self.positions.len(), self.faces.len(), self.uv_exponent.into()] {
            blob.extend((count as u32).to_le_bytes());
        }
        for length in self.centre.into_iter().chain([self.half]) {
            blob.extend(length.to_bits().to_le_bytes());
        }
        section(&mut blob, self.positions.as_flattened(), |value| value.to_le_bytes());
        section(&mut blob, self.faces.as_flattened(), |value| value.to_le_bytes());
        section(&mut blob, self.normals.as_flattened(), |value| value.to_le_bytes());
        section(&mut blob, self.face_normals.as_flattened(), |value| value.to_le_bytes());
        section(&mut blob, self.uvs.as_flattened(), |value| value.to_le_bytes());
        section(&mut blob, self.vertex_colours.as_flattened(), |value| [*value]);
        section(&mut blob, self.face_colours.as_flattened(), |value| [*value]);
        blob
    }
}

impl PackedTexture {
    /// The blob that [`topleft::Texture::from_bytes`] reads.
    pub fn to_blob(&self) -> Vec<u8> {
        let wrap: u16 = match self.wrap {
            Wrap::Repeat => 0,
            Wrap::Clamp => 1,
        };
        let mut blob = b"TLTX".to_vec();
        for number in [VERSION, wrap, self.width, self.height] {
            blob.extend(number.to_le_bytes());
        }
        section(&mut blob, &self.texels, |texel| texel.to_le_bytes());
        blob
    }
}

/// A section, and zeros up to a multiple of 4 bytes.
fn section<T, const SIZE: usize>(blob: &mut Vec<u8>, values: &[T], bytes: impl Fn(&T) -> [u8; SIZE]) {
    blob.extend(values.iter().flat_map(bytes));
    blob.resize(blob.len().next_multiple_of(4), 0);
}

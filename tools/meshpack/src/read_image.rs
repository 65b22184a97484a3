//! Reads images as RGB565 textures.

use crate::error::{Error, Problem};
use image::{ImageError, ImageReader, Limits};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use topleft::{MAX_TEXTURE_SIZE, Texture, Wrap};

/// A texture in the library's format, checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackedTexture {
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) texels: Vec<u16>,
    pub(crate) wrap: Wrap,
}

/// Reads a PNG, JPEG or BMP file. Each channel is rounded to the nearest of RGB565; transparency is not looked at.
///
/// # Errors
/// A file that cannot be read or is no such image, or sizes that are not powers of two up to 1024.
pub fn read_texture(path: impl AsRef<Path>) -> Result<PackedTexture, Error> {
    let path = path.as_ref();
    let reader = || {
        let file = File::open(path).map_err(|error| Error::Read(path.into(), error))?;
        if file.metadata().is_ok_and(|data| data.len() == 0) {
            return Err(Error::file(path, Problem::Empty));
        }
        let reader = ImageReader::new(BufReader::new(file)).with_guessed_format();
        reader.map_err(|error| Error::Read(path.into(), error))
    };
    let fail = |error: ImageError| Error::file(path, Problem::Parser(format!("not an image: {error}")));
    // The size is known before anything large is decoded.
    let (width, height) = reader()?.into_dimensions().map_err(fail)?;
    let [Some(narrow_width), Some(narrow_height)] = [width, height].map(texture_size) else {
        return Err(Error::file(path, Problem::ImageSize(width, height)));
    };
    let mut reader = reader()?;
    reader.limits(Limits::default());
    let image = reader.decode().map_err(fail)?.to_rgb8();
    let texels = image.pixels().map(|pixel| rgb565(pixel.0)).collect();
    Ok(PackedTexture { width: narrow_width, height: narrow_height, texels, wrap: Wrap::Repeat })
}

/// The size, if a texture may have it.
fn texture_size(size: u32) -> Option<u16> {
    u16::try_from(size).ok().filter(|size| size.is_power_of_two() && *size <= MAX_TEXTURE_SIZE)
}

/// Red, green and blue in 5, 6 and 5 bits, each to nearest.
pub(crate) fn rgb565([r, g, b]: [u8; 3]) -> u16 {
    let nearest = |channel: u8, most: u16| (u16::from(channel) * most + 127) / 255;
    nearest(r, 31) << 11 | nearest(g, 63) << 5 | nearest(b, 31)
}

impl PackedTexture {
    /// The same texture, with another behaviour beyond its edges. It repeats unless told otherwise.
    #[must_use]
    pub fn with_wrap(mut self, wrap: Wrap) -> Self {
        self.wrap = wrap;
        self
    }

    /// The texture, borrowed, as the library draws it.
    ///
    /// # Panics
    /// Never: the sizes were checked when the texture was made.
    pub fn texture(&self) -> Texture<'_> {
        let texture = Texture::new(self.width, self.height, &self.texels);
        texture.expect("the packer checks sizes").with_wrap(self.wrap)
    }

    /// Bytes that the texels take in flash.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.texels)
    }
}

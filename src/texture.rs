//! Stage 1. Borrowed textures: RGB565 texels, power-of-two sizes.

/// Largest width and height of a texture.
pub const MAX_TEXTURE_SIZE: u16 = 1024;

/// An image borrowed from flash: RGB565 texels in rows from the top, its sizes powers of two.
///
/// Texel (i, j) covers the texture coordinates from i to i + 1 and from j to j + 1, so a texture is sampled by
/// rounding down.
///
/// ```
/// use topleft::{Texture, TextureError, Wrap};
///
/// static CHECKER: [u16; 4] = [0xFFFF, 0x0000, 0x0000, 0xFFFF];
/// let texture = Texture::new(2, 2, &CHECKER).unwrap().with_wrap(Wrap::Clamp);
/// assert_eq!(texture.texel(1, 0), 0x0000);
/// assert_eq!(texture.texel(7, -3), 0x0000); // clamped to the top right texel
/// assert_eq!(texture.with_wrap(Wrap::Repeat).texel(-2, 4), 0xFFFF);
/// assert_eq!(Texture::new(3, 2, &CHECKER).unwrap_err(), TextureError::Size(3));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Texture<'a> {
    texels: &'a [u16],
    width_log2: u8,
    height_log2: u8,
    wrap: Wrap,
}

/// What a texture shows beyond its edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The texture again.
    #[default]
    Repeat,
    /// Its outermost texels.
    Clamp,
}

/// Why texels do not make a [`Texture`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextureError {
    /// A width or height that is not a power of two from 1 to [`MAX_TEXTURE_SIZE`].
    Size(u16),
    /// Not one texel for each place.
    LengthMismatch {
        /// Texels given.
        given: usize,
        /// Texels needed.
        needed: usize,
    },
}

impl core::fmt::Display for TextureError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Size(size) => write!(f, "a size of {size}, not a power of two up to {MAX_TEXTURE_SIZE}"),
            Self::LengthMismatch { given, needed } => write!(f, "{given} texels, {needed} needed"),
        }
    }
}

impl core::error::Error for TextureError {}

impl<'a> Texture<'a> {
    /// One white texel.
    pub const WHITE: Self = Self { texels: &[0xFFFF], width_log2: 0, height_log2: 0, wrap: Wrap::Repeat };

    /// A texture of `width` times `height` texels in rows from the top. It repeats beyond its edges.
    ///
    /// # Errors
    /// A size that is not a power of two or above [`MAX_TEXTURE_SIZE`], or not as many texels as places.
    pub const fn new(width: u16, height: u16, texels: &'a [u16]) -> Result<Self, TextureError> {
        if !width.is_power_of_two() || width > MAX_TEXTURE_SIZE {
            return Err(TextureError::Size(width));
        }
        if !height.is_power_of_two() || height > MAX_TEXTURE_SIZE {
            return Err(TextureError::Size(height));
        }
        let needed = width as usize * height as usize;
        if texels.len() != needed {
            return Err(TextureError::LengthMismatch { given: texels.len(), needed });
        }
        Ok(Self {
            texels,
            width_log2: width.trailing_zeros() as u8,
            height_log2: height.trailing_zeros() as u8,
            wrap: Wrap::Repeat,
        })
    }

    /// The same texture, with another behaviour beyond its edges.
    #[must_use]
    pub const fn with_wrap(mut self, wrap: Wrap) -> Self {
        self.wrap = wrap;
        self
    }

    /// Whether it is the same image: no texel is looked at.
    pub(crate) fn is(&self, other: &Self) -> bool {
        core::ptr::eq(self.texels, other.texels)
            && self.sizes_log2() == other.sizes_log2()
            && self.wrap == other.wrap
    }

    /// The powers of two that width and height are.
    pub(crate) const fn sizes_log2(&self) -> [u8; 2] {
        [self.width_log2, self.height_log2]
    }

    /// Texels in a row.
    pub const fn width(&self) -> u16 {
        1 << self.width_log2
    }

    /// Rows of texels.
    pub const fn height(&self) -> u16 {
        1 << self.height_log2
    }

    /// What the texture shows beyond its edges.
    pub const fn wrap(&self) -> Wrap {
        self.wrap
    }

    /// All texels, in rows from the top.
    pub const fn texels(&self) -> &'a [u16] {
        self.texels
    }

    /// The RGB565 texel in column `u` and row `v`, wrapped or clamped when outside.
    #[inline]
    pub const fn texel(&self, u: i32, v: i32) -> u16 {
        match self.wrap {
            Wrap::Repeat => self.repeated(u, v),
            Wrap::Clamp => self.clamped(u, v),
        }
    }

    /// The texel in a column and row, the texture repeated.
    #[inline(always)]
    pub(crate) const fn repeated(&self, u: i32, v: i32) -> u16 {
        self.fetch(repeat(u, self.width_log2) | repeat(v, self.height_log2) << self.width_log2)
    }

    /// The texel in a column and row, or the outermost one on that side.
    #[inline(always)]
    pub(crate) const fn clamped(&self, u: i32, v: i32) -> u16 {
        self.fetch(clamp(u, self.width_log2) | clamp(v, self.height_log2) << self.width_log2)
    }

    /// The texel at an index below width x height.
    #[inline]
    const fn fetch(&self, index: usize) -> u16 {
        // The length was checked once, but only a mask per fetch could show the compiler so: a comparison is no dearer.
        if index < self.texels.len() { self.texels[index] } else { 0 }
    }
}

#[inline]
const fn repeat(texel: i32, log2: u8) -> usize {
    (texel as u32 & ((1 << log2) - 1)) as usize
}

#[inline]
const fn clamp(texel: i32, log2: u8) -> usize {
    let last = (1 << log2) - 1;
    if texel < 0 {
        0
    } else if texel > last {
        last as usize
    } else {
        texel as usize
    }
}

//! What a strip's cells hold: any RGB colour of embedded-graphics, or the bare 16 bits of RGB565.

use embedded_graphics_core::pixelcolor::raw::RawU16;
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};
use embedded_graphics_core::prelude::RawData;

use crate::math::format::Attribute;
use crate::varying::Varying;

/// A colour of a cell.
///
/// Implemented for the RGB and BGR colours of embedded-graphics, and for `u16` as RGB565, which a DMA channel can send
/// as it is. [`Rgb565`] and `u16` are the fast ones: textures hold their bits.
pub trait Pixel: Copy {
    /// The greatest red, green and blue.
    const MAX: [u8; 3];

    /// From channels of 0 to [`MAX`](Self::MAX).
    fn from_channels(channels: [u8; 3]) -> Self;

    /// The channels, 0 to [`MAX`](Self::MAX).
    fn channels(self) -> [u8; 3];

    /// From the bits of a texel.
    fn from_texel(rgb565: u16) -> Self;

    /// Channels on their way along a row: `[Attribute; 3]`, or what is stepped faster.
    type Stepped: Stepped<Self>;

    /// The words of cells that are RGB565 words, one for each, for a [`Kernel`](crate::stages::Kernel). `u16` has them: of its
    /// own type, a colour has none.
    #[inline(always)]
    fn words(cells: &mut [Self]) -> Option<&mut [u16]> {
        let _ = cells;
        None
    }

    /// The word of one such cell.
    #[inline(always)]
    fn word(self) -> Option<u16> {
        None
    }

    /// From channels of 0 to 255, each rounded to the nearest.
    #[inline]
    fn from_rgb(rgb: [u8; 3]) -> Self {
        let [r, g, b] = rgb;
        let [max_r, max_g, max_b] = Self::MAX;
        let nearest = |c: u8, max: u8| scaled(c, u32::from(max), 255);
        Self::from_channels([nearest(r, max_r), nearest(g, max_g), nearest(b, max_b)])
    }

    /// A texel under light of 0 to 64, dark to full, each channel rounded to the nearest.
    #[inline]
    fn lit_texel(rgb565: u16, light: u32) -> Self {
        Self::from_texel(lit(rgb565, light))
    }
}

/// The channels of a colour as they are interpolated along a row: stepped by sums.
///
/// `[Attribute; 3]` is one for every [`Pixel`], and `u64` holds the three channels of RGB565 in one sum.
///
/// ```
/// use topleft::Attribute;
/// use topleft::stages::Stepped;
///
/// let channels = |r, g, b| [r, g, b].map(|channel| Attribute::from_bits(channel << 16));
/// let start: u64 = Stepped::<u16>::new(channels(1, 2, 3));
/// let step = Stepped::<u16>::new(channels(1, 0, -2));
/// assert_eq!(Stepped::<u16>::colour(Stepped::<u16>::plus(start, step)), 2 << 11 | 2 << 5 | 1);
/// ```
pub trait Stepped<P>: Copy {
    /// Of red, green and blue from 0 to [`MAX`](Pixel::MAX) with 16 fraction bits, or of their step.
    fn new(channels: [Attribute; 3]) -> Self;

    /// A step further. No channel leaves its range on the way.
    #[must_use]
    fn plus(self, step: Self) -> Self;

    /// The colour, each channel rounded down.
    fn colour(self) -> P;
}

impl<P: Pixel> Stepped<P> for [Attribute; 3] {
    #[inline(always)]
    fn new(channels: [Attribute; 3]) -> Self {
        channels
    }

    #[inline(always)]
    fn plus(self, step: Self) -> Self {
        Varying::plus(self, step)
    }

    #[inline(always)]
    fn colour(self) -> P {
        let [r, g, b] = self;
        let whole = |channel: Attribute| (channel.to_bits() >> 16) as u8;
        P::from_channels([whole(r), whole(g), whole(b)])
    }
}

/// All three channels of RGB565 in one sum, with 16 fraction bits each: 5 + 16, 6 + 16 and 5 + 16 bits are 64. In the
/// high word green is where a pixel has it.
impl Stepped<u16> for u64 {
    #[inline(always)]
    fn new([r, g, b]: [Attribute; 3]) -> Self {
        let bits = |channel: Attribute| i64::from(channel.to_bits());
        (bits(r) << 43).wrapping_add(bits(g) << 21).wrapping_add(bits(b)).cast_unsigned()
    }

    #[inline(always)]
    fn plus(self, step: Self) -> Self {
        self.wrapping_add(step)
    }

    #[inline(always)]
    fn colour(self) -> u16 {
        let (low, high) = (self as u32, (self >> 32) as u32);
        (high >> 27 << 11 | high & 0x07E0 | low << 11 >> 27) as u16
    }
}

impl Stepped<Rgb565> for u64 {
    #[inline(always)]
    fn new(channels: [Attribute; 3]) -> Self {
        <Self as Stepped<u16>>::new(channels)
    }

    #[inline(always)]
    fn plus(self, step: Self) -> Self {
        <Self as Stepped<u16>>::plus(self, step)
    }

    #[inline(always)]
    fn colour(self) -> Rgb565 {
        Rgb565::from_texel(<Self as Stepped<u16>>::colour(self))
    }
}

/// `channel * max / from`, rounded to nearest.
#[inline]
fn scaled(channel: u8, max: u32, from: u32) -> u8 {
    ((u32::from(channel) * max * 2 + from) / (from * 2)) as u8
}

/// Red and blue in one product, five bits of room above each; green in another.
#[inline(always)]
fn lit(rgb565: u16, light: u32) -> u16 {
    const RED_BLUE: u32 = 0xF81F;
    const GREEN: u32 = 0x07E0;
    let texel = u32::from(rgb565);
    let red_blue = ((texel & RED_BLUE) * light + 0x1_0020) >> 6 & RED_BLUE;
    let green = ((texel & GREEN) * light + 0x0400) >> 6 & GREEN;
    (red_blue | green) as u16
}

/// The colours of embedded-graphics that differ only in their channels' order and width.
macro_rules! colours {
    ($($colour:ident),*) => {$(
        impl Pixel for $colour {
            const MAX: [u8; 3] = [Self::MAX_R, Self::MAX_G, Self::MAX_B];

            type Stepped = [Attribute; 3];

            #[inline]
            fn from_channels([r, g, b]: [u8; 3]) -> Self {
                Self::new(r, g, b)
            }

            #[inline]
            fn channels(self) -> [u8; 3] {
                [self.r(), self.g(), self.b()]
            }

            #[inline]
            fn from_texel(rgb565: u16) -> Self {
                let [r, g, b] = Rgb565::from_texel(rgb565).channels();
                Self::new(
                    scaled(r, u32::from(Self::MAX_R), 31),
                    scaled(g, u32::from(Self::MAX_G), 63),
                    scaled(b, u32::from(Self::MAX_B), 31),
                )
            }
        }
    )*};
}

colours!(Rgb555, Rgb666, Rgb888, Bgr555, Bgr565, Bgr666, Bgr888);

impl Pixel for Rgb565 {
    const MAX: [u8; 3] = [Self::MAX_R, Self::MAX_G, Self::MAX_B];

    type Stepped = u64;

    #[inline]
    fn from_rgb(rgb: [u8; 3]) -> Self {
        Self::from_texel(u16::from_rgb(rgb))
    }

    #[inline(always)]
    fn from_channels(channels: [u8; 3]) -> Self {
        Self::from_texel(u16::from_channels(channels))
    }

    #[inline]
    fn channels(self) -> [u8; 3] {
        [self.r(), self.g(), self.b()]
    }

    #[inline(always)]
    fn from_texel(rgb565: u16) -> Self {
        Self::from(RawU16::from_u32(u32::from(rgb565)))
    }
}

/// RGB565 in the chip's own byte order: a display that takes 16 bits at a time gets red first.
impl Pixel for u16 {
    const MAX: [u8; 3] = Rgb565::MAX;
    type Stepped = u64;

    /// The nearest, without a division: the same for all 256 values.
    #[inline]
    fn from_rgb([r, g, b]: [u8; 3]) -> Self {
        let five = |c: u8| (u32::from(c) * 249 + 1014) >> 11;
        let six = |c: u8| (u32::from(c) * 253 + 505) >> 10;
        (five(r) << 11 | six(g) << 5 | five(b)) as Self
    }

    #[inline(always)]
    fn from_channels([r, g, b]: [u8; 3]) -> Self {
        Self::from(r & 31) << 11 | Self::from(g & 63) << 5 | Self::from(b & 31)
    }

    #[inline]
    fn channels(self) -> [u8; 3] {
        [(self >> 11) as u8, (self >> 5 & 63) as u8, (self & 31) as u8]
    }

    #[inline(always)]
    fn from_texel(rgb565: u16) -> Self {
        rgb565
    }

    #[inline(always)]
    fn words(cells: &mut [Self]) -> Option<&mut [u16]> {
        Some(cells)
    }

    #[inline(always)]
    fn word(self) -> Option<Self> {
        Some(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_scales_each_channel_to_the_nearest() {
        for light in 0..=64 {
            for value in 0..64_u8 {
                let nearest = |max: u8| ((u32::from(value.min(max)) * light + 32) / 64) as u8;
                let texel = u16::from_channels([value.min(31), value, value.min(31)]);
                assert_eq!(u16::lit_texel(texel, light).channels(), [nearest(31), nearest(63), nearest(31)]);
            }
        }
    }

    #[test]
    fn words_are_made_of_the_nearest_channels() {
        for c in 0..=255 {
            let nearest = |max: u8| scaled(c, u32::from(max), 255);
            assert_eq!(u16::from_rgb([c; 3]).channels(), [nearest(31), nearest(63), nearest(31)], "{c}");
        }
    }

    #[test]
    fn all_colours_agree_on_a_colour() {
        for rgb in [[0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 255, 0], [0, 0, 255], [130, 70, 200]] {
            let expected = |max: u8| rgb.map(|c| ((f64::from(c) * f64::from(max) / 255.0).round()) as u8);
            assert_eq!(Rgb888::from_rgb(rgb).channels(), rgb);
            assert_eq!(Bgr666::from_rgb(rgb).channels(), expected(63));
            assert_eq!(Rgb555::from_rgb(rgb).channels(), expected(31));
            let [r, g, b] = Rgb565::from_rgb(rgb).channels();
            assert_eq!([r, g, b], [expected(31)[0], expected(63)[1], expected(31)[2]]);
            assert_eq!(u16::from_rgb(rgb), Rgb565::from_rgb(rgb).into_storage());
        }
    }

    use embedded_graphics_core::pixelcolor::IntoStorage;
}

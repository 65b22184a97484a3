//! The part of a target that is drawn to, and the guard rectangle round it.

use embedded_graphics_core::geometry::Size;

use crate::math::format::{Clip, SUBPIXEL_BITS};

/// Widest margin between the viewport and the guard rectangle, in pixels.
const MAX_MARGIN: u32 = 1024;
/// Largest guard rectangle in pixels: edge values of a larger one do not fit an `i32`.
const MAX_AREA: u32 = 1 << 23;
/// Widest guard rectangle: edge products stay below 2^30.
const MAX_WIDTH: u32 = 8191;
/// Highest guard rectangle: a row count times a remainder stays below 2^32.
const MAX_HEIGHT: u32 = 4095;

/// The size of what is drawn to, and the guard rectangle that follows from it.
///
/// Triangles are clipped in x and y only where they leave the guard rectangle: the viewport and a margin of `m` pixels
/// all round, `m` the largest up to 1024 with `(W + 2m)(H + 2m) < 2^23`. So the exact integer edge values never
/// overflow, and hardly any triangle is clipped there.
///
/// ```
/// use embedded_graphics_core::geometry::Size;
/// use topleft::Viewport;
///
/// let viewport = Viewport::new(Size::new(240, 240)).unwrap();
/// assert_eq!(viewport.margin(), 1024);
/// assert!(Viewport::new(Size::new(4000, 4000)).is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    width: u16,
    height: u16,
    margin: u16,
}

/// The target is too large: no margin is left that keeps edge values exact. Carries its size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge(pub Size);

impl core::fmt::Display for TooLarge {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self(Size { width, height }) = self;
        write!(f, "a target of {width}x{height} pixels is too large")
    }
}

impl core::error::Error for TooLarge {}

impl Viewport {
    /// The viewport of a target of `size` pixels. It may be empty.
    ///
    /// # Errors
    /// More than about 2^23 pixels, more than 8190 columns or more than 4094 rows.
    pub const fn new(size: Size) -> Result<Self, TooLarge> {
        let Size { width, height } = size;
        // One pixel is kept for the rounding of vertices on the guard rectangle itself.
        if width >= MAX_WIDTH || height >= MAX_HEIGHT || (width + 1) * (height + 1) >= MAX_AREA {
            return Err(TooLarge(size));
        }
        let (mut low, mut high) = (0, MAX_MARGIN);
        while low < high {
            let margin = (low + high).div_ceil(2);
            let (w, h) = (width + 2 * margin + 1, height + 2 * margin + 1);
            if w <= MAX_WIDTH && h <= MAX_HEIGHT && w * h < MAX_AREA {
                low = margin;
            } else {
                high = margin - 1;
            }
        }
        Ok(Self { width: width as u16, height: height as u16, margin: low as u16 })
    }

    /// As much of a target from its top left as a viewport can hold.
    pub(crate) fn largest(Size { width, height }: Size) -> Self {
        let width = width.min(MAX_WIDTH - 1);
        let height = height.min(MAX_HEIGHT - 1).min((MAX_AREA - 1) / (width + 1) - 1);
        // It fits by what was just computed; an empty one draws nothing.
        Self::new(Size::new(width, height)).unwrap_or(Self { width: 0, height: 0, margin: 0 })
    }

    /// Width and height in pixels.
    pub const fn size(&self) -> Size {
        Size::new(self.width as u32, self.height as u32)
    }

    /// Width in pixels.
    pub(crate) const fn width(&self) -> i32 {
        self.width as i32
    }

    /// Height in pixels.
    pub(crate) const fn height(&self) -> i32 {
        self.height as i32
    }

    /// Pixels between the viewport and the guard rectangle on each side.
    pub const fn margin(&self) -> u16 {
        self.margin
    }

    /// The guard rectangle's least and greatest coordinate on an axis of `length` pixels, in steps of 1/256 px.
    pub(crate) const fn guard(&self, length: i32) -> (Clip, Clip) {
        let margin = (self.margin as i32) << SUBPIXEL_BITS;
        (-margin, (length << SUBPIXEL_BITS) + margin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_margin_is_the_largest_that_fits() {
        for (w, h) in
            [(0, 0), (1, 1), (240, 240), (1280, 720), (1920, 1080), (2890, 2890), (8190, 1), (1, 4094)]
        {
            let viewport = Viewport::new(Size::new(w, h)).unwrap();
            let fits = |m: u32| {
                let (w, h) = (w + 2 * m + 1, h + 2 * m + 1);
                w <= MAX_WIDTH && h <= MAX_HEIGHT && w * h < MAX_AREA
            };
            let margin = u32::from(viewport.margin());
            assert!(fits(margin), "{w}x{h}");
            assert!(margin == MAX_MARGIN || !fits(margin + 1), "{w}x{h}");
        }
        for ((w, h), fits) in
            [((100, 5000), (100, 4094)), ((4096, 2160), (4096, 2046)), ((9000, 9), (8190, 9))]
        {
            let (w, h) = (Viewport::largest(Size::new(w, h)).size(), fits);
            assert_eq!((w.width, w.height), h);
        }
        for (w, h) in [(8191, 1), (1, 4095), (2896, 2896), (u32::MAX, u32::MAX)] {
            assert_eq!(Viewport::new(Size::new(w, h)), Err(TooLarge(Size::new(w, h))));
        }
    }
}

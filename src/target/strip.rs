//! Some rows of a frame in memory: colours, and depths if there are any. A whole frame is one tall strip.

use core::convert::Infallible;
use core::ops::Range;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::depth::{Depth, Depth16, DepthFloat, NoDepth, Painter};
use crate::fill::fill;
use crate::gradients::Plane;
use crate::pipeline::{Shading, Surface};
use crate::pixel::Pixel;
use crate::raster::{self, Kernel, Sides, Span, Window};
use crate::retained::Retained;
use crate::run::Run;
use crate::shade::PixelShader;

/// Some rows of a frame: borrowed colours, and depths for a strip that has them.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb565;
/// use topleft::{Strip, StripError};
///
/// let mut colours = [Rgb565::new(0, 0, 0); 240 * 16];
/// let mut depths = [0; 240 * 16];
/// let strip = Strip::new(240, &mut colours).unwrap().with_depth(&mut depths).unwrap();
/// assert_eq!(strip.height(), 16);
///
/// let mut few = [0_u16; 100];
/// assert_eq!(Strip::new(240, &mut few).unwrap_err(), StripError::Short { given: 100, needed: 240 });
/// ```
#[derive(Debug)]
pub struct Strip<'s, P, D: Depth> {
    colours: &'s mut [P],
    depths: D::Plane<'s>,
    width: u16,
    height: u16,
    background: P,
}

/// Why slices do not make a [`Strip`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StripError {
    /// Not one cell for each pixel: of one row, for colours; of as many rows as there are colours for, for depths.
    Short {
        /// Cells given.
        given: usize,
        /// Cells needed.
        needed: usize,
    },
}

impl core::fmt::Display for StripError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self::Short { given, needed } = self;
        write!(f, "{given} cells for a strip, {needed} needed")
    }
}

impl core::error::Error for StripError {}

impl<'s, P: Pixel> Strip<'s, P, NoDepth> {
    /// A strip of as many whole rows of `width` pixels as there are colours for, without depth, with a black
    /// background. It starts at the frame's first row. The colours keep what they show until it is cleared.
    ///
    /// # Errors
    /// Fewer colours than one row. (A width of zero makes an empty strip.)
    pub fn new(width: u16, colours: &'s mut [P]) -> Result<Self, StripError> {
        let row = usize::from(width);
        let height = colours.len().checked_div(row).unwrap_or_default().min(usize::from(u16::MAX)) as u16;
        if height == 0 && width != 0 {
            return Err(StripError::Short { given: colours.len(), needed: row });
        }
        Ok(Self { colours, depths: (), width, height, background: P::from_channels([0; 3]) })
    }

    /// The same strip with a depth for each pixel, as [`Depth16`].
    ///
    /// # Errors
    /// Fewer depths than pixels.
    pub fn with_depth(self, depths: &'s mut [u16]) -> Result<Strip<'s, P, Depth16>, StripError> {
        self.with(depths)
    }

    /// The same strip with a depth for each pixel, as [`DepthFloat`].
    ///
    /// # Errors
    /// Fewer depths than pixels.
    pub fn with_depth_float(self, depths: &'s mut [u16]) -> Result<Strip<'s, P, DepthFloat>, StripError> {
        self.with(depths)
    }

    fn with<D: Depth<Plane<'s> = &'s mut [u16]>>(
        self,
        depths: &'s mut [u16],
    ) -> Result<Strip<'s, P, D>, StripError> {
        let Self { colours, width, height, background, .. } = self;
        let needed = usize::from(width) * usize::from(height);
        if depths.len() < needed {
            return Err(StripError::Short { given: depths.len(), needed });
        }
        Ok(Strip { colours, depths, width, height, background })
    }

    /// The same strip for lists that are [sorted](crate::DrawList::sort).
    pub fn for_painter(self) -> Strip<'s, P, Painter> {
        let Self { colours, width, height, background, .. } = self;
        Strip { colours, depths: (), width, height, background }
    }
}

impl<P: Copy, D: Depth> Strip<'_, P, D> {
    /// Sets the colour that the strip is cleared to.
    #[must_use]
    pub fn with_background(mut self, background: P) -> Self {
        self.background = background;
        self
    }

    /// Pixels in a row.
    pub const fn width(&self) -> u16 {
        self.width
    }

    /// Rows.
    pub const fn height(&self) -> u16 {
        self.height
    }

    /// The background everywhere, infinitely far away.
    pub fn clear(&mut self)
    where
        P: Pixel,
    {
        let background = self.background;
        if let (Some(words), Some(word)) = (P::words(self.colours), background.word()) {
            fill(words, word);
        } else {
            // A loop that may be unrolled, as this run is long.
            let (fours, rest) = self.colours.as_chunks_mut::<4>();
            for four in fours {
                *four = [background; 4];
            }
            Run::new(rest).fill(background);
        }
        D::clear(&mut self.depths);
    }

    /// The colours, row by row from the top.
    pub fn colours(&self) -> &[P] {
        self.colours
    }

    /// The strip's part of some rows and columns of the frame. Its first row shows row `top` of the frame.
    pub(crate) fn rows<'r>(&'r mut self, top: i32, rows: Range<i32>, columns: Range<i32>) -> Rows<'r, P, D> {
        let (width, height) = (i32::from(self.width), i32::from(self.height));
        Rows {
            cells: Cells {
                colours: self.colours,
                depths: D::reborrow(&mut self.depths),
                width,
                origin: top.wrapping_mul(width).wrapping_neg(),
            },
            window: Window {
                columns: columns.start.max(0)..columns.end.min(width),
                rows: rows.start.max(top)..rows.end.min(top.saturating_add(height)),
            },
            retained: Retained::NOTHING,
        }
    }
}

/// A strip while some of its rows are drawn to.
pub(crate) struct Rows<'r, P, D: Depth> {
    /// The pixels that may be drawn.
    pub(crate) window: Window,
    /// What triangles are set up to that go on above or below.
    pub(crate) retained: Retained<'r>,
    cells: Cells<'r, P, D>,
}

impl<'r, P, D: Depth> Rows<'r, P, D> {
    /// For one triangle. Its cells go from hand to hand by value: behind a pointer, each row would look up where they are.
    #[inline(always)]
    pub(crate) fn lend(&mut self) -> (&Window, &mut Retained<'r>, Cells<'_, P, D>) {
        let Self { window, retained, cells: Cells { colours, depths, width, origin } } = self;
        (window, retained, Cells { colours, depths: D::reborrow(depths), width: *width, origin: *origin })
    }
}

/// Whether a row is opaque where there is depth: the compiler would step two products of it from row to row, in registers that
/// the loop over pixels needs on ARM cores of 32 bits. Others have enough.
const FEW_REGISTERS: bool = cfg!(target_arch = "arm");

/// The cells of a strip.
pub(crate) struct Cells<'r, P, D: Depth> {
    colours: &'r mut [P],
    depths: D::Plane<'r>,
    width: i32,
    /// The cell of column 0 and row 0 of the frame, which may lie before the strip.
    origin: i32,
}

impl<P: Copy, D: Depth> Surface<P, D> for Cells<'_, P, D> {
    type Error = Infallible;

    const KERNELS: bool = D::KERNELS;

    #[inline(always)]
    fn span<'a, S: PixelShader<'a, P>>(
        &mut self,
        span: Span,
        depth: &Plane<D::Varying>,
        shading: &Shading<'a, P, S>,
    ) -> Result<(), Infallible> {
        let Self { colours, depths, width, origin } = self;
        // The window lies inside the strip: cells are at least zero here.
        let y = if D::ALWAYS_VISIBLE || !FEW_REGISTERS { span.y } else { core::hint::black_box(span.y) };
        let row = y.wrapping_mul(*width).wrapping_add(*origin);
        let (first, length) = ((row + span.start) as usize, (span.end - span.start) as usize);
        let Some((colours, depths)) = D::span(colours, depths, first, length) else { return Ok(()) };
        let run = Run::<P, D> { colours, depths, depth: depth.at(span.start, y), step: depth.dx };
        shading.shade(span.start, y, run);
        Ok(())
    }

    #[inline(always)]
    fn rows<'a, K: Kernel, S: PixelShader<'a, P>>(
        &mut self,
        sides: Sides<'_>,
        depth: &Plane<D::Varying>,
        shading: &Shading<'a, P, S>,
    ) -> bool {
        let Self { colours, depths, width, origin } = self;
        // As in `span`; and what does not fit as a whole is drawn span by span.
        let first = sides.top().wrapping_mul(*width).wrapping_add(*origin) as usize;
        let length = sides.height().wrapping_mul(*width) as usize;
        let Some((colours, depths)) = D::span(colours, depths, first, length) else { return false };
        let Some(shaded) = shading.for_kernel(sides.top(), colours) else { return false };
        let depth = depth.starting_in_row(sides.top());
        let Some(tested) = D::for_kernel(depths, depth) else { return false };
        // Inlined for each shader, so that it links its own kernel and no other.
        let Some(rows) = raster::Rows::new(&sides, *width, shaded, tested) else { return false };
        K::draw(rows)
    }
}

impl<P: Copy, D: Depth> Strip<'_, P, D> {
    /// Sends the first `columns` and `rows` of the strip to a target, to row `top` of a frame at `origin`: one
    /// `fill_contiguous`.
    pub(crate) fn send<T>(
        &self,
        origin: Point,
        top: i32,
        [columns, rows]: [u32; 2],
        target: &mut T,
    ) -> Result<(), T::Error>
    where
        T: DrawTarget,
        T::Color: From<P>,
    {
        let area =
            Rectangle::new(Point::new(origin.x, origin.y.saturating_add(top)), Size::new(columns, rows));
        let row = usize::from(self.width).max(1);
        let colours = self.colours.chunks(row).take(rows as usize);
        let colours = colours.flat_map(|row| row.iter().take(columns as usize));
        target.fill_contiguous(&area, colours.map(|&colour| T::Color::from(colour)))
    }
}

//! Whole triangles for a chip's own code.
//!
//! From here on, stages are one loop over rows and one over pixels. A [`Kernel`] takes the place of both, where it knows the
//! pixels, the depths and the shader: it may be faster, and nothing else. What it does not know is drawn by the stages.

use core::convert::Infallible;
use core::ops::Range;

use super::Span;
use super::edge::ShortEdge;
use super::small_triangle::{FoundSides, SmallTriangle};
use super::trapezoids::Trapezoids;
use crate::gradients::Plane;
use crate::math::format::{Attribute, DepthCode};
use crate::math::recip;
use crate::texture::Texture;

/// A chip's own way to draw small triangles, less than 32 px wide and high and inside of the strip: a type parameter of
/// [`SpansBy`](crate::SpansBy).
///
/// ```
/// use embedded_graphics_core::geometry::Size;
/// use topleft::stages::{FlatPixel, Kernel, Rows, Shade, Tested};
/// use topleft::{Cull, DrawList, ListStorage, NoDepth, ProjectedVertex, SpansBy, Strip, point};
///
/// /// Fills rows of one colour.
/// enum Fill {}
///
/// impl Kernel for Fill {
///     fn draw(rows: Rows<'_>) -> bool {
///         let (Shade::Flat(colour), Tested::Never) = (rows.shade(), rows.tested()) else { return false };
///         let (mut spans, mut count) = ([(0, 0); 32], 0);
///         rows.spans(|span| {
///             spans[count] = (span.y * 16 + span.start, span.y * 16 + span.end);
///             count += 1;
///         });
///         let (colours, _) = rows.into_cells();
///         for (start, end) in &spans[..count] {
///             colours[*start as usize..*end as usize].fill(colour ^ 1); // so that it shows
///         }
///         true
///     }
/// }
///
/// let (mut storage, mut colours) = (ListStorage::<6, 1>::new(), [0; 16 * 16]);
/// let mut list: DrawList<u16, NoDepth, SpansBy<Fill>> = storage.list_with_traversal();
/// list.set_cull(Cull::None);
/// let corners = [(2.0, 2.0), (10.0, 2.0), (2.0, 10.0)].map(|(x, y)| ProjectedVertex::new(point(x, y), ()));
/// list.draw_projected(Size::new(16, 16), corners, &[[0, 1, 2]], &[[255; 3]], &FlatPixel)?;
/// list.render(0..16, &mut Strip::new(16, &mut colours)?);
/// assert_eq!(colours.iter().filter(|&&colour| colour == 0xFFFE).count(), 28);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub trait Kernel {
    /// Draws all rows of a triangle, or none of them: whether it did.
    fn draw(rows: Rows<'_>) -> bool;

    /// The sides of a triangle: those that [`SmallTriangle::sides`] finds, to the last bit.
    #[must_use]
    #[inline(always)]
    fn sides(triangle: SmallTriangle<'_>) -> FoundSides<'_> {
        triangle.sides()
    }
}

/// The sides of a triangle whose edges are short, and the columns that none of them leaves.
#[derive(Debug)]
pub struct Sides<'t> {
    pub(super) trapezoids: &'t Trapezoids<ShortEdge>,
    pub(super) columns: &'t Range<i32>,
}

impl Sides<'_> {
    /// The first row.
    #[inline(always)]
    pub(crate) const fn top(&self) -> i32 {
        self.trapezoids.top
    }

    /// How many rows there are.
    #[inline(always)]
    pub(crate) const fn height(&self) -> i32 {
        self.trapezoids.bottom - self.trapezoids.top
    }
}

/// What decides which pixels are visible. Planes wrap: at a pixel that is covered they are right, and anywhere else only modulo
/// 2^32.
#[derive(Clone, Copy, Debug)]
pub enum Tested {
    /// Nothing: all are.
    Never,
    /// [`Depth16`](crate::Depth16), by the plane from column 0 of the first row on: a pixel is visible where its whole part is
    /// greater than the cell, which is set to it then.
    Depth16(Plane<DepthCode>),
}

/// Where colours come from. Planes start in column 0 of the first row, and wrap: each value is right at a pixel that is covered,
/// and anywhere else only modulo 2^32.
#[derive(Clone, Copy, Debug)]
pub enum Shade<'a> {
    /// All pixels have one.
    Flat(u16),
    /// Red, green and blue in steps of RGB565, each rounded down.
    Gouraud(Plane<[Attribute; 3]>),
    /// A texture, and column and row of its texel, each rounded down: [`wrap`](Texture::wrap) says what becomes of those
    /// beyond it.
    Affine(Texture<'a>, Plane<[Attribute; 2]>),
    /// A texture, and what column and row of its texel are divided from at each pixel: as for `Affine`, then.
    Perspective(Texture<'a>, TexelsOverW),
}

/// 1/w and texels over w, of a triangle whose pixels take a reciprocal each.
///
/// At a pixel that is covered q = 1/w is from 2^30 up to 2^31, and u/w and v/w are from 0 up to 2^31: with x the 30 bits of q
/// below its highest one, at the top of 32, and r = `2^16 / (1 + x 2^-32)` as [`reciprocals`](Self::reciprocals) has it, the
/// column is `least[0] + (((u/w >> 15) * r) >> (31 - span_log2))`, and the row likewise: in 32 bits, without a sign.
///
/// Where a triangle has [two octaves](Self::one_octave), q may be from 2^29 on: all three are doubled then, without a sign. And u/w
/// and v/w may be some steps below 0, which count as 0.
#[derive(Clone, Copy, Debug)]
pub struct TexelsOverW {
    /// 1/w, u/w and v/w in 31 fraction bits, with u and v from 0 to 1 over the texels that the triangle spans.
    pub over_w: Plane<[i32; 3]>,
    /// Its least column and row, before wrapping or clamping.
    pub least: [i32; 2],
    /// The power of two of texels that it spans on either axis: 0 to 16.
    pub span_log2: u32,
    /// Whether 1/w is in [2^30, 2^31) at all pixels; if not, it is in [2^29, 2^31).
    pub one_octave: bool,
}

impl TexelsOverW {
    /// Lines that a reciprocal is read from, one for each 64th of x: where it begins at x = 0 in the high half of a word, and
    /// how much it falls in a 64th in the low.
    ///
    /// ```
    /// use topleft::stages::TexelsOverW;
    ///
    /// let q: u32 = 3 << 29; // 1.5 in 30 fraction bits
    /// let x = q << 2;
    /// let line = TexelsOverW::reciprocals()[(x >> 26) as usize];
    /// let reciprocal = (line - (line & 0xFFFF) * (x >> 10)) >> 16;
    /// assert_eq!(reciprocal, 43_691); // 2^16 / 1.5
    /// ```
    #[inline(always)]
    pub const fn reciprocals() -> &'static [u32; 64] {
        recip::lines()
    }
}

/// The rows of a triangle, and the cells that they lie in.
///
/// What a kernel may rely on: there are [`width`](Self::width) cells a row, and as many rows as the trapezoids have; in no row
/// is a side's column below 0, or above the width, and in none are they more than 32 apart. There are 1 to 32 rows.
#[derive(Debug)]
pub struct Rows<'r> {
    trapezoids: &'r Trapezoids<ShortEdge>,
    width: i32,
    colours: &'r mut [u16],
    depths: &'r mut [u16],
    tested: Tested,
    shade: Shade<'r>,
}

impl<'r> Rows<'r> {
    /// In cells from column 0 of the first row on, `width` a row. Nothing where they do not have all columns and rows.
    #[inline(always)]
    pub(crate) fn new(
        sides: &Sides<'r>,
        width: i32,
        (colours, shade): (&'r mut [u16], Shade<'r>),
        (depths, tested): (&'r mut [u16], Tested),
    ) -> Option<Self> {
        let Sides { trapezoids, columns } = *sides;
        let cells = sides.height().wrapping_mul(width) as usize;
        let tests = match tested {
            Tested::Never => 0,
            Tested::Depth16(_) => cells,
        };
        let inside =
            columns.start >= 0 && columns.end <= width && colours.len() == cells && depths.len() == tests;
        if inside { Some(Self { trapezoids, width, colours, depths, tested, shade }) } else { None }
    }

    /// Hands over the covered pixels of each row, from the top down, row 0 first: what the trapezoids say, for a kernel that
    /// does not read them.
    #[inline]
    pub fn spans(&self, mut draw: impl FnMut(Span)) {
        let top = self.trapezoids.top;
        let mut draw = |span: Span| {
            draw(Span { y: span.y - top, ..span });
            Ok(())
        };
        let Ok(()) = self.trapezoids.rows::<Infallible>(&(0..self.width), &mut draw);
    }

    /// The sides of all rows.
    #[inline(always)]
    pub const fn trapezoids(&self) -> &'r Trapezoids<ShortEdge> {
        self.trapezoids
    }

    /// Columns.
    #[inline(always)]
    pub const fn width(&self) -> usize {
        self.width as usize
    }

    /// Where colours come from.
    #[inline(always)]
    pub const fn shade(&self) -> Shade<'r> {
        self.shade
    }

    /// What decides which pixels are visible.
    #[inline(always)]
    pub const fn tested(&self) -> Tested {
        self.tested
    }

    /// The colours of all rows; and a depth for each, or none where nothing is tested.
    #[inline(always)]
    pub const fn into_cells(self) -> (&'r mut [u16], &'r mut [u16]) {
        (self.colours, self.depths)
    }
}

//! Out of the list: its triangles into some rows of a strip, and strip by strip to a display.

use core::cell::Cell;
use core::ops::Range;
use core::slice::Iter;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::prelude::PixelColor;

use super::{DrawList, Kept, ListTriangle, SIMPLE, Shaders};
use crate::attributes::Words;
use crate::depth::Depth;
use crate::pipeline::{self, Vertices};
use crate::pixel::Pixel;
use crate::raster::Traversal;
use crate::retained::Records;
use crate::setup::Setup;
use crate::shade::PixelShader;
use crate::snapped::Snapped;
use crate::target::{Rows, Strip};
use crate::transform::PerVertexInverse;

impl<P: Copy, D: Depth, T: Traversal> DrawList<'_, P, D, T> {
    /// Draws the list's triangles into some rows of the frame: the strip's first row is `rows.start` from now on.
    ///
    /// What the strip shows stays where no triangle is: clear it first. Triangles are drawn in the order they were
    /// given, or that [`sort`](DrawList::sort) put them in. Nothing is changed in the list, so several cores may render from it at once.
    pub fn render(&self, rows: Range<i32>, strip: &mut Strip<'_, P, D>) {
        let mut target = window(self.contents.size, rows, strip);
        let triangles = self.contents.triangles.get(..self.contents.used_triangles).unwrap_or_default();
        View { triangles, shaders: &self.shaders, words: self.contents.words }.render(&mut target);
    }

    /// Draws the same as [`render`](DrawList::render), in fewer cycles where strips come from the top of the frame down: a
    /// triangle that reaches into the next strip is not set up again there.
    ///
    /// Its planes are kept in the words that the list's vertices leave free: 3 for depth, and 3 for each channel of a colour,
    /// for u and for v, and for 1/w, for as many triangles as go through the last row of a strip and the first of the next.
    /// Where words run out, and where `rows` do not start where those of the last call ended, triangles are set up as by
    /// `render`: the bytes are always the same.
    ///
    /// ```
    /// use embedded_graphics_core::geometry::Size;
    /// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
    /// use topleft::{Flat, ListStorage, Mesh, Orthographic, Pose, Strip};
    ///
    /// let positions = [[-32767, -32767, 0], [32767, -32767, 0], [0, 32767, 0]];
    /// let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    /// let camera = Orthographic::new(Size::new(8, 8), 2.0, -1.0..1.0);
    ///
    /// // Three words for each of three vertices, and three more for a plane of depth.
    /// let mut storage = ListStorage::<12, 4>::new();
    /// let mut list = storage.list();
    /// list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED)).unwrap();
    ///
    /// let (mut colours, mut depths) = ([Rgb565::BLACK; 16], [0; 16]);
    /// let mut strip = Strip::new(8, &mut colours).unwrap().with_depth(&mut depths).unwrap();
    /// let mut red = Vec::new();
    /// for top in [0, 2, 4, 6] {
    ///     strip.clear();
    ///     list.render_next(top..top + 2, &mut strip);
    ///     red.push(strip.colours().iter().filter(|&&colour| colour == Rgb565::RED).count());
    /// }
    /// assert_eq!(red, [2, 6, 10, 14]);
    /// ```
    pub fn render_next(&mut self, rows: Range<i32>, strip: &mut Strip<'_, P, D>) {
        let mut target = window(self.contents.size, rows, strip);
        if target.window.rows.is_empty() {
            self.contents.records = Records::NONE;
            return;
        }
        let (vertices, free) =
            self.contents.words.split_at_mut_checked(self.contents.used_words).unwrap_or_default();
        let free = Cell::from_mut(free).as_slice_of_cells();
        target.retained = self.contents.records.start(free, &target.window.rows);
        let triangles = self.contents.triangles.get(..self.contents.used_triangles).unwrap_or_default();
        View { triangles, shaders: &self.shaders, words: vertices }.render(&mut target);
        self.contents.records.end(&target.retained);
    }

    /// Draws a whole frame to a display, strip by strip: each is cleared, rendered, and handed over by one
    /// `fill_contiguous`. The frame's top left is the top left of the target's bounding box.
    ///
    /// # Errors
    /// What the target returned.
    pub fn present<Target>(
        &mut self,
        strip: &mut Strip<'_, P, D>,
        target: &mut Target,
    ) -> Result<(), Target::Error>
    where
        P: Pixel,
        Target: DrawTarget,
        Target::Color: PixelColor + From<P>,
    {
        let area = target.bounding_box();
        let (width, height) = (strip.width(), strip.height());
        let columns = area.size.width.min(u32::from(width));
        let mut top = 0;
        while columns > 0 && height > 0 && top < area.size.height {
            let rows = u32::from(height).min(area.size.height - top);
            strip.clear();
            let first = top.min(i32::MAX.unsigned_abs()).cast_signed();
            self.render_next(first..first.saturating_add(i32::from(height)), strip);
            strip.send(area.top_left, first, [columns, rows], target)?;
            top += rows;
        }
        Ok(())
    }
}

/// Those rows of a frame that are in a strip, whose first is `rows.start`.
#[inline]
fn window<'r, P: Copy, D: Depth>(
    [width, height]: [i32; 2],
    rows: Range<i32>,
    strip: &'r mut Strip<'_, P, D>,
) -> Rows<'r, P, D> {
    strip.rows(rows.start, rows.start.max(0)..rows.end.min(height), 0..width)
}

/// What is rendered of a list.
struct View<'l, 'a, P, D: Depth> {
    triangles: &'l [ListTriangle],
    shaders: &'l Shaders<'a, P, D>,
    words: &'l [u32],
}

impl<P, D: Depth> View<'_, '_, P, D> {
    /// Draws those triangles that are in the window.
    fn render(&self, target: &mut Rows<'_, P, D>) {
        let mut rest = self.triangles.iter();
        while let Some(next) = rest.clone().next() {
            rest = self.render_alike(next.shader, rest, target);
        }
    }

    /// Draws those that are in the window, up to the first there with another shader: what is left from that one on.
    ///
    /// Apart, so that the search for triangles is a loop of few registers, which finds their shader before it.
    #[inline(never)]
    fn render_alike<'t>(
        &self,
        shader: u8,
        mut triangles: Iter<'t, ListTriangle>,
        target: &mut Rows<'_, P, D>,
    ) -> Iter<'t, ListTriangle> {
        let kept = self.shaders.get(usize::from(shader & !SIMPLE));
        let Some((kept, words)) = kept.and_then(|kept| Some((kept, self.words.get(kept.block.base()..)?)))
        else {
            return Iter::default();
        };
        let draw = kept.simple.filter(|_| shader & SIMPLE != 0).unwrap_or(kept.draw);
        let rows = target.window.rows.clone();
        loop {
            let here = triangles.clone();
            let Some(triangle) = triangles.next() else { return here };
            let [first, end] = triangle.rows;
            // Most triangles of a frame are in other strips.
            if i32::from(end) <= rows.start || i32::from(first) >= rows.end {
                continue;
            }
            if triangle.shader != shader {
                return here;
            }
            draw(kept, words, triangle, target);
        }
    }
}

/// Draws one triangle of a list: one such function is linked for each shader that is used. A vertex may have more words than it
/// looks at: those of a shader that this is the simpler one of.
pub(super) fn triangle<'a, P: Copy, D: Depth, T: Traversal, S: PixelShader<'a, P>>(
    kept: &Kept<'a, P, D>,
    words: &[u32],
    triangle: &ListTriangle,
    target: &mut Rows<'_, P, D>,
) {
    let [a, b, c] = triangle.vertices;
    let stride = kept.block.stride();
    let Some(a) = vertex::<P, D, S>(words, stride, a) else { return };
    let Some(b) = vertex::<P, D, S>(words, stride, b) else { return };
    let Some(c) = vertex::<P, D, S>(words, stride, c) else { return };
    let Some(setup) = Setup::sorted([a.at, b.at, c.at]) else { return };
    let vertices = Vertices {
        depths: [a.depth, b.depth, c.depth],
        inverses: [a.inverse, b.inverse, c.inverse],
        attributes: [a.attributes, b.attributes, c.attributes],
        colour: triangle.colour,
    };
    let shader = S::from_uniforms(&kept.uniforms);
    let (window, retained, cells) = target.lend();
    let retained = (retained, triangle.rows);
    let Ok(()) = pipeline::draw::<P, S, T, D, _, _>(&setup, shader, vertices, window, cells, retained);
}

/// A vertex of the list, as its words say.
struct Vertex<Z, A> {
    at: Snapped,
    depth: Z,
    inverse: PerVertexInverse,
    attributes: A,
}

/// Words of a vertex: x, y, and what depth, shader and perspective need.
pub(super) const fn stride<'a, P, D: Depth, S: PixelShader<'a, P>>() -> usize {
    const { assert!(D::Vertex::WORDS <= 1, "a vertex has one word of depth at most") };
    2 + D::Vertex::WORDS + S::PERSPECTIVE as usize + S::Vertex::WORDS
}

#[inline]
fn vertex<'a, P, D: Depth, S: PixelShader<'a, P>>(
    words: &[u32],
    stride: usize,
    vertex: u16,
) -> Option<Vertex<D::Varying, S::Vertex>> {
    let at = usize::from(vertex) * stride;
    let mut words = words.get(at..at + const { self::stride::<P, D, S>() })?.iter().copied();
    let (x, y) = (words.next()?.cast_signed(), words.next()?.cast_signed());
    let depth = D::varying(D::Vertex::load(&mut words)?);
    let (attributes, inverse) = carried::<P, S>(&mut words)?;
    Some(Vertex { at: Snapped::from_bits(x, y), depth, inverse, attributes })
}

/// What a vertex carries for its shader, and 1/w. That is the last word, so that a shader which needs none finds all others.
#[inline(always)]
pub(super) fn carried<'a, P, S: PixelShader<'a, P>>(
    words: &mut impl Iterator<Item = u32>,
) -> Option<(S::Vertex, PerVertexInverse)> {
    let attributes = S::Vertex::load(words)?;
    let inverse = if S::PERSPECTIVE { PerVertexInverse::load(words)? } else { PerVertexInverse::ONE };
    Some((attributes, inverse))
}

//! What a list holds, whatever its colours, its depth and its shaders are: so the code that fills it is linked once.

use core::num::NonZeroU32;
use core::slice::Iter;

use super::draw::Seen;
use super::drawing::Drawing;
use super::placed::{Placed, UNSEEN};
use super::{DrawError, ListTriangle, MAX_NAMED, Stats};
use crate::clip::{MOST_CORNERS, Outcode, Polygon, least};
use crate::math::format::Coord;
use crate::math::product;
use crate::retained::Records;
use crate::setup::{Cull, canonical, facing};
use crate::snapped::{Snapped, first_centre};
use crate::transform::Transform;

/// Vertices and triangles, and what becomes of those that come.
#[derive(Debug)]
pub(super) struct Contents<'a> {
    pub(super) words: &'a mut [u32],
    pub(super) used_words: usize,
    pub(super) triangles: &'a mut [ListTriangle],
    pub(super) used_triangles: usize,
    pub(super) cull: Cull,
    /// Columns and rows of the cameras' viewport.
    pub(super) size: [i32; 2],
    pub(super) stats: Stats,
    /// What triangles are set up to that go on below the last strip, in the words that are not used.
    pub(super) records: Records,
}

/// Keeps the shader of so many vertices, and says where.
type Keep<'k, 'a> = &'k mut dyn FnMut(&mut Contents<'a>, usize) -> Result<Home, DrawError>;

/// Where the shader of a draw is kept, and its vertices.
pub(super) struct Home {
    pub(super) kept: u8,
    /// The first word of the shader's vertices.
    pub(super) base: usize,
    /// Which of them is the draw's first.
    pub(super) first: usize,
}

impl<'a> Contents<'a> {
    /// Nothing, with room for as much as these hold.
    pub(super) const fn new(words: &'a mut [u32], triangles: &'a mut [ListTriangle]) -> Self {
        Self {
            words,
            used_words: 0,
            triangles,
            used_triangles: 0,
            cull: Cull::Back,
            size: [0; 2],
            stats: Stats { faces: 0, culled: 0, outside: 0, clipped: 0, drawn: 0 },
            records: Records::NONE,
        }
    }

    /// Adds a mesh if any of it can be seen: `keep` says where the shader of so many vertices is kept. Where there are no words
    /// for its own, as many are used as before.
    #[inline(never)]
    pub(super) fn place(&mut self, seen: &Seen<'_>, keep: Keep<'_, 'a>) -> Result<(), DrawError> {
        let &Seen { viewport, matrix, mesh, pose, shaded, layout } = seen;
        let viewport = viewport?;
        let transform = &Transform::new(viewport, matrix, mesh, pose);
        let (vertices, faces) = (mesh.positions().len(), mesh.faces().len());
        if faces == 0 || transform.misses(mesh.bounds()) {
            self.stats.faces += faces;
            self.stats.outside += faces;
            return Ok(());
        }
        let before = self.used_words;
        // With all of its faces cut.
        let Home { kept, base, first } = keep(self, vertices + MOST_CORNERS * faces)?;
        self.size = [viewport.width(), viewport.height()];
        self.stats.faces += faces;
        let placed = Placed { colours: shaded, stride: layout.stride, kept, base };
        let start = self.used_words;
        self.room(&placed, vertices, faces, before)?;
        let drawing = &Drawing { transform, mesh, shaded, layout, placed };
        let placed = &drawing.placed;
        drawing.vertices(self.words.get_mut(start..).unwrap_or_default());
        let mut left_out = LeftOut::default();
        let mut faces = Faces::new(first, mesh.faces());
        while let Some((corners, planes)) = self.faces(placed, &mut faces, &mut left_out) {
            self.stats.clipped += 1;
            let (first, corners) = self.clipped(drawing, corners, planes, &mut left_out);
            for second in 1..corners.saturating_sub(1) {
                let part = [[0, second as u16, second as u16 + 1]];
                // It crosses no plane.
                let mut part = Faces { first, corners: part.iter(), face: faces.face };
                self.faces(placed, &mut part, &mut left_out);
            }
            faces.face += 1;
        }
        left_out.result(self.free())
    }

    /// Goes on behind the vertices of a shader, whose first word is `base`, as long as as many more can be named: from which
    /// on.
    pub(super) fn follow(&mut self, base: usize, stride: usize, vertices: usize) -> Option<usize> {
        let named = self.named(base, stride);
        if named + vertices > MAX_NAMED {
            return None;
        }
        // Other shaders' vertices may lie between: the next ones start at a whole number of these.
        self.used_words = base + named * stride;
        Some(named)
    }

    /// Vertices of this stride from `base` to the last word in use, rounded up. Beyond 32 bits, as many as those can count.
    #[inline(never)]
    fn named(&self, base: usize, stride: usize) -> usize {
        let words = u32::try_from(self.used_words - base + stride - 1).unwrap_or(u32::MAX);
        let stride = NonZeroU32::new(stride as u32).unwrap_or(NonZeroU32::MIN);
        product::divided(words, stride).0 as usize
    }

    /// Takes words for the vertices of a draw. Where there are not as many, as many words are used as `before` the draw.
    pub(super) fn room(
        &mut self,
        placed: &Placed<'_>,
        vertices: usize,
        faces: usize,
        before: usize,
    ) -> Result<(), DrawError> {
        let words = vertices * placed.stride();
        if !self.reserve(words) {
            // Without padding.
            let missing = self.used_words + words - self.words.len();
            self.used_words = before;
            return Err(DrawError::Full { triangles: faces, words: missing });
        }
        Ok(())
    }

    /// Words that are not used.
    pub(super) fn free(&self) -> usize {
        self.words.len().saturating_sub(self.used_words)
    }

    /// Takes words for vertices, if there are as many.
    fn reserve(&mut self, words: usize) -> bool {
        let fits = words <= self.free();
        if fits {
            self.used_words += words;
        }
        fits
    }

    /// Adds faces, up to one that crosses planes: that is returned, and `faces` stays at it. Apart, so that meshes and fans
    /// share the loop.
    #[inline(never)]
    pub(super) fn faces(
        &mut self,
        placed: &Placed<'_>,
        faces: &mut Faces<'_>,
        left_out: &mut LeftOut,
    ) -> Option<([u16; 3], Outcode)> {
        let Faces { first, corners, face } = faces;
        let before = self.used_triangles;
        let mut crossing = None;
        // Counted here: in its place, each number would be written for each face.
        let mut at = *face;
        for &corners in corners.by_ref() {
            match self.face(placed, at, *first, corners) {
                Added::Done => {}
                Added::Full => left_out.triangles += 1,
                Added::Crossing(planes) => {
                    crossing = Some((corners, planes));
                    break;
                }
            }
            at += 1;
        }
        *face = at;
        self.stats.drawn += self.used_triangles - before;
        crossing
    }

    /// Adds a triangle of three vertices, counted from the `first`, unless it is outside, culled, or touches no pixel
    /// centre of the viewport.
    #[inline(always)]
    fn face(&mut self, placed: &Placed<'_>, face: usize, first: usize, [a, b, c]: [u16; 3]) -> Added {
        let Some(words) = self.words.get(placed.word(first)..) else { return Added::Done };
        let header = |corner: u16| header(words, usize::from(corner) * placed.stride());
        let Some(p) = header(a) else { return Added::Done };
        let Some(q) = header(b) else { return Added::Done };
        let Some(r) = header(c) else { return Added::Done };
        let ([px, py], [qx, qy], [rx, ry]) = (p, q, r);
        if px == UNSEEN || qx == UNSEEN || rx == UNSEEN {
            let planes = |[x, planes]: [u32; 2]| if x == UNSEEN { planes as u8 } else { 0 };
            let (p, q, r) = (planes(p), planes(q), planes(r));
            if p & q & r == 0 {
                return Added::Crossing(Outcode(p | q | r));
            }
            self.stats.outside += 1;
            return Added::Done;
        }
        let point = |x: u32, y: u32| Snapped::from_bits(x.cast_signed(), y.cast_signed());
        let (p, q, r) = (point(px, py), point(qx, qy), point(rx, ry));
        if self.cull.leaves_out(facing(p, q, r)) {
            self.stats.culled += 1;
            return Added::Done;
        }
        let [width, height] = self.size;
        let (left, right) = centres(p.x, q.x, r.x, width);
        let [(high, a), (_, b), (low, c)] = canonical([(p, a), (q, b), (r, c)]);
        let (top, bottom) = (centre(high.y, height), centre(low.y, height));
        if left == right || top == bottom {
            self.stats.outside += 1;
            return Added::Done;
        }
        let Some(place) = self.triangles.get_mut(self.used_triangles) else { return Added::Full };
        let named = |corner: u16| (first as u16).wrapping_add(corner);
        *place = ListTriangle {
            vertices: [named(a), named(b), named(c)],
            shader: placed.kept,
            colour: placed.colours.face(face),
            rows: [top, bottom],
        };
        self.used_triangles += 1;
        Added::Done
    }

    /// Clips a face, and adds the vertices of the polygon that is left of it, from its least one on: the first of them, and
    /// how many there are. Apart, as few faces are.
    #[inline(never)]
    fn clipped(
        &mut self,
        drawing: &Drawing<'_>,
        corners: [u16; 3],
        planes: Outcode,
        left_out: &mut LeftOut,
    ) -> (usize, usize) {
        let mut places = [Polygon::new(), Polygon::new()];
        let polygon = drawing.polygon(corners, planes, &mut places);
        let Drawing { placed, .. } = drawing;
        let stride = placed.stride();
        let start = self.used_words;
        let first = self.named(placed.base, stride);
        let words = polygon.len() * stride;
        if first + polygon.len() > MAX_NAMED || !self.reserve(words) {
            left_out.triangles += polygon.len().saturating_sub(2);
            left_out.words += words;
            return (first, 0);
        }
        let words = self.words.get_mut(start..).unwrap_or_default();
        drawing.store_from(0, polygon, words);
        let snapped = |_: &_, place: usize| {
            let [x, y] = header(words, place * stride).unwrap_or_default();
            Snapped::from_bits(x.cast_signed(), y.cast_signed())
        };
        let least = least(polygon, &snapped);
        drawing.store_from(least, polygon, words);
        (first, polygon.len())
    }
}

/// Faces of a draw, or a part of one.
pub(super) struct Faces<'m> {
    /// The vertex that corners are counted from.
    first: usize,
    corners: Iter<'m, [u16; 3]>,
    /// Which face the next corners are of.
    pub(super) face: usize,
}

impl<'m> Faces<'m> {
    /// All faces of a draw.
    pub(super) fn new(first: usize, faces: &'m [[u16; 3]]) -> Self {
        Self { first, corners: faces.iter(), face: 0 }
    }
}

/// The first column with a centre in a triangle, and the one after the last, inside the viewport.
#[inline]
fn centres(a: Coord, b: Coord, c: Coord, length: i32) -> (u16, u16) {
    (centre(a.min(b).min(c), length), centre(a.max(b).max(c), length))
}

/// The first row or column at or beyond a coordinate, inside the viewport.
#[inline]
fn centre(coordinate: Coord, length: i32) -> u16 {
    first_centre(coordinate.to_bits()).max(0).min(length) as u16
}

/// What did not fit: triangles, and the words of those that were clipped.
#[derive(Default)]
pub(super) struct LeftOut {
    triangles: usize,
    words: usize,
}

impl LeftOut {
    /// With as many words free in the end.
    pub(super) fn result(self, free: usize) -> Result<(), DrawError> {
        let Self { triangles, words } = self;
        let words = words.saturating_sub(free);
        if triangles == 0 { Ok(()) } else { Err(DrawError::Full { triangles, words }) }
    }
}

/// What became of a face.
enum Added {
    /// It is in the list, or need not be.
    Done,
    /// It is not in the list, which is full.
    Full,
    /// It is cut by these planes.
    Crossing(Outcode),
}

/// The first two words of a vertex: x and y, or [`UNSEEN`] and the planes that it is outside of.
#[inline(always)]
fn header(words: &[u32], at: usize) -> Option<[u32; 2]> {
    words.get(at..at + 2)?.first_chunk().copied()
}

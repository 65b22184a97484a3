//! Into the list: a mesh's vertices to the screen, its faces culled, clipped and put in canonical order.

use core::marker::PhantomData;
use core::slice::Iter;

use super::drawing::{Drawing, Layout, Shaded, VertexShader};
use super::placed::{Placed, UNSEEN};
use super::render::{self, stride};
use super::{Block, DrawError, DrawFn, DrawList, Kept, ListTriangle, MAX_NAMED};
use crate::camera::Camera;
use crate::clip::{MOST_CORNERS, Outcode, Polygon, least};
use crate::depth::Depth;
use crate::math::format::Coord;
use crate::math::matrix::Matrix;
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::raster::Traversal;
use crate::retained::Records;
use crate::setup::{canonical, facing};
use crate::shade::{PixelShader, Shader, Uniforms};
use crate::snapped::{Snapped, first_centre};
use crate::transform::Transform;
use crate::viewport::{TooLarge, Viewport};

impl<'a, P: Copy, D: Depth, T: Traversal> DrawList<'a, P, D, T> {
    /// Draws a mesh into the list: its vertices to the screen, its faces culled, clipped and put in order.
    ///
    /// # Errors
    /// [`DrawError::Full`] tells how much did not fit, where the list is too small: what did fit stays in it. The
    /// other errors leave the list as it was.
    pub fn draw<C: Camera, S: Shader<'a, P>>(
        &mut self,
        camera: &C,
        mesh: &Mesh<'_>,
        pose: &Pose,
        shader: &S,
    ) -> Result<(), DrawError> {
        let shaded = Shaded { mesh, shader, local: shader.local(mesh, pose), types: PhantomData };
        let layout = Layout::of::<C, P, S::Pixel>();
        let uniforms = shader.pixel().uniforms();
        let pixel = ToKeep::new::<T, S::Pixel>(&uniforms);
        self.place((&camera.viewport(), camera.matrix()), mesh, pose, &shaded, layout, &pixel)
    }

    /// Places a mesh before a camera, and adds it if any of it can be seen. This, too, is linked once.
    #[inline(never)]
    fn place(
        &mut self,
        (viewport, matrix): (&Result<Viewport, TooLarge>, &Matrix),
        mesh: &Mesh<'_>,
        pose: &Pose,
        shaded: &dyn VertexShader,
        layout: Layout,
        pixel: &ToKeep<'_, 'a, P, D>,
    ) -> Result<(), DrawError> {
        let viewport = (*viewport)?;
        let transform = Transform::new(viewport, matrix, mesh, pose);
        let faces = mesh.faces().len();
        if faces == 0 || transform.misses(mesh.bounds()) {
            self.stats.faces += faces;
            self.stats.outside += faces;
            return Ok(());
        }
        let before = self.mark();
        // With all of its faces cut.
        let vertices = mesh.positions().len() + MOST_CORNERS * faces;
        let (kept, base) = self.keep(pixel, vertices)?;
        self.size = [viewport.width(), viewport.height()];
        self.stats.faces += faces;
        let placed = Placed { colours: shaded, stride: pixel.stride as u8, kept, base };
        let drawing =
            Drawing::<D> { transform: &transform, mesh, shaded, layout, placed, types: PhantomData };
        self.add(&drawing, before)
    }

    /// Adds a mesh: whatever its shader and its camera are, this is linked once.
    #[inline(never)]
    fn add(&mut self, drawing: &Drawing<'_, D>, before: Mark) -> Result<(), DrawError> {
        let Drawing { mesh, placed, .. } = drawing;
        let start = self.used_words;
        let first = self.room(placed, mesh.positions().len(), mesh.faces().len(), before)?;
        drawing.vertices(self.words.get_mut(start..).unwrap_or_default());
        let mut left_out = LeftOut::default();
        let mut faces = Faces::new(first, mesh.faces());
        while let Some((corners, planes)) = self.faces(placed, &mut faces, &mut left_out) {
            self.stats.clipped += 1;
            if let Some((first, triangles)) = self.clipped(drawing, corners, planes, &mut left_out) {
                let fan = FAN.get(..triangles).unwrap_or_default();
                let mut parts = Faces { first, corners: fan.iter(), face: faces.face, step: 0 };
                // None of them crosses a plane.
                self.faces(placed, &mut parts, &mut left_out);
            }
            faces.face += 1;
        }
        left_out.result(self.free())
    }

    /// What a draw that does not fit goes back to.
    pub(super) fn mark(&self) -> Mark {
        Mark { words: self.used_words, shaders: self.shaders.len() }
    }

    /// Where a shader is kept, and the first word of its vertices: the same place as an equal one before it, as long
    /// as its triangles can name as many `vertices` more.
    pub(super) fn keep(
        &mut self,
        &ToKeep { uniforms, draw, stride }: &ToKeep<'_, 'a, P, D>,
        vertices: usize,
    ) -> Result<(u8, usize), DrawError> {
        // What comes now may need the words that planes are kept in.
        self.records = Records::NONE;
        for (place, kept) in self.shaders.iter().enumerate() {
            let base = kept.block.base();
            let named = (self.used_words - base + stride - 1).checked_div(stride).unwrap_or_default();
            let same = core::ptr::fn_addr_eq(kept.draw, draw) && kept.uniforms.is(uniforms);
            if same && named + vertices <= MAX_NAMED {
                // Other shaders' vertices may lie between: the next ones start at a whole number of these.
                self.used_words = base + named * stride;
                return Ok((place as u8, base));
            }
        }
        let base = self.used_words;
        let block = Block::new(base, stride);
        self.shaders
            .push(Kept { uniforms: *uniforms, draw, block })
            .map_err(|_| DrawError::TooManyShaders)?;
        Ok(((self.shaders.len() - 1) as u8, base))
    }

    /// Takes words for the vertices of a draw: which of its shader's is the first. Where there are not as many, nothing of
    /// the draw is in the list.
    pub(super) fn room(
        &mut self,
        placed: &Placed<'_>,
        vertices: usize,
        faces: usize,
        before: Mark,
    ) -> Result<usize, DrawError> {
        let start = self.used_words;
        let first = (start - placed.base).checked_div(placed.stride()).unwrap_or_default();
        let words = vertices * placed.stride();
        if !self.reserve(words) {
            // Without padding, and without its shader.
            let missing = self.used_words + words - self.words.len();
            self.used_words = before.words;
            self.shaders.truncate(before.shaders);
            return Err(DrawError::Full { triangles: faces, words: missing });
        }
        Ok(first)
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
        for &corners in faces.corners.by_ref() {
            match self.face(placed, faces.face, faces.first, corners) {
                Added::Done => {}
                Added::Full => left_out.triangles += 1,
                Added::Crossing(planes) => return Some((corners, planes)),
            }
            faces.face += faces.step;
        }
        None
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
        self.stats.drawn += 1;
        Added::Done
    }

    /// Clips a face, and adds the vertices of the polygon that is left of it, from its least one on: the first of them, and
    /// how many triangles there are. Apart, as few faces are.
    #[inline(never)]
    fn clipped(
        &mut self,
        drawing: &Drawing<'_, D>,
        corners: [u16; 3],
        planes: Outcode,
        left_out: &mut LeftOut,
    ) -> Option<(usize, usize)> {
        let mut places = [Polygon::new(), Polygon::new()];
        let polygon = drawing.polygon(corners, planes, &mut places);
        let Drawing { placed, .. } = drawing;
        let stride = placed.stride();
        let start = self.used_words;
        let first = (start - placed.base).checked_div(stride).unwrap_or_default();
        let words = polygon.len() * stride;
        if first + polygon.len() > MAX_NAMED || !self.reserve(words) {
            left_out.triangles += polygon.len().saturating_sub(2);
            left_out.words += words;
            return None;
        }
        drawing.store_from(0, polygon, self.words.get_mut(start..).unwrap_or_default());
        let snapped = |vertex| {
            let [x, y] = header(self.words, placed.word(vertex)).unwrap_or_default();
            Snapped::from_bits(x.cast_signed(), y.cast_signed())
        };
        let least = least(polygon, (first..first + polygon.len()).map(snapped));
        drawing.store_from(least, polygon, self.words.get_mut(start..).unwrap_or_default());
        Some((first, polygon.len().saturating_sub(2)))
    }
}

/// A pixel shader that is to be kept: what it is made of, what draws with it, and how many words a vertex has.
pub(super) struct ToKeep<'u, 'a, P, D: Depth> {
    uniforms: &'u Uniforms<'a>,
    draw: DrawFn<'a, P, D>,
    pub(super) stride: usize,
}

impl<'u, 'a, P: Copy, D: Depth> ToKeep<'u, 'a, P, D> {
    pub(super) fn new<T: Traversal, S: PixelShader<'a, P>>(uniforms: &'u Uniforms<'a>) -> Self {
        Self { uniforms, draw: render::triangle::<P, D, T, S>, stride: const { stride::<P, D, S>() } }
    }
}

/// The triangles of a polygon.
static FAN: [[u16; 3]; MOST_CORNERS - 2] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6], [0, 6, 7], [0, 7, 8]];

/// What a list holds before a draw.
pub(super) struct Mark {
    words: usize,
    shaders: usize,
}

/// Faces of a draw, or the parts of one.
pub(super) struct Faces<'m> {
    /// The vertex that corners are counted from.
    first: usize,
    corners: Iter<'m, [u16; 3]>,
    /// Which face the next corners are of.
    pub(super) face: usize,
    /// From one to the next: parts are all of the same.
    step: usize,
}

impl<'m> Faces<'m> {
    /// All faces of a draw.
    pub(super) fn new(first: usize, faces: &'m [[u16; 3]]) -> Self {
        Self { first, corners: faces.iter(), face: 0, step: 1 }
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

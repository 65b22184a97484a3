//! Into the list: a mesh's vertices to the screen, its faces culled, clipped and put in canonical order.

use core::marker::PhantomData;
use core::slice::Iter;

use super::drawing::{Drawing, Layout, Shaded, UNSEEN};
use super::render::{self, stride};
use super::{Block, DrawError, DrawFn, DrawList, Kept, ListTriangle, MAX_NAMED};
use crate::camera::Camera;
use crate::clip::{MOST_CORNERS, Outcode, Polygon, least};
use crate::depth::Depth;
use crate::math::format::Coord;
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::raster::Traversal;
use crate::retained::Records;
use crate::setup::{canonical, facing};
use crate::shade::{PixelShader, Shader};
use crate::snapped::{Snapped, first_centre};
use crate::transform::Transform;

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
        self.records = Records::NONE;
        let viewport = camera.viewport()?;
        let transform = Transform::new(viewport, camera.matrix(), mesh, pose);
        let faces = mesh.faces().len();
        if faces == 0 || transform.misses(mesh.bounds()) {
            self.stats.faces += faces;
            self.stats.outside += faces;
            return Ok(());
        }
        let before = (self.used_words, self.shaders.len());
        let (kept, base) = self.keep::<S::Pixel>(&shader.pixel(), mesh)?;
        self.size = [viewport.width(), viewport.height()];
        self.stats.faces += faces;
        let shaded = Shaded { mesh, shader, local: shader.local(mesh, pose), types: PhantomData };
        let drawing = Drawing::<D> {
            transform: &transform,
            mesh,
            shaded: &shaded,
            layout: Layout::of::<C, P, D, S::Pixel>(),
            kept,
            base,
            types: PhantomData,
        };
        self.add(&drawing, before)
    }

    /// Adds a mesh: whatever its shader and its camera are, this is linked once.
    #[inline(never)]
    fn add(
        &mut self,
        drawing: &Drawing<'_, D>,
        (words_before, shaders_before): (usize, usize),
    ) -> Result<(), DrawError> {
        let &Drawing { mesh, layout, base, .. } = drawing;
        let stride = layout.stride();
        let faces = mesh.faces().len();
        let start = self.used_words;
        let first = (start - base).checked_div(stride).unwrap_or_default();
        let words = mesh.positions().len() * stride;
        if !self.reserve(words) {
            // Without padding, and without its shader: nothing of this mesh is in the list.
            let missing = self.used_words + words - self.words.len();
            self.used_words = words_before;
            self.shaders.truncate(shaders_before);
            return Err(DrawError::Full { triangles: faces, words: missing });
        }
        drawing.vertices(self.words.get_mut(start..).unwrap_or_default());
        let mut left_out = LeftOut::default();
        let mut faces = Faces { first, corners: mesh.faces().iter(), face: 0, step: 1 };
        while let Some((corners, planes)) = self.faces(drawing, &mut faces, &mut left_out) {
            self.stats.clipped += 1;
            if let Some((first, triangles)) = self.clipped(drawing, corners, planes, &mut left_out) {
                let fan = FAN.get(..triangles).unwrap_or_default();
                let mut parts = Faces { first, corners: fan.iter(), face: faces.face, step: 0 };
                // None of them crosses a plane.
                self.faces(drawing, &mut parts, &mut left_out);
            }
            faces.face += 1;
        }
        left_out.result(self.free())
    }

    /// Where a shader is kept, and the first word of its vertices: the same place as an equal one before it, as long
    /// as its triangles can name all vertices that the mesh can need, with all of its faces cut.
    fn keep<S: PixelShader<'a, P>>(&mut self, shader: &S, mesh: &Mesh<'_>) -> Result<(u8, usize), DrawError> {
        let uniforms = shader.uniforms();
        let draw: DrawFn<'a, P, D> = render::triangle::<P, D, T, S>;
        let stride = stride::<P, D, S>();
        let vertices = mesh.positions().len() + MOST_CORNERS * mesh.faces().len();
        for (place, kept) in self.shaders.iter().enumerate() {
            let base = kept.block.base();
            let named = (self.used_words - base).div_ceil(stride);
            let same = core::ptr::fn_addr_eq(kept.draw, draw) && kept.uniforms == uniforms;
            if same && named + vertices <= MAX_NAMED {
                // Other shaders' vertices may lie between: the next ones start at a whole number of these.
                self.used_words = base + named * stride;
                return Ok((place as u8, base));
            }
        }
        let base = self.used_words;
        let block = Block::new(base, stride);
        self.shaders.push(Kept { uniforms, draw, block }).map_err(|_| DrawError::TooManyShaders)?;
        Ok(((self.shaders.len() - 1) as u8, base))
    }

    /// Words that are not used.
    fn free(&self) -> usize {
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
    fn faces(
        &mut self,
        drawing: &Drawing<'_, D>,
        faces: &mut Faces<'_>,
        left_out: &mut LeftOut,
    ) -> Option<([u16; 3], Outcode)> {
        for &corners in faces.corners.by_ref() {
            match self.face(drawing, faces.face, faces.first, corners) {
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
    fn face(&mut self, drawing: &Drawing<'_, D>, face: usize, first: usize, [a, b, c]: [u16; 3]) -> Added {
        let Some(words) = self.words.get(drawing.word(first)..) else { return Added::Done };
        let header = |corner: u16| header(words, usize::from(corner) * drawing.layout.stride());
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
            shader: drawing.kept,
            colour: drawing.shaded.face(face),
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
        let stride = drawing.layout.stride();
        let start = self.used_words;
        let first = (start - drawing.base).checked_div(stride).unwrap_or_default();
        let words = polygon.len() * stride;
        if first + polygon.len() > MAX_NAMED || !self.reserve(words) {
            left_out.triangles += polygon.len().saturating_sub(2);
            left_out.words += words;
            return None;
        }
        // Where vertices lie says which of them is least: by row, then column, then by all else that tells them apart.
        drawing.store_from(0, polygon, self.words.get_mut(start..).unwrap_or_default());
        let least = least(polygon, |place, vertex| {
            let [x, y] = header(self.words, drawing.word(first + place)).unwrap_or_default();
            let at = vertex.position;
            [y.cast_signed(), x.cast_signed(), at.w, at.z, at.x, at.y]
        });
        drawing.store_from(least, polygon, self.words.get_mut(start..).unwrap_or_default());
        Some((first, polygon.len().saturating_sub(2)))
    }
}

/// The triangles of a polygon.
static FAN: [[u16; 3]; MOST_CORNERS - 2] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6], [0, 6, 7], [0, 7, 8]];

/// Faces of a mesh, or the parts of one.
struct Faces<'m> {
    /// The vertex that corners are counted from.
    first: usize,
    corners: Iter<'m, [u16; 3]>,
    /// Which face the next corners are of.
    face: usize,
    /// From one to the next: parts are all of the same.
    step: usize,
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
struct LeftOut {
    triangles: usize,
    words: usize,
}

impl LeftOut {
    /// With as many words free in the end.
    fn result(self, free: usize) -> Result<(), DrawError> {
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

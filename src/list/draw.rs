//! Into the list: a mesh's vertices to the screen, its faces culled, clipped and put in canonical order.

use core::marker::PhantomData;

use super::render::{self, stride};
use super::{Block, DrawError, DrawFn, DrawList, Kept, ListTriangle, MAX_NAMED};
use crate::attributes::{Carried, Fraction, Words, carried, mixed};
use crate::camera::Camera;
use crate::clip::{ClipVertex, Outcode, Polygon, clip, from_least};
use crate::depth::Depth;
use crate::math::format::Coord;
use crate::math::recip::Reciprocal;
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::raster::Traversal;
use crate::setup::{area2, canonical};
use crate::shade::{PixelShader, Shader};
use crate::snapped::{Snapped, first_centre};
use crate::transform::{PerVertexInverse, Position, Projection, Transform};

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
        let transform = Transform::new(camera, mesh, pose)?;
        let faces = mesh.faces().len();
        if faces == 0 || transform.misses(mesh.bounds()) {
            self.stats.faces += faces;
            self.stats.outside += faces;
            return Ok(());
        }
        let before = self.used_words;
        let (kept, base) = self.keep::<S::Pixel>(&shader.pixel(), mesh.positions().len())?;
        let viewport = transform.projection.viewport;
        self.size = [viewport.width(), viewport.height()];
        self.stats.faces += faces;
        let shaded = Shaded { mesh, shader, local: shader.local(mesh, pose), types: PhantomData };
        let drawing = Drawing::<D> {
            transform,
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
    fn add(&mut self, drawing: &Drawing<'_, D>, before: usize) -> Result<(), DrawError> {
        let &Drawing { mesh, layout: Layout { stride, .. }, base, .. } = drawing;
        let faces = mesh.faces().len();
        let start = self.used_words;
        let first = (start - base).checked_div(stride).unwrap_or_default();
        let words = mesh.positions().len() * stride;
        if !self.reserve(words) {
            // Without padding again: nothing of this mesh is in the list.
            let missing = self.used_words + words - self.words.len();
            self.used_words = before;
            return Err(DrawError::Full { triangles: faces, words: missing });
        }
        drawing.vertices(self.words.get_mut(start..).unwrap_or_default());
        let mut left_out = LeftOut::default();
        for (face, corners) in mesh.faces().iter().enumerate() {
            let [a, b, c] = *corners;
            let vertices = [first + usize::from(a), first + usize::from(b), first + usize::from(c)];
            let [a, b, c] = vertices;
            let header = |vertex| self.header(drawing.word(vertex));
            match seen(header(a), header(b), header(c)) {
                Seen::Outside => self.stats.outside += 1,
                Seen::Whole(points) => self.face(drawing, face, vertices, points, &mut left_out),
                Seen::Crossing(planes) => {
                    self.stats.clipped += 1;
                    self.clipped(drawing, face, *corners, planes, &mut left_out);
                }
            }
        }
        left_out.result(self.free())
    }

    /// Where a shader is kept, and the first word of its vertices: the same place as an equal one before it, as long
    /// as its triangles can name `vertices` more.
    fn keep<S: PixelShader<'a, P>>(&mut self, shader: &S, vertices: usize) -> Result<(u8, usize), DrawError> {
        let uniforms = shader.uniforms();
        let draw: DrawFn<'a, P, D> = render::triangle::<P, D, T, S>;
        let stride = stride::<P, D, S>();
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

    /// The first two words of a vertex.
    fn header(&self, at: usize) -> [u32; 2] {
        match self.words.get(at..) {
            Some([x, y, ..]) => [*x, *y],
            _ => [UNSEEN, u32::from(u8::MAX)],
        }
    }

    /// Adds a triangle of three vertices of the list, unless it is culled or touches no pixel centre of the viewport.
    fn face(
        &mut self,
        drawing: &Drawing<'_, D>,
        face: usize,
        vertices: [usize; 3],
        points: [Snapped; 3],
        left_out: &mut LeftOut,
    ) {
        let [a, b, c] = points;
        if self.cull.leaves_out(area2(a, b, c)) {
            self.stats.culled += 1;
            return;
        }
        let [width, height] = self.size;
        let (left, right) = centres(a.x, b.x, c.x, width);
        let (top, bottom) = centres(a.y, b.y, c.y, height);
        if left == right || top == bottom {
            self.stats.outside += 1;
            return;
        }
        let Some(place) = self.triangles.get_mut(self.used_triangles) else {
            left_out.triangles += 1;
            return;
        };
        let order = canonical(points);
        *place = ListTriangle {
            vertices: order.map(|i| vertices.get(i).copied().unwrap_or_default() as u16),
            shader: drawing.kept,
            colour: drawing.shaded.face(face),
            rows: [top, bottom],
        };
        self.used_triangles += 1;
        self.stats.drawn += 1;
    }

    /// Clips a face, and adds the polygon that is left of it as a fan from its least vertex.
    fn clipped(
        &mut self,
        drawing: &Drawing<'_, D>,
        face: usize,
        corners: [u16; 3],
        planes: Outcode,
        left_out: &mut LeftOut,
    ) {
        let polygon = drawing.polygon(corners, planes);
        let stride = drawing.layout.stride;
        let start = self.used_words;
        let first = (start - drawing.base).checked_div(stride).unwrap_or_default();
        let words = polygon.len() * stride;
        if first + polygon.len() > MAX_NAMED || !self.reserve(words) {
            left_out.triangles += polygon.len().saturating_sub(2);
            left_out.words += words;
            return;
        }
        let mut words = self.words.get_mut(start..).unwrap_or_default();
        for vertex in &polygon {
            let Some((here, rest)) = words.split_at_mut_checked(stride) else { break };
            drawing.store(here, &vertex.position, &vertex.carried);
            words = rest;
        }
        for last in 2..polygon.len() {
            let vertices = [0, last - 1, last].map(|place| first + place);
            let points = vertices.map(|vertex| {
                let [x, y] = self.header(drawing.word(vertex));
                Snapped::from_bits(x.cast_signed(), y.cast_signed())
            });
            self.face(drawing, face, vertices, points, left_out);
        }
    }
}

/// The first row or column with a centre in a triangle, and the one after the last, inside the viewport.
#[inline]
fn centres(a: Coord, b: Coord, c: Coord, length: i32) -> (u16, u16) {
    let (a, b, c) = (a.to_bits(), b.to_bits(), c.to_bits());
    let inside = |coordinate: i32| first_centre(coordinate).max(0).min(length) as u16;
    (inside(a.min(b).min(c)), inside(a.max(b).max(c)))
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

/// The first word of a vertex that lies outside some plane: the second names the planes.
const UNSEEN: u32 = 1 << 31;

/// What the headers of three vertices say of their face.
enum Seen {
    Outside,
    Whole([Snapped; 3]),
    Crossing(Outcode),
}

#[inline]
fn seen(a: [u32; 2], b: [u32; 2], c: [u32; 2]) -> Seen {
    let planes = |[x, planes]: [u32; 2]| if x == UNSEEN { planes as u8 } else { 0 };
    let (p, q, r) = (planes(a), planes(b), planes(c));
    if p & q & r != 0 {
        Seen::Outside
    } else if p | q | r == 0 {
        let point = |[x, y]: [u32; 2]| Snapped::from_bits(x.cast_signed(), y.cast_signed());
        Seen::Whole([point(a), point(b), point(c)])
    } else {
        Seen::Crossing(Outcode(p | q | r))
    }
}

/// The vertex half of a shader over a mesh.
trait VertexShader {
    /// What a vertex carries.
    fn vertex(&self, vertex: usize) -> Carried;

    /// What a vertex between two others carries.
    fn mix(&self, from: &Carried, to: &Carried, at: Fraction) -> Carried;

    /// The colour of a face.
    fn face(&self, face: usize) -> [u8; 3];
}

/// A shader's vertex half, with what it computes once a mesh.
struct Shaded<'m, 'a, S: Shader<'a, P>, P> {
    mesh: &'m Mesh<'m>,
    shader: &'m S,
    local: S::Local,
    types: PhantomData<(&'a (), P)>,
}

impl<'a, S: Shader<'a, P>, P> VertexShader for Shaded<'_, 'a, S, P> {
    fn vertex(&self, vertex: usize) -> Carried {
        carried(self.shader.vertex(&self.local, self.mesh, vertex))
    }

    fn mix(&self, from: &Carried, to: &Carried, at: Fraction) -> Carried {
        mixed::<<S::Pixel as PixelShader<'a, P>>::Vertex>(from, to, at)
    }

    fn face(&self, face: usize) -> [u8; 3] {
        self.shader.face(&self.local, self.mesh, face)
    }
}

/// What the words of a vertex are.
#[derive(Clone, Copy)]
struct Layout {
    /// How many there are.
    stride: usize,
    /// Of these, for the shader.
    carried: usize,
    /// Whether 1/w is one of them.
    inverse: bool,
    /// Whether vertices have a w each.
    perspective: bool,
}

impl Layout {
    fn of<'a, C: Camera, P, D: Depth, S: PixelShader<'a, P>>() -> Self {
        Self {
            stride: stride::<P, D, S>(),
            carried: S::Vertex::WORDS,
            inverse: S::PERSPECTIVE,
            perspective: C::PERSPECTIVE,
        }
    }
}

/// One mesh on its way into the list.
struct Drawing<'m, D> {
    transform: Transform,
    mesh: &'m Mesh<'m>,
    shaded: &'m dyn VertexShader,
    layout: Layout,
    /// Where the pixel shader is kept.
    kept: u8,
    /// The first word of that shader's vertices.
    base: usize,
    types: PhantomData<D>,
}

impl<D: Depth> Drawing<'_, D> {
    /// Where a vertex of the shader starts.
    fn word(&self, vertex: usize) -> usize {
        self.base + vertex * self.layout.stride
    }

    /// Writes all vertices of the mesh, those that can be seen and the planes that others lie outside of.
    fn vertices(&self, mut words: &mut [u32]) {
        for (vertex, &position) in self.mesh.positions().iter().enumerate() {
            let Some((here, rest)) = words.split_at_mut_checked(self.layout.stride) else { break };
            let position = self.transform.position(position);
            let planes = Outcode::new(&position, &self.transform.projection);
            if planes == Outcode(0) {
                self.store(here, &position, &self.shaded.vertex(vertex));
            } else if let [x, y, ..] = here {
                (*x, *y) = (UNSEEN, u32::from(planes.0));
            }
            words = rest;
        }
    }

    /// Writes a vertex that is inside all planes.
    fn store(&self, words: &mut [u32], position: &Position, carried: &Carried) {
        let inverse = self.inverse(position);
        let (x, y) = self.transform.projection.project(position, inverse).bits();
        let mut words = words.iter_mut();
        let mut put = |word: u32| {
            if let Some(place) = words.next() {
                *place = word;
            }
        };
        put(x.cast_unsigned());
        put(y.cast_unsigned());
        D::vertex(|| Projection::nearness(position, inverse)).store(&mut put);
        if self.layout.inverse {
            PerVertexInverse::new(inverse).store(&mut put);
        }
        for &word in carried.iter().take(self.layout.carried) {
            put(word);
        }
    }

    /// One over w, which all vertices share where there is no perspective.
    #[inline]
    fn inverse(&self, position: &Position) -> Reciprocal {
        if self.layout.perspective { Projection::inverse(position.w) } else { self.transform.level_inverse }
    }

    /// What is left of a face inside the planes, in canonical order: its least vertex first, by row, then column, then
    /// by all else that tells vertices apart, so that the fan is the same whichever vertex the face starts with.
    fn polygon(&self, corners: [u16; 3], planes: Outcode) -> Polygon {
        let projection = &self.transform.projection;
        let corner = |corner: u16| {
            let vertex = usize::from(corner);
            let position = self.mesh.positions().get(vertex).copied().unwrap_or_default();
            ClipVertex { position: self.transform.position(position), carried: self.shaded.vertex(vertex) }
        };
        let mix = |from: &Carried, to: &Carried, at| self.shaded.mix(from, to, at);
        let polygon = clip(corners.map(corner), planes, projection, &mix);
        from_least(&polygon, |vertex| {
            let at = vertex.position;
            (projection.project(&at, self.inverse(&at)).order(), at.w, at.z, at.x, at.y)
        })
    }
}

//! Into the list without a mesh: vertices that are on the screen already, from a vertex stage of the caller's own.

use embedded_graphics_core::geometry::Size;

use super::contents::{Contents, Faces, Home, LeftOut};
use super::draw::{Kind, forget, keep};
use super::placed::{FaceColours, Placed, UNSEEN};
use super::render::stride;
use super::{DrawError, DrawList};
use crate::attributes::Words;
use crate::depth::Depth;
use crate::math::format::{DepthCode, Length};
use crate::mesh::check_faces;
use crate::point::Point;
use crate::raster::Traversal;
use crate::shade::PixelShader;
use crate::transform::{PerVertexInverse, Projection};
use crate::viewport::Viewport;

/// A vertex that is on the screen already, for [`DrawList::draw_projected`].
///
/// `A` is what a pixel shader interpolates: nothing for [`FlatPixel`](crate::stages::FlatPixel), red, green and blue for
/// [`GouraudPixel`](crate::stages::GouraudPixel), two texel coordinates for [`Textured`](crate::Textured).
///
/// ```
/// use topleft::{Coord, DepthCode, Length, Point, ProjectedVertex};
///
/// const TIP: ProjectedVertex = ProjectedVertex::new(Point::new(Coord::lit("12.5"), Coord::lit("3")), ());
/// assert_ne!(TIP.with_depth(DepthCode::MAX), TIP);
/// assert_eq!(TIP.with_w(Length::ONE), TIP); // unless it is said otherwise
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProjectedVertex<A = ()> {
    at: Point,
    depth: DepthCode,
    w: Length,
    attributes: A,
}

impl<A: Copy> ProjectedVertex<A> {
    /// A vertex at a point, with the attributes of its shader: at the far plane, and with a w of one.
    pub const fn new(at: Point, attributes: A) -> Self {
        Self { at, depth: DepthCode::ZERO, w: Length::ONE, attributes }
    }

    /// The same at a depth, which is linear on the screen: `65 536 (1 - z / w)`, from 0 at the far plane to
    /// [`DepthCode::MAX`] at the near one. Greater is nearer.
    ///
    /// [`Depth16`](crate::Depth16) makes 65 528 codes of them, from 4 on, and [`DepthFloat`](crate::DepthFloat) small floats;
    /// [`DrawList::sort`] takes the mean of three.
    #[must_use]
    pub const fn with_depth(mut self, depth: DepthCode) -> Self {
        self.depth = depth;
        self
    }

    /// The same at a distance w from the eye, for shaders with perspective: in any unit that the vertices of a triangle
    /// share. It must be positive.
    #[must_use]
    pub const fn with_w(mut self, w: Length) -> Self {
        self.w = w;
        self
    }
}

impl<'a, P: Copy, D: Depth, T: Traversal> DrawList<'a, P, D, T> {
    /// Draws triangles whose vertices are on the screen already: no mesh, no camera, no pose, and no code for them.
    ///
    /// For drawings in two dimensions, and for programs with a vertex stage of their own. `size` is that of the whole frame.
    /// The vertices are an array, or an iterator that runs that stage. Each face names three of them, counter-clockwise as
    /// the viewer sees them where it shows its front, and has one of the colours; white, where there are fewer colours than
    /// faces. There is no light but what the caller puts into colours and attributes.
    ///
    /// There is no clipper here. A triangle is left out, and counted as `outside`, where a vertex lies more than
    /// [`Viewport::margin`] pixels outside the frame or at no finite point, or has no positive w and a shader that needs one.
    /// Triangles that reach further are to be cut by the caller, as are those that reach behind the eye.
    ///
    /// ```
    /// use embedded_graphics_core::geometry::Size;
    /// use topleft::stages::FlatPixel;
    /// use topleft::{Depth16, DepthCode, DrawList, ListStorage, ProjectedVertex, Strip, point};
    ///
    /// let vertex = |x, y, depth| ProjectedVertex::new(point(x, y), ()).with_depth(DepthCode::from_num(depth));
    /// // A square, and a triangle that leans into it from below.
    /// let vertices = [
    ///     vertex(1.0, 1.0, 100), vertex(1.0, 7.0, 100), vertex(7.0, 7.0, 100), vertex(7.0, 1.0, 100),
    ///     vertex(0.0, 8.0, 190), vertex(8.0, 8.0, 190), vertex(4.0, 0.0, 30),
    /// ];
    /// let (faces, colours) = ([[0, 1, 2], [0, 2, 3], [4, 5, 6]], [[255; 3], [255; 3], [255, 0, 0]]);
    ///
    /// let mut storage: ListStorage<21, 3> = ListStorage::new(); // 3 words a vertex
    /// let mut list: DrawList<u16, Depth16> = storage.list();
    /// list.draw_projected(Size::new(8, 8), vertices, &faces, &colours, &FlatPixel)?;
    ///
    /// let (mut cells, mut depths) = ([0; 64], [0; 64]);
    /// let mut frame = Strip::new(8, &mut cells)?.with_depth(&mut depths)?;
    /// list.render(0..8, &mut frame);
    /// let red = frame.colours().chunks(8).map(|row| row.iter().filter(|&&colour| colour == 0xF800).count());
    /// assert!(red.eq([0, 0, 0, 0, 4, 6, 6, 8])); // from the row on where it is the nearer one
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`DrawError::Full`] tells how much did not fit, where the list is too small: what did fit stays in it. The
    /// other errors leave the list as it was.
    pub fn draw_projected<S: PixelShader<'a, P>>(
        &mut self,
        size: Size,
        vertices: impl IntoIterator<Item = ProjectedVertex<S::Vertex>, IntoIter: ExactSizeIterator>,
        faces: &[[u16; 3]],
        colours: &[[u8; 3]],
        shader: &S,
    ) -> Result<(), DrawError> {
        let viewport = Viewport::new(size)?;
        let vertices = vertices.into_iter();
        let count = vertices.len();
        check_faces(count, faces)?;
        if faces.is_empty() {
            return Ok(());
        }
        let Self { contents, shaders, .. } = self;
        let (before, shaders_before) = (contents.used_words, shaders.len());
        let uniforms = shader.uniforms();
        let kind = &const { Kind::projected::<T, S>() };
        let Home { kept, base, first } = keep(shaders, contents, &uniforms, kind, count)?;
        contents.size = [viewport.width(), viewport.height()];
        contents.stats.faces += faces.len();
        let placed = Placed { colours: &colours, stride: kind.layout.stride, kept, base };
        let start = contents.used_words;
        let room = contents.room(&placed, count, faces.len(), before);
        if room.is_ok() {
            let words = contents.words.get_mut(start..contents.used_words).unwrap_or_default();
            write::<P, D, S>(&viewport, vertices, words);
            let before = contents.used_triangles;
            let added = contents.add_seen(&placed, first, faces);
            if let Some(simple) = &kind.simple {
                (simple.simplify)(shaders, contents, before);
            }
            return added;
        }
        forget(shaders, contents, before, shaders_before);
        room
    }
}

impl Contents<'_> {
    /// Adds faces, but for those that have a vertex which is nowhere.
    fn add_seen(&mut self, placed: &Placed<'_>, first: usize, faces: &[[u16; 3]]) -> Result<(), DrawError> {
        let mut left_out = LeftOut::default();
        let mut faces = Faces::new(first, faces);
        while self.faces(placed, &mut faces, &mut left_out).is_some() {
            self.stats.outside += 1;
            faces.face += 1;
        }
        left_out.result(self.free())
    }
}

/// Those that are there, and white.
impl FaceColours for &[[u8; 3]] {
    fn face(&self, face: usize) -> [u8; 3] {
        self.get(face).copied().unwrap_or([255; 3])
    }
}

/// Writes vertices into all of the words: those that can be drawn, and that others are nowhere. So are those that an
/// iterator promised and did not give.
fn write<'a, P, D: Depth, S: PixelShader<'a, P>>(
    viewport: &Viewport,
    mut vertices: impl Iterator<Item = ProjectedVertex<S::Vertex>>,
    mut words: &mut [u32],
) {
    let (left, right) = viewport.guard(viewport.width());
    let (top, bottom) = viewport.guard(viewport.height());
    while let Some(([to_x, to_y, rest @ ..], next)) =
        words.split_at_mut_checked(const { stride::<P, D, S>() })
    {
        words = next;
        let seen = vertices.next().and_then(|vertex| {
            let (x, y) = vertex.at.snapped()?.bits();
            let inside = left <= x && x <= right && top <= y && y <= bottom;
            let before_the_eye = !S::PERSPECTIVE || vertex.w > Length::ZERO;
            (inside && before_the_eye).then_some((x, y, vertex))
        });
        let Some((x, y, vertex)) = seen else {
            (*to_x, *to_y) = (UNSEEN, NOWHERE);
            continue;
        };
        (*to_x, *to_y) = (x.cast_unsigned(), y.cast_unsigned());
        let mut places = rest.iter_mut();
        let mut put = |word: u32| {
            if let Some(place) = places.next() {
                *place = word;
            }
        };
        D::vertex(|| vertex.depth.to_bits()).store(&mut put);
        vertex.attributes.store(&mut put);
        if S::PERSPECTIVE {
            PerVertexInverse::new(Projection::inverse(vertex.w.to_bits())).store(&mut put);
        }
    }
}

/// In place of the planes that a vertex is outside of.
const NOWHERE: u32 = 1;

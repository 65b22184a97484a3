//! A frame's triangles after the vertex stages: what is rendered to strips, as often as there are strips.

use core::marker::PhantomData;
use core::ops::Range;

use embedded_graphics_core::geometry::Size;
use heapless::Vec;

use crate::depth::Depth;
use crate::mesh::MeshError;
use crate::raster::Spans;
use crate::setup::Cull;
use crate::shade::Uniforms;
use crate::target::Rows;
use crate::viewport::TooLarge;

mod contents;
mod draw;
mod drawing;
mod placed;
mod projected;
mod render;
mod simple;
mod sort;
mod storage;

use contents::Contents;
pub use projected::ProjectedVertex;
pub use sort::SortError;
pub use storage::ListStorage;

/// Different shaders that one list can hold. Draws with an equal one share it, if its texels lie in the same place.
const MAX_SHADERS: usize = 16;

/// Vertices that the triangles of one shader can name: by 16 bits.
const MAX_NAMED: usize = 1 << 16;

/// A triangle of a list: 14 bytes.
#[derive(Clone, Copy, Debug)]
pub struct ListTriangle {
    /// Its vertices in canonical order, counted from the first of its shader.
    vertices: [u16; 3],
    /// Which of the list's; with [`SIMPLE`], its simpler one.
    shader: u8,
    /// Red, green and blue of the face.
    colour: [u8; 3],
    /// Rows with a pixel centre between top and bottom, inside the viewport.
    rows: [u16; 2],
}

impl ListTriangle {
    /// What storage is filled with.
    pub const EMPTY: Self = Self { vertices: [0; 3], shader: 0, colour: [0; 3], rows: [0; 2] };

    /// The place of its shader in the list.
    fn shader(&self) -> usize {
        usize::from(self.shader & !SIMPLE)
    }
}

/// In a triangle's shader: that the simpler one of it draws the triangle.
const SIMPLE: u8 = 1 << 7;

/// Draws one triangle, with the vertices of its shader: one such function is linked for each shader that is used.
type DrawFn<'a, P, D> = fn(&Kept<'a, P, D>, &[u32], &ListTriangle, &mut Rows<'_, P, D>);

/// A pixel shader as the list keeps it, the function that draws with it, and where its vertices are.
#[derive(Clone, Copy, Debug)]
struct Kept<'a, P, D: Depth> {
    uniforms: Uniforms<'a>,
    draw: DrawFn<'a, P, D>,
    /// Of its simpler one, if it has one.
    simple: Option<DrawFn<'a, P, D>>,
    block: Block,
}

/// The shaders of a list.
type Shaders<'a, P, D> = Vec<Kept<'a, P, D>, MAX_SHADERS>;

/// Words of a vertex at most: x, y, depth, 1/w, and four for its shader.
const MAX_STRIDE: usize = 8;

/// The words of a shader's vertices: the first of them, and how many a vertex takes.
///
/// Both fit one: a slice has at most as many bytes as half of all numbers can count, so the first word leaves three bits.
#[derive(Clone, Copy, Debug, Default)]
struct Block(usize);

impl Block {
    const fn new(base: usize, stride: usize) -> Self {
        Self(base * MAX_STRIDE + (stride - 1) % MAX_STRIDE)
    }

    /// The first word.
    const fn base(self) -> usize {
        self.0 / MAX_STRIDE
    }

    /// Words of a vertex.
    const fn stride(self) -> usize {
        self.0 % MAX_STRIDE + 1
    }
}

/// Why a mesh is not in the list, or not all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawError {
    /// The list is full. What did fit is drawn.
    Full {
        /// Triangles that were left out, before culling where the vertices did not fit.
        triangles: usize,
        /// Words of vertices that were missing. Where there are none, the triangles were: or a mesh of more than 65 000
        /// vertices was cut so often that its triangles cannot name the new ones.
        words: usize,
    },
    /// The list already holds its 16 different shaders, or for one of them as many times 65 536 vertices, of which a mesh
    /// may need nine a face where it is cut; nothing of the mesh is drawn.
    TooManyShaders,
    /// The camera's target is too large; nothing of the mesh is drawn.
    TooLarge(Size),
    /// Faces of [`draw_projected`](DrawList::draw_projected) name a vertex that is not there, or there are more vertices
    /// than can be named; nothing of them is drawn.
    Faces(MeshError),
}

impl From<MeshError> for DrawError {
    fn from(error: MeshError) -> Self {
        Self::Faces(error)
    }
}

impl From<TooLarge> for DrawError {
    fn from(TooLarge(size): TooLarge) -> Self {
        Self::TooLarge(size)
    }
}

impl core::fmt::Display for DrawError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Full { triangles, words } => {
                write!(f, "the list is full: {triangles} triangles did not fit, {words} words were missing")
            }
            Self::TooManyShaders => write!(f, "the list holds {MAX_SHADERS} different shaders already"),
            Self::TooLarge(size) => TooLarge(*size).fmt(f),
            Self::Faces(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for DrawError {}

/// What became of the faces that were drawn into a list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Faces of all draws.
    pub faces: usize,
    /// Triangles that show the side which is culled, or have no area: faces, or the parts of one that was cut.
    pub culled: usize,
    /// Triangles outside the view, and those that touch no pixel centre: faces, or the parts of one that was cut. Where
    /// vertices were on the screen already, those with one beyond the guard rectangle too.
    pub outside: usize,
    /// Faces that were cut by the near or far plane or by the guard rectangle, into parts that are counted above or
    /// below.
    pub clipped: usize,
    /// Triangles in the list.
    pub drawn: usize,
}

/// The triangles of a frame, in borrowed storage: vertices once a frame, pixels once a strip.
///
/// `P` is the colour of a strip's cells, `D` its depth, `T` how pixels are found; all follow from the strips that the
/// list is rendered to. Draw all meshes of a frame with cameras of one viewport, and all else for the same size.
///
/// A vertex takes two words and what its shader and depth need: flat 2, Gouraud 3, textured 4, textured with
/// perspective 5, lit 1 more, and with depth or in painter's order 1 more. A triangle takes 14 bytes.
///
/// ```
/// use embedded_graphics_core::geometry::Size;
/// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
/// use topleft::{DrawList, Flat, ListTriangle, Material, Mesh, Orthographic, Pose, Strip};
///
/// let positions = [[-32767, -32767, 0], [32767, -32767, 0], [0, 32767, 0]];
/// let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
/// let camera = Orthographic::new(Size::new(8, 8), 2.0, -1.0..1.0);
///
/// let (mut vertices, mut triangles) = ([0; 16], [ListTriangle::EMPTY; 4]);
/// let mut list = DrawList::new(&mut vertices, &mut triangles);
/// list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED)).unwrap();
///
/// let mut colours = [Rgb565::BLACK; 64];
/// let mut frame = Strip::new(8, &mut colours).unwrap();
/// list.render(0..8, &mut frame);
/// let rows = frame.colours().chunks(8).map(|row| row.iter().filter(|&&c| c == Rgb565::RED).count());
/// assert!(rows.eq([0, 2, 2, 4, 4, 6, 6, 8]));
/// ```
#[derive(Debug)]
pub struct DrawList<'a, P, D: Depth, T = Spans> {
    contents: Contents<'a>,
    shaders: Shaders<'a, P, D>,
    traversal: PhantomData<T>,
}

impl<'a, P, D: Depth> DrawList<'a, P, D> {
    /// An empty list over borrowed storage: words for vertices, and triangles.
    pub const fn new(vertices: &'a mut [u32], triangles: &'a mut [ListTriangle]) -> Self {
        Self::with_traversal(vertices, triangles)
    }
}

impl<'a, P, D: Depth, T> DrawList<'a, P, D, T> {
    /// An empty list whose pixels are found by another traversal, with the same result.
    ///
    /// ```
    /// use topleft::{BoxWalk, Depth16, DrawList};
    ///
    /// let list = DrawList::<u16, Depth16, BoxWalk>::with_traversal(&mut [], &mut []);
    /// assert_eq!(list.stats().drawn, 0);
    /// ```
    pub const fn with_traversal(vertices: &'a mut [u32], triangles: &'a mut [ListTriangle]) -> Self {
        let contents = Contents::new(vertices, triangles);
        Self { contents, shaders: Vec::new(), traversal: PhantomData }
    }

    /// Sets which faces are left out of what is drawn from now on: backs, unless it is said otherwise.
    pub const fn set_cull(&mut self, cull: Cull) {
        self.contents.cull = cull;
    }

    /// Empties the list for the next frame. What is culled stays set.
    pub fn clear(&mut self) {
        self.contents.used_words = 0;
        self.contents.used_triangles = 0;
        self.contents.stats = Stats::default();
        self.shaders.clear();
    }

    /// What became of the faces that were drawn so far.
    pub const fn stats(&self) -> Stats {
        self.contents.stats
    }

    /// The rows of the frame from the first that a triangle lies in to the last; none, from 0 on, where the list is empty.
    ///
    /// All others show what a strip is cleared to: where a display does so already, they need not be rendered or sent.
    /// Each call looks at all triangles.
    ///
    /// ```
    /// use embedded_graphics_core::geometry::Size;
    /// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
    /// use topleft::{Flat, ListStorage, Mesh, NoDepth, Orthographic, Pose};
    ///
    /// let positions = [[-32767, 0, 0], [32767, 0, 0], [0, 16384, 0]];
    /// let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    /// let camera = Orthographic::new(Size::new(8, 8), 2.0, -1.0..1.0);
    ///
    /// let mut storage = ListStorage::<6, 1>::new();
    /// let mut list = storage.list::<Rgb565, NoDepth>();
    /// assert_eq!(list.rows(), 0..0);
    /// list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED)).unwrap();
    /// assert_eq!(list.rows(), 2..4);
    /// ```
    pub fn rows(&self) -> Range<i32> {
        let triangles = self.contents.triangles.get(..self.contents.used_triangles).unwrap_or_default();
        let (mut first, mut last) = (u16::MAX, 0);
        for triangle in triangles {
            let [top, bottom] = triangle.rows;
            (first, last) = (first.min(top), last.max(bottom));
        }
        i32::from(first.min(last))..i32::from(last)
    }

    /// Words of vertices in use.
    pub const fn words(&self) -> usize {
        self.contents.used_words
    }
}

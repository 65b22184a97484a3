//! What the library finds for each pixel on its whole way, and what is exact there: at the vertices as it snapped them,
//! with the 1/w that it gave them. What is left is the error of the method.

use std::cell::RefCell;

use embedded_graphics_core::geometry::Size;
use reference::setup::Triangle;
use scenes::{Scene, View};
use topleft::stages::{
    Correction, DrawSpan, DrawTexels, DrawTriangle, PerVertexInverse, PixelShader, Run, Setup, Shader,
    Traversal, Uniforms, Varying, Window, Words,
};
use topleft::{
    Affine, Attribute, Depth, Depth16, DrawList, ListTriangle, Mesh, Pixel, Pose, Spans, Strip, Texture,
    Textured,
};

/// A triangle as the library draws it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    pub(crate) points: Triangle,
    /// Columns and rows of the texture, by vertex.
    pub(crate) texels: [[f64; 2]; 3],
    /// 1/w, by vertex, in any unit.
    pub(crate) q: [f64; 3],
    /// How many pixels it covers.
    pub(crate) pixels: u64,
}

thread_local! {
    /// The triangles of the frame that is being drawn; the last one has no points before it is walked.
    static SEEN: RefCell<Vec<Seen>> = const { RefCell::new(Vec::new()) };
}

const NOWHERE: Triangle = [[i32::MIN; 2]; 3];

/// A pixel that remembers its triangle, counted from 1, and its texel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cell {
    pub(crate) triangle: u32,
    pub(crate) texel: [i32; 2],
}

impl Pixel for Cell {
    const MAX: [u8; 3] = [255; 3];
    type Stepped = [Attribute; 3];

    fn from_channels(_: [u8; 3]) -> Self {
        Self::default()
    }

    fn channels(self) -> [u8; 3] {
        [0; 3]
    }

    fn from_texel(_: u16) -> Self {
        Self::default()
    }
}

/// A texture that shows where its texels are.
#[derive(Clone, Copy)]
struct Located<'a, C>(Textured<'a, C>, C);

impl<'a, C: Correction> Shader<'a, Cell> for Located<'a, C> {
    type Pixel = Self;
    type Local = ();

    fn pixel(&self) -> Self {
        *self
    }

    fn local(&self, _: &Mesh<'_>, _: &Pose) {}

    fn vertex(&self, (): &(), mesh: &Mesh<'_>, vertex: usize) -> [Attribute; 2] {
        Shader::<u16>::vertex(&self.0, &(), mesh, vertex)
    }

    fn face(&self, (): &(), _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

impl<'a, C: Correction> PixelShader<'a, Cell> for Located<'a, C> {
    type Vertex = [Attribute; 2];
    type Varying = C::Varying;
    type Triangle = (u32, C::Triangle);
    type Simple = Located<'a, Affine>;
    const PERSPECTIVE: bool = true;
    const SIMPLIFIES: bool = C::FINDS_AFFINE;

    fn is_simple(words: [u32; 2], vertices: [[Attribute; 2]; 3], inverses: [PerVertexInverse; 3]) -> bool {
        C::from_words(words).is_affine(vertices, inverses)
    }

    fn uniforms(&self) -> Uniforms<'a> {
        PixelShader::<u16>::uniforms(&self.0)
    }

    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
        let correction = C::from_words(uniforms.words);
        Self(Textured::new(&uniforms.texture, correction), correction)
    }

    fn triangle(
        &self,
        colour: [u8; 3],
        vertices: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
    ) -> ((u32, C::Triangle), [C::Varying; 3]) {
        let number = seen(vertices, inverses);
        let (triangle, varyings) = PixelShader::<u16>::triangle(&self.0, colour, vertices, inverses);
        ((number, triangle), varyings)
    }

    fn choose<D: DrawTriangle<'a, Cell>>(
        &self,
        _: [u8; 3],
        vertices: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        onto: D,
    ) -> D::Output {
        let Uniforms { texture, .. } = PixelShader::<Cell>::uniforms(self);
        let onto = Onto { number: seen(vertices, inverses), texture, onto };
        let sizes_log2 = [texture.width(), texture.height()].map(|length| length.ilog2() as u8);
        self.1.choose(vertices, inverses, sizes_log2, onto)
    }

    fn shade<D: Depth>(
        &self,
        &(number, triangle): &(u32, C::Triangle),
        start: C::Varying,
        step: &C::Varying,
        run: Run<'_, Cell, D>,
    ) {
        run.visible(|skipped, cells| {
            let start = start.plus(step.times(skipped));
            self.1.walk(&triangle, start, step, cells, &mut |cell: &mut Cell, u, v| {
                *cell = Cell { triangle: number, texel: [u, v] };
            });
        });
    }
}

/// Remembers a triangle; its number.
fn seen(vertices: [[Attribute; 2]; 3], inverses: [PerVertexInverse; 3]) -> u32 {
    let texels = vertices.map(|texel| texel.map(|c| f64::from(c.to_bits()) / 65_536.0));
    SEEN.with_borrow_mut(|seen| {
        seen.push(Seen { points: NOWHERE, texels, q: inverses.map(q), pixels: 0 });
        seen.len() as u32
    })
}

/// Where a numbered triangle is drawn, by the method that was chosen for it.
struct Onto<'a, D> {
    number: u32,
    texture: Texture<'a>,
    onto: D,
}

impl<'a, D: DrawTriangle<'a, Cell>> DrawTexels for Onto<'a, D> {
    type Output = D::Output;

    fn draw<C: Correction>(
        self,
        method: C,
        triangle: C::Triangle,
        varyings: [C::Varying; 3],
    ) -> Self::Output {
        let Self { number, texture, onto } = self;
        onto.draw(Located(Textured::new(&texture, method), method), (number, triangle), varyings)
    }
}

/// The value of a vertex's 1/w: a mantissa and a shift in one word.
fn q(inverse: PerVertexInverse) -> f64 {
    let mut word = 0;
    inverse.store(&mut |stored| word = stored);
    f64::from(word & !31) * 2.0_f64.powi(-((word & 31) as i32))
}

/// The library's own walk, which leaves a triangle's points behind.
enum Spy {}

impl Traversal for Spy {
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        SEEN.with_borrow_mut(|seen| {
            let last = seen.last_mut().expect("the shader sees a triangle before it is walked");
            assert_eq!(last.points, NOWHERE, "the shader sees each triangle");
            last.points = setup.points().map(|point| [point.x.to_bits(), point.y.to_bits()]);
        });
        Spans::walk(setup, window, |span| {
            let pixels = u64::from(span.end.abs_diff(span.start));
            SEEN.with_borrow_mut(|seen| seen.last_mut().expect("it is there").pixels += pixels);
            target.draw(span)
        })
    }
}

/// A frame of a scene: its triangles, and its pixels row by row.
pub(crate) fn frame(scene: &Scene, size: Size, correction: impl Correction) -> (Vec<Seen>, Vec<Cell>) {
    let mut words = vec![0; scene.vertices() * 9 + 2000];
    let mut triangles = vec![ListTriangle::EMPTY; scene.faces() + 500];
    let (mut cells, mut depths) = (Vec::new(), Vec::new());
    cells.resize((size.width * size.height) as usize, Cell::default());
    depths.resize(cells.len(), 0);
    SEEN.with_borrow_mut(Vec::clear);
    let mut list = DrawList::<Cell, Depth16, Spy>::with_traversal(&mut words, &mut triangles);
    scene
        .draw_with(&mut list, size, &View::default(), |object| {
            Located(Textured::new(&object.look.texture, correction), correction)
        })
        .expect("the list is long enough");
    let strip = Strip::new(size.width as u16, &mut cells).and_then(|strip| strip.with_depth(&mut depths));
    let mut strip = strip.expect("whole rows");
    strip.clear();
    list.render(0..size.height as i32, &mut strip);
    (SEEN.take(), cells)
}

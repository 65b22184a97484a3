//! Vertices, faces and attributes of any numbers, lists of any length, and iterators that do not keep their word.

use std::ops::Range;

use embedded_graphics::prelude::*;
use proptest::prelude::*;
use topleft::stages::{FlatPixel, GouraudPixel, PixelShader, Shader, Traversal};
use topleft::{
    Affine, Attribute, BoxWalk, Coord, Cull, Depth16, DepthCode, DepthFloat, Divided, DrawError, DrawList,
    Length, ListTriangle, MAX_VERTICES, Mesh, MeshError, Painter, PerPixel, Point as Corner, Portable,
    ProjectedVertex, Spans, Stats, Subspans, Sun, Texture, Textured, Within, Wrap, point,
};

use crate::support::check;
use crate::support::frame::Strips;
use crate::support::guarded::guarded;
use crate::support::stats::adds_up;

static TEXELS: [u16; 8] = [1, 2, 3, 4, 5, 6, 7, 0xFFFF];

/// Storage of a list.
type Store = (Vec<u32>, Vec<ListTriangle>);

/// A vertex of any numbers.
type Any = (u8, [i32; 2], u32, i32, [i32; 3]);

/// Vertices, faces, and how they are drawn.
#[derive(Clone, Debug)]
struct Case {
    vertices: Vec<Any>,
    faces: Vec<[u16; 3]>,
    colours: Vec<[u8; 3]>,
    /// More vertices than there are, that an iterator says there are.
    more: isize,
    size: [u32; 2],
    rows: Range<i32>,
    storage: [usize; 2],
    way: u8,
}

/// An iterator that says something else than it does.
struct Liar<I>(I, usize);

impl<I: Iterator> Iterator for Liar<I> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        self.0.next()
    }
}

impl<I: Iterator> ExactSizeIterator for Liar<I> {
    fn len(&self) -> usize {
        self.1
    }
}

fn corner((kind, [x, y], ..): Any) -> Corner {
    match kind % 8 {
        0 => Corner::new(Coord::from_bits(x), Coord::from_bits(y)),
        1 => point(f32::from_bits(x.cast_unsigned()), f32::from_bits(y.cast_unsigned())),
        2 => point(f32::NAN, 3.0),
        _ => Corner::new(Coord::from_bits(x % 60_000), Coord::from_bits(y % 60_000)),
    }
}

impl Case {
    /// Draws by both traversals with two depths, which agree, and in painter's order.
    fn draw<'a, S: PixelShader<'a, u16>>(
        &self,
        stores: &mut impl Iterator<Item = &'a mut Store>,
        shader: &S,
        attributes: impl Fn([i32; 3]) -> S::Vertex,
    ) -> Result<(), String> {
        let mut store = || stores.next().expect("four for each shader");
        let spans = self.by::<Depth16, Spans, S>(store(), shader, &attributes)?;
        if spans != self.by::<Depth16, BoxWalk, S>(store(), shader, &attributes)? {
            return Err("the traversals differ".into());
        }
        self.by::<DepthFloat, Spans, S>(store(), shader, &attributes)?;
        self.by::<Painter, Spans, S>(store(), shader, &attributes).map(|_| ())
    }

    fn by<'a, D: Strips, T: Traversal, S: PixelShader<'a, u16>>(
        &self,
        (words, triangles): &'a mut Store,
        shader: &S,
        attributes: &impl Fn([i32; 3]) -> S::Vertex,
    ) -> Result<Vec<u16>, String> {
        let mut list = DrawList::<u16, D, T>::with_traversal(words, triangles);
        list.set_cull([Cull::None, Cull::Front, Cull::Back][usize::from(self.way) % 3]);
        let vertices = self.vertices.iter().map(|&any| {
            let (.., depth, w, numbers) = any;
            let vertex = ProjectedVertex::new(corner(any), attributes(numbers));
            vertex.with_depth(DepthCode::from_bits(depth)).with_w(Length::from_bits(w))
        });
        let said = self.vertices.len().saturating_add_signed(self.more);
        let size = Size::new(self.size[0], self.size[1]);
        let result = list.draw_projected(size, Liar(vertices, said), &self.faces, &self.colours, shader);
        // Indices are checked as a mesh's are.
        let right = Mesh::new(&vec![[0; 3]; said.min(MAX_VERTICES + 1)], &self.faces)
            .map(|_| ())
            .map_err(DrawError::Faces);
        match (result, right) {
            (Err(DrawError::Faces(MeshError::TooManyVertices(many))), Err(_)) if many == said => {}
            (result, Err(error)) if result != Err(error) => return Err(format!("{result:?}, not {error:?}")),
            (Err(DrawError::Faces(_)), _) => {
                if list.stats() != Stats::default() || list.words() != 0 {
                    return Err(format!("{:?} of nothing", list.stats()));
                }
            }
            (result, _) => adds_up(Stats::default(), list.stats(), result, self.faces.len())?,
        }
        D::sort(&mut list);
        guarded(&list, self.rows.clone())
    }
}

fn case() -> impl Strategy<Value = Case> {
    let number = || prop_oneof![any::<i32>(), -400_000..400_000_i32, Just(0), Just(i32::MIN), Just(i32::MAX)];
    let w = prop_oneof![number(), 1..i32::MAX, Just(1)];
    let depth = prop_oneof![any::<u32>(), Just(0), Just(u32::MAX)];
    let vertex = (any::<u8>(), [number(), number()], depth, w, [number(), number(), number()]);
    let sizes = prop::sample::select(vec![[0, 0], [1, 1], [1, 90], [70, 1], [33, 21], [64, 64], [8190, 4]]);
    let rows = prop_oneof![
        Just(0..100),
        Just(-5..7),
        Just(i32::MIN..i32::MAX),
        any::<(i32, i32)>().prop_map(|(a, b)| a..b)
    ];
    let storage = prop_oneof![Just([100, 20]), [0..90_usize, 0..12_usize]];
    let more = prop_oneof![8 => Just(0), 1 => -14..14_isize, 1 => Just(70_000)];
    let faces = prop::collection::vec(any::<[u16; 3]>(), 0..14);
    let colours = prop::collection::vec(any::<[u8; 3]>(), 0..20);
    (
        prop::collection::vec(vertex, 1..14),
        faces,
        colours,
        more,
        any::<bool>(),
        (sizes, rows, storage, any::<u8>()),
    )
        .prop_map(|(vertices, faces, colours, more, wild, (size, rows, storage, way))| {
            let count = vertices.len() as u16;
            let index = |index: u16| if wild && index.is_multiple_of(16) { index } else { index % count };
            let faces = faces.into_iter().map(|face: [u16; 3]| face.map(index)).collect();
            Case { vertices, faces, colours, more, size, rows, storage, way }
        })
}

/// Turned red by: an index that is not checked; 1/w that is written where depth is read.
#[test]
fn any_vertices_and_faces_are_legal() {
    let texture = Texture::new(4, 2, &TEXELS).expect("a texture");
    check(4_000, &case(), |case| {
        let [words, triangles] = case.storage;
        let mut stores = vec![(vec![0x7FFF_FFFF; words], vec![ListTriangle::EMPTY; triangles]); 32];
        let stores = &mut stores.iter_mut();
        let bits = |[u, v, _]: [i32; 3]| [u, v].map(Attribute::from_bits);
        let lit = |[u, v, light]: [i32; 3]| ([u, v].map(Attribute::from_bits), Attribute::from_bits(light));
        case.draw(stores, &FlatPixel, |_| ())?;
        case.draw(stores, &GouraudPixel, |numbers| numbers.map(|number| number as u8))?;
        case.draw(stores, &Textured::new(&texture, Affine), bits)?;
        case.draw(stores, &Textured::new(&texture, PerPixel), bits)?;
        case.draw(stores, &Textured::new(&texture, Subspans::Of8), bits)?;
        case.draw(stores, &Textured::new(&texture, Within::default()), bits)?;
        case.draw(stores, &Textured::new(&texture.with_wrap(Wrap::Clamp), Divided::<Portable>::new()), bits)?;
        let sun = Sun::new([Length::ONE; 3]);
        let shader = Textured::new(&texture.with_wrap(Wrap::Clamp), PerPixel).lit_by(&sun);
        case.draw(stores, &Shader::<u16>::pixel(&shader), lit)
    });
}

/// Turned red by: words that stay as they were where an iterator ends before it said so.
#[test]
fn what_an_iterator_does_not_give_is_not_drawn() {
    let corners = [[0.0, 0.0], [0.0, 9.0], [9.0, 0.0]].map(|[x, y]| ProjectedVertex::new(point(x, y), ()));
    let mut storage = ([0; 9], [ListTriangle::EMPTY; 1]);
    let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
    for (given, drawn) in [(3, 1), (2, 0), (0, 0)] {
        // The words of the frame before are still there.
        list.clear();
        let vertices = Liar(corners.into_iter().take(given), 3);
        list.draw_projected(Size::new(9, 9), vertices, &[[0, 1, 2]], &[], &FlatPixel).unwrap();
        assert_eq!((list.stats().drawn, list.stats().outside), (drawn, 1 - drawn));
    }
}

//! Which triangles of a draw a simpler shader draws: found once, in whatever strips they are.

use super::render::{carried, stride, triangle};
use super::{Contents, DrawFn, Kept, Shaders};
use crate::attributes::Words;
use crate::depth::Depth;
use crate::raster::Traversal;
use crate::shade::PixelShader;

/// The simpler shader of another, of the same vertices and uniforms.
pub(super) struct Simple<'a, P, D: Depth> {
    /// The function that draws its pixels.
    pub(super) draw: DrawFn<'a, P, D>,
    /// Has it draw what it may of a draw's triangles, from one on. Only shaders that have a simpler one link it.
    simplify: SimplifyFn<'a, P, D>,
}

type SimplifyFn<'a, P, D> = fn(&Shaders<'a, P, D>, &mut Contents<'_>, DrawFn<'a, P, D>, usize);

impl<'a, P: Copy, D: Depth> Simple<'a, P, D> {
    /// That of a shader, if it has one.
    pub(super) const fn of<T: Traversal, S: PixelShader<'a, P>>() -> Option<Self> {
        const { assert!(S::PERSPECTIVE || !S::Simple::PERSPECTIVE, "vertices carry no 1/w for it") };
        if S::SIMPLIFIES {
            Some(Self { draw: triangle::<P, D, T, S::Simple>, simplify: simplify::<P, D, S> })
        } else {
            None
        }
    }

    /// Has it draw what it may of the triangles of a draw, which are those from `first` on.
    pub(super) fn simplify(&self, shaders: &Shaders<'a, P, D>, contents: &mut Contents<'_>, first: usize) {
        (self.simplify)(shaders, contents, self.draw, first);
    }
}

/// Names it in those of the triangles that it may draw: it is kept beside their shader.
fn simplify<'a, P, D: Depth, S: PixelShader<'a, P>>(
    shaders: &Shaders<'a, P, D>,
    contents: &mut Contents<'_>,
    draw: DrawFn<'a, P, D>,
    first: usize,
) {
    let Contents { words, triangles, used_triangles, .. } = contents;
    let triangles = triangles.get_mut(first..*used_triangles).unwrap_or_default();
    let Some(kept) = triangles.first().and_then(|triangle| shaders.get(usize::from(triangle.shader))) else {
        return;
    };
    let Kept { uniforms, block, .. } = kept;
    let beside = |other: &Kept<'a, P, D>| other.is(draw, uniforms) && other.block == *block;
    let (Some(place), Some(words)) = (shaders.iter().position(beside), words.get(block.base()..)) else {
        return;
    };
    let carried = |vertex: u16| {
        let stride = const { stride::<P, D, S>() };
        let at = usize::from(vertex) * stride;
        let words = words.get(at..at + stride)?.get(2 + D::Vertex::WORDS..)?;
        carried::<P, S>(&mut words.iter().copied())
    };
    for triangle in triangles {
        let [a, b, c] = triangle.vertices;
        let Some((a, over_a)) = carried(a) else { return };
        let Some((b, over_b)) = carried(b) else { return };
        let Some((c, over_c)) = carried(c) else { return };
        if S::is_simple(uniforms.words, [a, b, c], [over_a, over_b, over_c]) {
            triangle.shader = place as u8;
        }
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::geometry::Size;

    use super::*;
    use crate::Depth16;
    use crate::list::{DrawError, DrawList, ListStorage, ProjectedVertex};
    use crate::math::format::{Attribute, DepthCode, Length};
    use crate::point::point;
    use crate::run::Run;
    use crate::shade::Uniforms;
    use crate::target::Strip;
    use crate::transform::{PerVertexInverse, Projection};

    /// Shows a word, and has triangles of vertices that carry less than 8 shown by [`Low`].
    #[derive(Clone, Copy)]
    struct High(u16);

    /// Shows the word that follows.
    #[derive(Clone, Copy)]
    struct Low(u16);

    macro_rules! shows {
        ($shader:ident, $more:literal, $perspective:literal, $simplifies:literal) => {
            impl<'a> PixelShader<'a, u16> for $shader {
                type Vertex = Attribute;
                type Varying = ();
                type Triangle = ();
                type Simple = Low;
                const PERSPECTIVE: bool = $perspective;
                const SIMPLIFIES: bool = $simplifies;

                fn is_simple(words: [u32; 2], carried: [Attribute; 3], over: [PerVertexInverse; 3]) -> bool {
                    assert_eq!(words, [7, 0]);
                    assert_eq!(over, [PerVertexInverse::new(Projection::inverse(Length::ONE.to_bits())); 3]);
                    carried.iter().all(|&carried| carried < 8)
                }

                fn uniforms(&self) -> Uniforms<'a> {
                    Uniforms { words: [u32::from(self.0), 0], ..Uniforms::NONE }
                }

                fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
                    Self(uniforms.words[0] as u16)
                }

                fn triangle(&self, _: [u8; 3], _: [Attribute; 3], _: [PerVertexInverse; 3]) -> ((), [(); 3]) {
                    ((), [(); 3])
                }

                fn shade<D: Depth>(&self, (): &(), (): (), (): &(), run: Run<'_, u16, D>) {
                    for place in run.pixels() {
                        place.shade(|| self.0 + $more);
                    }
                }
            }
        };
    }
    shows!(High, 0, true, true);
    shows!(Low, 1, false, false);

    const SIZE: Size = Size::new(8, 8);

    /// Three columns of squares, whose vertices carry 9, 3 and 9.
    fn draw<'a>(
        list: &mut DrawList<'a, u16, Depth16>,
        shader: &impl PixelShader<'a, u16, Vertex = Attribute>,
    ) -> Result<(), DrawError> {
        let column = |left: u16, carried: i32| {
            let at = move |x: u16, y: u16| {
                ProjectedVertex::new(point(f32::from(x), f32::from(y)), Attribute::from_num(carried))
                    .with_depth(DepthCode::from_num(100))
                    .with_w(Length::ONE)
            };
            [at(left, 0), at(left, 8), at(left + 2, 8), at(left + 2, 0)]
        };
        let vertices = [column(0, 9), column(2, 3), column(4, 9)];
        let faces = [0, 4, 8].map(|first| [[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        list.draw_projected(SIZE, vertices.as_flattened().iter().copied(), faces.as_flattened(), &[], shader)
    }

    // Red when all triangles are simple, or none; when those of another draw are marked, or a shader that is not beside the draw's
    // own draws them; and when a simpler shader takes vertices to have no more words than it needs.
    #[test]
    fn a_simpler_shader_draws_what_it_may() {
        let mut storage = ListStorage::<200, 20>::new();
        let mut list = storage.list();
        draw(&mut list, &High(7)).unwrap();
        let (mut cells, mut depths) = ([0; 64], [0; 64]);
        let mut strip = Strip::new(8, &mut cells).unwrap().with_depth(&mut depths).unwrap();
        list.render(0..8, &mut strip);
        assert_eq!(strip.colours()[..8], [7, 7, 8, 8, 7, 7, 0, 0]);
        // Another's triangles stay its own. The same again takes no place more, and what draws by itself takes none beside it.
        draw(&mut list, &Low(7)).unwrap();
        draw(&mut list, &High(7)).unwrap();
        assert_eq!(list.shaders.len(), 3);
        let triangles = &list.contents.triangles[..list.contents.used_triangles];
        let places = triangles.iter().map(|triangle| triangle.shader);
        assert!(places.eq([0, 0, 1, 1, 0, 0, 2, 2, 2, 2, 2, 2, 0, 0, 1, 1, 0, 0]));
        strip.clear();
        list.render(0..8, &mut strip);
        assert_eq!(strip.colours()[..8], [7, 7, 8, 8, 7, 7, 0, 0]);
    }

    // Red when only one of two shaders is kept where there is but one place, or one is left where nothing is drawn.
    #[test]
    fn a_shader_and_its_simpler_one_are_kept_together() {
        let mut storage = ListStorage::<1000, 200>::new();
        let mut list = storage.list();
        for word in 20..35 {
            draw(&mut list, &Low(word)).unwrap();
        }
        let before = (list.stats(), list.words());
        assert_eq!(draw(&mut list, &High(7)), Err(DrawError::TooManyShaders));
        assert_eq!((list.shaders.len(), (list.stats(), list.words())), (15, before));
        draw(&mut list, &Low(35)).unwrap();
        assert_eq!(draw(&mut list, &Low(36)), Err(DrawError::TooManyShaders));
    }
}

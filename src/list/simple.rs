//! Which triangles of a draw a simpler shader draws: found once, in whatever strips they are.

use super::render::{carried, stride, triangle};
use super::{Contents, DrawFn, Kept, SIMPLE, Shaders};
use crate::attributes::Words;
use crate::depth::Depth;
use crate::raster::Traversal;
use crate::shade::PixelShader;

/// The simpler shader of another, of the same vertices and uniforms.
pub(super) struct Simple<'a, P, D: Depth> {
    /// The function that draws its pixels.
    pub(super) draw: DrawFn<'a, P, D>,
    /// Hands it those of a draw's triangles, from the given one on, that it may draw. Only shaders that have a simpler one link it.
    pub(super) simplify: fn(&Shaders<'a, P, D>, &mut Contents<'_>, usize),
}

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
}

fn simplify<'a, P, D: Depth, S: PixelShader<'a, P>>(
    shaders: &Shaders<'a, P, D>,
    contents: &mut Contents<'_>,
    first: usize,
) {
    let Contents { words, triangles, used_triangles, .. } = contents;
    let triangles = triangles.get_mut(first..*used_triangles).unwrap_or_default();
    // All are of one draw.
    let Some(Kept { uniforms, block, .. }) = triangles.first().and_then(|one| shaders.get(one.shader()))
    else {
        return;
    };
    let Some(words) = words.get(block.base()..) else { return };
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
            triangle.shader |= SIMPLE;
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

    // Red when all triangles are simple, or none; when those of another draw are marked, or a shader that has no simpler one is
    // taken for one that has; and when a simpler shader takes vertices to have no more words than it needs.
    #[test]
    fn a_simpler_shader_draws_what_it_may() {
        let mut storage = ListStorage::<200, 20>::new();
        let mut list = storage.list();
        draw(&mut list, &High(7)).unwrap();
        let (mut cells, mut depths) = ([0; 64], [0; 64]);
        let mut strip = Strip::new(8, &mut cells).unwrap().with_depth(&mut depths).unwrap();
        list.render(0..8, &mut strip);
        assert_eq!(strip.colours()[..8], [7, 7, 8, 8, 7, 7, 0, 0]);
        // Another's triangles stay its own, and the same shader again takes no place more.
        draw(&mut list, &Low(7)).unwrap();
        draw(&mut list, &High(7)).unwrap();
        let triangles = &list.contents.triangles[..list.contents.used_triangles];
        let shaders = triangles.iter().map(|triangle| triangle.shader);
        const S: u8 = SIMPLE;
        assert!(shaders.eq([0, 0, S, S, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, S, S, 0, 0]));
        strip.clear();
        list.render(0..8, &mut strip);
        assert_eq!(strip.colours()[..8], [7, 7, 8, 8, 7, 7, 0, 0]);
    }

    // Red when a simpler shader takes a place of its own, or the last place's triangles are taken for another's.
    #[test]
    fn a_simpler_shader_takes_no_place() {
        let mut storage = ListStorage::<1000, 200>::new();
        let mut list = storage.list();
        for word in 20..35 {
            draw(&mut list, &Low(word)).unwrap();
        }
        let first = list.contents.used_triangles;
        draw(&mut list, &High(7)).unwrap();
        let last = &list.contents.triangles[first..list.contents.used_triangles];
        assert!(last.iter().all(|triangle| triangle.shader() == 15));
        assert_eq!(last.iter().filter(|triangle| triangle.shader & SIMPLE != 0).count(), 2);
        assert_eq!(draw(&mut list, &Low(36)), Err(DrawError::TooManyShaders));
    }
}

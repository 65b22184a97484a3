//! One mesh on its way into the list: its vertices in words, and what is left of a face that is cut.

use core::marker::PhantomData;

use super::placed::{FaceColours, Placed, UNSEEN};
use super::render::stride;
use crate::attributes::{Carried, Fraction, Words, carried, mixed};
use crate::clip::{ClipVertex, Outcode, Polygon, add, clip};
use crate::depth::Depth;
use crate::math::recip::Reciprocal;
use crate::mesh::Mesh;
use crate::shade::{PixelShader, Shader};
use crate::transform::{PerVertexInverse, Position, Projection, Transform};

/// The vertex half of a shader over a mesh.
pub(super) trait VertexShader: FaceColours {
    /// What a vertex carries.
    fn vertex(&self, vertex: usize) -> Carried;

    /// What a vertex between two others carries.
    fn mix(&self, from: &Carried, to: &Carried, at: Fraction) -> Carried;
}

/// A shader's vertex half, with what it computes once a mesh.
pub(super) struct Shaded<'m, 'a, S: Shader<'a, P>, P> {
    pub(super) mesh: &'m Mesh<'m>,
    pub(super) shader: &'m S,
    pub(super) local: S::Local,
    pub(super) types: PhantomData<(&'a (), P)>,
}

impl<'a, S: Shader<'a, P>, P> VertexShader for Shaded<'_, 'a, S, P> {
    fn vertex(&self, vertex: usize) -> Carried {
        carried(self.shader.vertex(&self.local, self.mesh, vertex))
    }

    fn mix(&self, from: &Carried, to: &Carried, at: Fraction) -> Carried {
        mixed::<<S::Pixel as PixelShader<'a, P>>::Vertex>(from, to, at)
    }
}

impl<'a, S: Shader<'a, P>, P> FaceColours for Shaded<'_, 'a, S, P> {
    fn face(&self, face: usize) -> [u8; 3] {
        self.shader.face(&self.local, self.mesh, face)
    }
}

/// What the words of a vertex are.
pub(super) struct Layout {
    /// How many there are.
    pub(super) stride: u8,
    /// How many are for the shader.
    carried: u8,
    /// Whether 1/w is one of them.
    inverse: bool,
    /// Whether vertices have a w each.
    perspective: bool,
    /// What makes the word of depth, if there is one. One such function is linked for each way to hide that is used.
    depth: Option<fn(&Position, Reciprocal) -> u32>,
}

impl Layout {
    /// Before a camera with or without perspective.
    pub(super) const fn of<'a, P, D: Depth, S: PixelShader<'a, P>>(perspective: bool) -> Self {
        Self {
            carried: S::Vertex::WORDS as u8,
            inverse: S::PERSPECTIVE,
            perspective,
            depth: if D::Vertex::WORDS == 0 { None } else { Some(depth::<D>) },
            ..Self::written::<P, D, S>()
        }
    }

    /// Of vertices whose words are written without it.
    pub(super) const fn written<'a, P, D: Depth, S: PixelShader<'a, P>>() -> Self {
        let stride = const { stride::<P, D, S>() as u8 };
        Self { stride, carried: 0, inverse: false, perspective: false, depth: None }
    }
}

/// The word of a vertex's depth.
fn depth<D: Depth>(position: &Position, inverse: Reciprocal) -> u32 {
    let mut depth = 0;
    D::vertex(|| Projection::nearness(position, inverse)).store(&mut |word| depth = word);
    depth
}

/// One mesh on its way into the list.
pub(super) struct Drawing<'m> {
    pub(super) transform: &'m Transform,
    pub(super) mesh: &'m Mesh<'m>,
    pub(super) shaded: &'m dyn VertexShader,
    pub(super) layout: &'m Layout,
    pub(super) placed: Placed<'m>,
}

impl Drawing<'_> {
    /// Writes all vertices of the mesh, those that can be seen and the planes that others lie outside of.
    pub(super) fn vertices(&self, mut words: &mut [u32]) {
        for (vertex, &position) in self.mesh.positions().iter().enumerate() {
            let Some((here, rest)) = words.split_at_mut_checked(self.placed.stride()) else { break };
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
        let [to_x, to_y, rest @ ..] = words else { return };
        (*to_x, *to_y) = (x.cast_unsigned(), y.cast_unsigned());
        let mut words = rest.iter_mut();
        let mut put = |word: u32| {
            if let Some(place) = words.next() {
                *place = word;
            }
        };
        if let Some(depth) = self.layout.depth {
            put(depth(position, inverse));
        }
        for &word in carried.iter().take(usize::from(self.layout.carried)) {
            put(word);
        }
        if self.layout.inverse {
            PerVertexInverse::new(inverse).store(&mut put);
        }
    }

    /// Writes a polygon's vertices, from one of them on.
    #[inline(never)]
    pub(super) fn store_from(&self, place: usize, polygon: &Polygon, mut words: &mut [u32]) {
        let mut place = place;
        for _ in 0..polygon.len() {
            let Some((here, rest)) = words.split_at_mut_checked(self.placed.stride()) else { break };
            let Some(vertex) = polygon.get(place) else { break };
            self.store(here, &vertex.position, &vertex.carried);
            words = rest;
            place += 1;
            if place == polygon.len() {
                place = 0;
            }
        }
    }

    /// One over w, which all vertices share where there is no perspective.
    #[inline]
    fn inverse(&self, position: &Position) -> Reciprocal {
        if self.layout.perspective { Projection::inverse(position.w) } else { self.transform.level_inverse }
    }

    /// What is left of a face inside the planes, in one of two places.
    pub(super) fn polygon<'p>(
        &self,
        corners: [u16; 3],
        planes: Outcode,
        places: &'p mut [Polygon; 2],
    ) -> &'p Polygon {
        let [triangle, _] = &mut *places;
        for &corner in &corners {
            let vertex = usize::from(corner);
            // A mesh has all that its faces name.
            let Some(position) = self.mesh.positions().get(vertex) else { break };
            let position = self.transform.position_of_one(position);
            add(triangle, &ClipVertex { position, carried: self.shaded.vertex(vertex) });
        }
        let mix = |from: &Carried, to: &Carried, at| self.shaded.mix(from, to, at);
        clip(planes, &self.transform.projection, &mix, places)
    }
}

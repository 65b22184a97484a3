//! Into the list: a mesh's vertices to the screen, its faces culled, clipped and put in canonical order.

use core::marker::PhantomData;

use super::drawing::{Drawing, Layout, Shaded, VertexShader};
use super::placed::Placed;
use super::render::{self, stride};
use super::{Block, DrawError, DrawFn, DrawList, Kept, MAX_NAMED};
use crate::camera::Camera;
use crate::clip::MOST_CORNERS;
use crate::depth::Depth;
use crate::math::matrix::Matrix;
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::raster::Traversal;
use crate::retained::Records;
use crate::shade::{PixelShader, Shader, Uniforms};
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
        let uniforms = shader.pixel().uniforms();
        let kind = &const { Kind::of::<C, T, S::Pixel>() };
        self.place(camera, mesh, pose, &shaded, &uniforms, kind)
    }

    /// Places a mesh before a camera, and adds it if any of it can be seen. This, too, is linked once.
    #[inline(never)]
    fn place(
        &mut self,
        camera: &dyn View,
        mesh: &Mesh<'_>,
        pose: &Pose,
        shaded: &dyn VertexShader,
        uniforms: &Uniforms<'a>,
        kind: &Kind<'a, P, D>,
    ) -> Result<(), DrawError> {
        let (viewport, matrix) = camera.view();
        let viewport = viewport?;
        let transform = Transform::new(viewport, matrix, mesh, pose);
        let faces = mesh.faces().len();
        if faces == 0 || transform.misses(mesh.bounds()) {
            self.contents.stats.faces += faces;
            self.contents.stats.outside += faces;
            return Ok(());
        }
        let before = self.mark();
        // With all of its faces cut.
        let vertices = mesh.positions().len() + MOST_CORNERS * faces;
        let (kept, base) = self.keep(uniforms, kind, vertices)?;
        self.contents.size = [viewport.width(), viewport.height()];
        self.contents.stats.faces += faces;
        let placed = Placed { colours: shaded, stride: kind.stride as u8, kept, base };
        let added = self.contents.add(&Drawing { transform: &transform, mesh, shaded, layout: kind.layout, placed }, before.words);
        self.forget(before);
        added
    }

    /// What a draw that does not fit goes back to.
    pub(super) fn mark(&self) -> Mark {
        Mark { words: self.contents.used_words, shaders: self.shaders.len() }
    }

    /// Goes back to the shaders before a draw of which nothing is in the list.
    pub(super) fn forget(&mut self, before: Mark) {
        if self.contents.used_words == before.words {
            self.shaders.truncate(before.shaders);
        }
    }

    /// Where a shader is kept, and the first word of its vertices: the same place as an equal one before it, as long
    /// as its triangles can name as many `vertices` more.
    pub(super) fn keep(
        &mut self,
        uniforms: &Uniforms<'a>,
        &Kind { draw, stride, .. }: &Kind<'a, P, D>,
        vertices: usize,
    ) -> Result<(u8, usize), DrawError> {
        // What comes now may need the words that planes are kept in.
        self.contents.records = Records::NONE;
        for (place, kept) in self.shaders.iter().enumerate() {
            let base = kept.block.base();
            let named = (self.contents.used_words - base + stride - 1).checked_div(stride).unwrap_or_default();
            let same = core::ptr::fn_addr_eq(kept.draw, draw) && kept.uniforms.is(uniforms);
            if same && named + vertices <= MAX_NAMED {
                // Other shaders' vertices may lie between: the next ones start at a whole number of these.
                self.contents.used_words = base + named * stride;
                return Ok((place as u8, base));
            }
        }
        let base = self.contents.used_words;
        let block = Block::new(base, stride);
        self.shaders
            .push(Kept { uniforms: *uniforms, draw, block })
            .map_err(|_| DrawError::TooManyShaders)?;
        Ok(((self.shaders.len() - 1) as u8, base))
    }
}

/// What a camera knows.
trait View {
    fn view(&self) -> (Result<Viewport, TooLarge>, &Matrix);
}

impl<C: Camera> View for C {
    fn view(&self) -> (Result<Viewport, TooLarge>, &Matrix) {
        (self.viewport(), self.matrix())
    }
}

/// What all draws with a pixel shader share: the function that draws its pixels, how many words a vertex has, and what they
/// are.
pub(super) struct Kind<'a, P, D: Depth> {
    draw: DrawFn<'a, P, D>,
    pub(super) stride: usize,
    layout: Layout,
}

impl<'a, P: Copy, D: Depth> Kind<'a, P, D> {
    /// Before a camera.
    const fn of<C: Camera, T: Traversal, S: PixelShader<'a, P>>() -> Self {
        Self {
            draw: render::triangle::<P, D, T, S>,
            stride: stride::<P, D, S>(),
            layout: Layout::of::<P, D, S>(C::PERSPECTIVE),
        }
    }

    /// Of vertices that are on the screen already.
    pub(super) const fn projected<T: Traversal, S: PixelShader<'a, P>>() -> Self {
        Self { draw: render::triangle::<P, D, T, S>, stride: stride::<P, D, S>(), layout: Layout::NOTHING }
    }
}

/// What a list holds before a draw.
pub(super) struct Mark {
    pub(super) words: usize,
    shaders: usize,
}

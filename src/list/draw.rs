//! Into the list: a mesh's vertices to the screen, its faces culled, clipped and put in canonical order.

use core::marker::PhantomData;

use super::contents::Home;
use super::drawing::{Layout, Shaded, VertexShader};
use super::render;
use super::simple::Simple;
use super::{Block, Contents, DrawError, DrawFn, DrawList, Kept, Shaders};
use crate::camera::Camera;
use crate::depth::Depth;
use crate::math::matrix::Matrix;
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::raster::Traversal;
use crate::retained::Records;
use crate::shade::{PixelShader, Shader, Uniforms};
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
        let (viewport, matrix) = (camera.viewport(), camera.matrix());
        let seen = Seen { viewport, matrix, mesh, pose, shaded: &shaded, layout: &kind.layout };
        self.place(&seen, &uniforms, kind)
    }

    /// Adds a mesh, with its shader if any of it can be seen. This is linked once for each kind of list, and what it calls
    /// once for all.
    #[inline(never)]
    fn place(
        &mut self,
        seen: &Seen<'_>,
        uniforms: &Uniforms<'a>,
        kind: &Kind<'a, P, D>,
    ) -> Result<(), DrawError> {
        let Self { contents, shaders, .. } = self;
        let (words, triangles, kept) = (contents.used_words, contents.used_triangles, shaders.len());
        let added =
            contents.place(seen, &mut |contents, vertices| keep(shaders, contents, uniforms, kind, vertices));
        forget(shaders, contents, words, kept);
        if let Some(simple) = &kind.simple {
            (simple.simplify)(shaders, contents, triangles);
        }
        added
    }
}

/// Goes back to the shaders before a draw of which nothing is in the list.
pub(super) fn forget<P, D: Depth>(
    shaders: &mut Shaders<'_, P, D>,
    contents: &Contents<'_>,
    words: usize,
    kept: usize,
) {
    if contents.used_words == words {
        shaders.truncate(kept);
    }
}

/// Where a shader is kept: in the same place as an equal one before it, as long as its triangles can name as many `vertices`
/// more.
pub(super) fn keep<'a, P, D: Depth>(
    shaders: &mut Shaders<'a, P, D>,
    contents: &mut Contents<'_>,
    uniforms: &Uniforms<'a>,
    Kind { draw, simple, layout: Layout { stride, .. } }: &Kind<'a, P, D>,
    vertices: usize,
) -> Result<Home, DrawError> {
    // What comes now may need the words that planes are kept in.
    contents.records = Records::NONE;
    let stride = usize::from(*stride);
    for (place, kept) in shaders.iter().enumerate() {
        let same = core::ptr::fn_addr_eq(kept.draw, *draw) && kept.uniforms.is(uniforms);
        if !same {
            continue;
        }
        let base = kept.block.base();
        if let Some(first) = contents.follow(base, stride, vertices) {
            return Ok(Home { kept: place as u8, base, first });
        }
    }
    let base = contents.used_words;
    let block = Block::new(base, stride);
    let simple = simple.as_ref().map(|simple| simple.draw);
    let kept = Kept { uniforms: *uniforms, draw: *draw, simple, block };
    shaders.push(kept).map_err(|_| DrawError::TooManyShaders)?;
    Ok(Home { kept: (shaders.len() - 1) as u8, base, first: 0 })
}

/// A mesh before a camera, and what its vertices carry.
pub(super) struct Seen<'m> {
    pub(super) viewport: Result<Viewport, TooLarge>,
    pub(super) matrix: &'m Matrix,
    pub(super) mesh: &'m Mesh<'m>,
    pub(super) pose: &'m Pose,
    pub(super) shaded: &'m dyn VertexShader,
    pub(super) layout: &'m Layout,
}

/// What all draws with a pixel shader share: the function that draws its pixels, and what the words of a vertex are.
pub(super) struct Kind<'a, P, D: Depth> {
    draw: DrawFn<'a, P, D>,
    pub(super) simple: Option<Simple<'a, P, D>>,
    pub(super) layout: Layout,
}

impl<'a, P: Copy, D: Depth> Kind<'a, P, D> {
    /// Before a camera.
    const fn of<C: Camera, T: Traversal, S: PixelShader<'a, P>>() -> Self {
        Self { layout: Layout::of::<P, D, S>(C::PERSPECTIVE), ..Self::projected::<T, S>() }
    }

    /// Of vertices that are on the screen already.
    pub(super) const fn projected<T: Traversal, S: PixelShader<'a, P>>() -> Self {
        let layout = Layout::written::<P, D, S>();
        Self { draw: render::triangle::<P, D, T, S>, simple: Simple::of::<T, S>(), layout }
    }
}

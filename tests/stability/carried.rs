//! What the library's pipeline carries to the pixels of one triangle, from a mesh to the cells of strips.

use embedded_graphics::prelude::*;
use topleft::stages::{PerVertexInverse, PixelShader, Run, Shader, Uniforms, Varying};
use topleft::{
    Attribute, Cull, Depth, Depth16, DrawList, Length, ListTriangle, Mesh, Orthographic, Pixel, Pose, Spans,
};

use crate::support::frame::{Frame, rendered};

/// Columns and rows of the target.
pub(crate) const SIDE: i32 = 64;

/// A cell that holds the value at its pixel, all bits of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Value(pub(crate) Option<i32>);

impl Pixel for Value {
    const MAX: [u8; 3] = [0; 3];
    type Stepped = [Attribute; 3];

    fn from_channels(_: [u8; 3]) -> Self {
        Self(None)
    }

    fn channels(self) -> [u8; 3] {
        [0; 3]
    }

    fn from_texel(_: u16) -> Self {
        Self(None)
    }
}

/// A value at each corner.
struct Corners([Attribute; 3]);

#[derive(Clone, Copy)]
struct Linear;

impl<'a> Shader<'a, Value> for Corners {
    type Pixel = Linear;
    type Local = ();

    fn pixel(&self) -> Linear {
        Linear
    }

    fn local(&self, _: &Mesh<'_>, _: &Pose) {}

    fn vertex(&self, (): &(), _: &Mesh<'_>, vertex: usize) -> Attribute {
        self.0[vertex]
    }

    fn face(&self, (): &(), _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

impl<'a> PixelShader<'a, Value> for Linear {
    type Vertex = Attribute;
    type Varying = Attribute;
    type Triangle = ();
    type Simple = Self;
    const PERSPECTIVE: bool = false;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms::NONE
    }

    fn from_uniforms(_: &Uniforms<'a>) -> Self {
        Self
    }

    fn triangle(&self, _: [u8; 3], values: [Attribute; 3], _: [PerVertexInverse; 3]) -> ((), [Attribute; 3]) {
        ((), values)
    }

    fn shade<D: Depth>(&self, (): &(), start: Attribute, step: &Attribute, run: Run<'_, Value, D>) {
        let mut value = start;
        for place in run.pixels() {
            place.shade(|| Value(Some(value.to_bits())));
            value = value.plus(*step);
        }
    }
}

/// The target by strips of each of these heights.
///
/// Corners are in parts of 2^-15 of `half` pixels from the target's centre, to the right and down, and are moved by
/// `moved` pixels. The matrix has powers of two only, but for its depths.
pub(crate) fn in_strips<const N: usize>(
    corners: [[i16; 2]; 3],
    half: u32,
    moved: [Length; 2],
    values: [Attribute; 3],
    heights: [i32; N],
) -> [Frame<Value>; N] {
    let size = Size::new(SIDE.unsigned_abs(), SIDE.unsigned_abs());
    let camera = Orthographic::new(size, SIDE as f32, -64.0..64.0);
    let positions = corners.map(|[x, y]| [x, -y, x / 2]);
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).expect("three vertices");
    let mesh = mesh.with_box([Length::ZERO; 3], Length::from_num(half));
    let [x, y] = moved;
    let (mut words, mut triangles) = ([0; 64], [ListTriangle::EMPTY; 8]);
    let mut list = DrawList::<Value, Depth16, Spans>::with_traversal(&mut words, &mut triangles);
    list.set_cull(Cull::None);
    let pose = Pose::new().at([x, -y, Length::ZERO]);
    list.draw(&camera, &mesh, &pose, &Corners(values)).expect("it fits");
    heights.map(|height| rendered(&list, SIDE as usize, 0..SIDE, height as usize, Value(None)))
}

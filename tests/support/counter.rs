//! Counting: a cell and a shader that count what hits a pixel, and a display that counts what is sent to it.

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use topleft::stages::{PerVertexInverse, PixelShader, Run, Shader, Traversal, Uniforms};
use topleft::{
    Attribute, Camera, Cull, Depth, DrawList, ListTriangle, Mesh, NoDepth, Pixel as Cell, Pose, Spans, Strip,
};

/// A cell of a strip that adds up what hits it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Hits(pub(crate) i32);

impl Cell for Hits {
    const MAX: [u8; 3] = [0; 3];
    type Stepped = [Attribute; 3];

    fn from_channels(_: [u8; 3]) -> Self {
        Self(0)
    }

    fn channels(self) -> [u8; 3] {
        [0; 3]
    }

    fn from_texel(_: u16) -> Self {
        Self(0)
    }
}

/// Adds a number to each pixel of a mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Add(pub(crate) i32);

impl<'a> Shader<'a, Hits> for Add {
    type Pixel = Self;
    type Local = ();

    fn pixel(&self) -> Self {
        *self
    }

    fn local(&self, _: &Mesh<'_>, _: &Pose) {}

    fn vertex(&self, (): &(), _: &Mesh<'_>, _: usize) {}

    fn face(&self, (): &(), _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

impl<'a> PixelShader<'a, Hits> for Add {
    type Vertex = ();
    type Varying = ();
    type Triangle = ();
    type Simple = Self;
    const PERSPECTIVE: bool = false;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms { words: [self.0.cast_unsigned(), 0], ..Uniforms::NONE }
    }

    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
        Self(uniforms.words[0].cast_signed())
    }

    fn triangle(&self, _: [u8; 3], _: [(); 3], _: [PerVertexInverse; 3]) -> ((), [(); 3]) {
        ((), [(); 3])
    }

    fn shade<D: Depth>(&self, (): &(), (): (), (): &(), run: Run<'_, Hits, D>) {
        for place in run.pixels() {
            place.blend(|cell| cell.0 += self.0);
        }
    }
}

/// A mesh's hits at each pixel of a frame, in rows from the top, and the words of its list: x and y of each vertex, in
/// 1/256 px, before those that clipping made.
pub(crate) struct Drawn {
    pub(crate) hits: Vec<i32>,
    pub(crate) words: Vec<u32>,
    pub(crate) clipped: usize,
}

/// Draws a mesh once for each entry of `passes`, adding its number to the pixels of the faces that it leaves in.
pub(crate) fn draw(camera: &impl Camera, mesh: &Mesh<'_>, pose: &Pose, passes: &[(Cull, i32)]) -> Drawn {
    draw_by::<Spans>(camera, mesh, pose, passes)
}

/// The same by a traversal.
pub(crate) fn draw_by<T: Traversal>(
    camera: &impl Camera,
    mesh: &Mesh<'_>,
    pose: &Pose,
    passes: &[(Cull, i32)],
) -> Drawn {
    let size = camera.viewport().expect("the target is not too large").size();
    let mut cells = vec![Hits(0); (size.width * size.height) as usize];
    let mut drawn = listed::<T>(camera, mesh, pose, passes, |list| {
        let mut strip = Strip::new(size.width as u16, &mut cells).expect("there is a cell for each pixel");
        list.render(0..size.height.cast_signed(), &mut strip);
    });
    drawn.hits = cells.iter().map(|cell| cell.0).collect();
    drawn
}

/// A mesh in a list, and no pixel drawn.
pub(crate) fn placed(camera: &impl Camera, mesh: &Mesh<'_>, pose: &Pose) -> Drawn {
    listed::<Spans>(camera, mesh, pose, ALL, |_| {})
}

fn listed<T: Traversal>(
    camera: &impl Camera,
    mesh: &Mesh<'_>,
    pose: &Pose,
    passes: &[(Cull, i32)],
    then: impl FnOnce(&DrawList<'_, Hits, NoDepth, T>),
) -> Drawn {
    // Two words a vertex; clipping makes up to nine vertices, and seven triangles, of a face.
    let most = mesh.faces().len() * passes.len();
    let mut words = vec![0; (mesh.positions().len() * passes.len() + most * 9) * 2];
    let mut triangles = vec![ListTriangle::EMPTY; most * 7];
    let mut list = DrawList::<Hits, NoDepth, T>::with_traversal(&mut words, &mut triangles);
    for &(cull, number) in passes {
        list.set_cull(cull);
        list.draw(camera, mesh, pose, &Add(number)).expect("the list is long enough");
    }
    then(&list);
    let (clipped, used) = (list.stats().clipped, list.words());
    drop(list);
    words.truncate(used);
    Drawn { hits: Vec::new(), words, clipped }
}

/// How many triangles hit each pixel, whichever way they face.
pub(crate) const ALL: &[(Cull, i32)] = &[(Cull::None, 1)];
/// How many triangles that show their front hit each pixel.
pub(crate) const FRONTS: &[(Cull, i32)] = &[(Cull::Back, 1)];
/// How many triangles that show their back hit each pixel.
pub(crate) const BACKS: &[(Cull, i32)] = &[(Cull::Front, 1)];
/// Front hits minus back hits: the winding number.
pub(crate) const WINDING: &[(Cull, i32)] = &[(Cull::Back, 1), (Cull::Front, -1)];

/// A display anywhere on the plane that is strict: it panics where a pixel outside its box is sent, or a fill does not
/// bring exactly one colour for each pixel. It counts pixels and calls, and can fail at one of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StrictDisplay<C> {
    area: Rectangle,
    /// In rows from the top left of the box: the last colour, and how often the pixel was sent.
    pub(crate) pixels: Vec<Option<C>>,
    pub(crate) writes: Vec<u32>,
    /// Calls of `draw_iter`, `fill_contiguous`, `fill_solid` and `clear`.
    pub(crate) calls: [usize; 4],
    fails_at: usize,
}

/// What a [`StrictDisplay`] fails with: the number of the call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Refused(pub(crate) usize);

impl<C: PixelColor> StrictDisplay<C> {
    pub(crate) fn new(area: Rectangle) -> Self {
        let pixels = (area.size.width * area.size.height) as usize;
        Self {
            area,
            pixels: vec![None; pixels],
            writes: vec![0; pixels],
            calls: [0; 4],
            fails_at: usize::MAX,
        }
    }

    /// The same display, which refuses the call of that number, counted from 0.
    pub(crate) fn failing_at(self, call: usize) -> Self {
        Self { fails_at: call, ..self }
    }

    /// Calls of all kinds.
    pub(crate) fn all_calls(&self) -> usize {
        self.calls.iter().sum()
    }

    fn call(&mut self, kind: usize) -> Result<(), Refused> {
        let number = self.all_calls();
        self.calls[kind] += 1;
        if number == self.fails_at { Err(Refused(number)) } else { Ok(()) }
    }

    fn set(&mut self, at: Point, colour: C) {
        assert!(self.area.contains(at), "{at:?} is sent, and is outside of {:?}", self.area);
        let within = at - self.area.top_left;
        let index = within.y as usize * self.area.size.width as usize + within.x as usize;
        self.pixels[index] = Some(colour);
        self.writes[index] += 1;
    }
}

impl<C> Dimensions for StrictDisplay<C> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: PixelColor> DrawTarget for StrictDisplay<C> {
    type Color = C;
    type Error = Refused;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Refused> {
        self.call(0)?;
        for Pixel(at, colour) in pixels {
            self.set(at, colour);
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Refused> {
        self.call(1)?;
        let mut colours = colours.into_iter();
        for at in area.points() {
            let colour = colours.next().unwrap_or_else(|| panic!("{area:?} has no colour at {at:?}"));
            self.set(at, colour);
        }
        assert!(colours.next().is_none(), "{area:?} has more colours than pixels");
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: C) -> Result<(), Refused> {
        self.call(2)?;
        for at in area.points() {
            self.set(at, colour);
        }
        Ok(())
    }

    fn clear(&mut self, colour: C) -> Result<(), Refused> {
        self.call(3)?;
        let area = self.area;
        for at in area.points() {
            self.set(at, colour);
        }
        Ok(())
    }
}

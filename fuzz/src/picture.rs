//! Meshes drawn in every way that must not differ: by both traversals, in strips of any height, to a display, and from a
//! list each.

use std::fmt::Debug;
use std::ops::Range;

use arbitrary::Arbitrary;
use embedded_graphics::prelude::{PixelColor, Point, RgbColor, Size};
use embedded_graphics::primitives::Rectangle;
use topleft::stages::Traversal;
use topleft::{
    Affine, Attribute, BoxWalk, BySize, Camera, ColourError, Cull, Divided, DrawError, DrawList, Flat,
    Gouraud, ListTriangle, Material, Mesh, PerPixel, Pixel, Portable, Pose, Spans, Stats, Subspans, Sun,
    Texture, Textured, Viewport, Within,
};

use crate::lens::Seen;
use crate::support::counter::StrictDisplay;
use crate::support::frame::{Frame, Strips, rendered};
use crate::support::same;
use crate::support::stats::adds_up;

/// The library's shaders.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub(crate) enum Look {
    Flat,
    FlatLit,
    Gouraud,
    GouraudLit,
    Affine,
    AffineLit,
    PerPixel,
    PerPixelLit,
    Subspans,
    Within,
    WithinLit,
    Divided,
    GouraudWithin,
}

impl Look {
    pub(crate) const ALL: [Self; 13] = [
        Self::Flat,
        Self::FlatLit,
        Self::Gouraud,
        Self::GouraudLit,
        Self::Affine,
        Self::AffineLit,
        Self::PerPixel,
        Self::PerPixelLit,
        Self::Subspans,
        Self::Within,
        Self::WithinLit,
        Self::Divided,
        Self::GouraudWithin,
    ];
}

/// A mesh in its place.
pub(crate) struct Item<'a> {
    pub(crate) mesh: Mesh<'a>,
    pub(crate) pose: Pose,
    pub(crate) cull: Cull,
    pub(crate) look: Look,
    pub(crate) material: Material,
    pub(crate) sun: Sun,
    pub(crate) texture: Texture<'a>,
}

/// What is drawn, who sees it, and which part of it is looked at.
pub(crate) struct Picture<'a> {
    pub(crate) size: Size,
    pub(crate) camera: Seen,
    pub(crate) items: Vec<Item<'a>>,
    /// Words and triangles of the list.
    pub(crate) storage: [usize; 2],
    /// At least one of each, and few.
    pub(crate) columns: usize,
    pub(crate) rows: Range<i32>,
    /// Rows of a strip, at least one.
    pub(crate) height: usize,
    /// Columns and rows of a display.
    pub(crate) display: [u32; 2],
}

/// What drawing returned, and the list's figures after it, one a mesh.
type Outcomes = Vec<(Result<(), DrawError>, Stats)>;

impl Picture<'_> {
    /// Draws the picture in all ways, and gives back what is to be seen of it.
    pub(crate) fn check<P, D>(&self) -> Result<Frame<P>, String>
    where
        P: Pixel + PixelColor + RgbColor + Debug,
        D: Strips,
    {
        let (outcomes, frame) = self.by::<P, D, Spans>()?;
        let (others, other) = self.by::<P, D, BoxWalk>()?;
        other.same("the other traversal", &frame)?;
        if outcomes != others {
            return Err(format!("{outcomes:?} by one traversal, {others:?} by the other"));
        }
        self.by::<P, D, BySize>()?.1.same("the traversal by size", &frame)?;
        self.check_outcomes(&outcomes)?;
        if !D::SORTED && outcomes.iter().all(|(result, _)| result.is_ok()) {
            self.apart::<P, D>().same("a list for each mesh", &frame)?;
        }
        Ok(frame)
    }

    /// The frame from a list of its own for each mesh, which has room for it, one rendered over the other.
    fn apart<P, D>(&self) -> Frame<P>
    where
        P: Pixel + PixelColor + RgbColor + Debug,
        D: Strips,
    {
        let cells = self.columns * self.rows.len();
        let (mut colours, mut depths) = (vec![P::BLACK; cells], vec![7; cells]);
        let mut strip = D::strip(self.columns as u16, &mut colours, &mut depths);
        strip.clear();
        for item in &self.items {
            let [most_words, most_triangles] = most(item);
            let (mut words, mut triangles) = (vec![0; most_words], vec![ListTriangle::EMPTY; most_triangles]);
            let mut list = DrawList::<P, D, Spans>::with_traversal(&mut words, &mut triangles);
            // What it returns was looked at where all are in one list.
            let _ = self.add(&mut list, item);
            list.render(self.rows.clone(), &mut strip);
        }
        drop(strip);
        Frame { width: self.columns, colours, depths }
    }

    /// Draws a mesh into a list.
    fn add<'a, P, D, T>(&self, list: &mut DrawList<'a, P, D, T>, item: &Item<'a>) -> Result<(), DrawError>
    where
        P: Pixel,
        D: Strips,
        T: Traversal,
    {
        match &self.camera {
            Seen::Perspective(camera) => add(list, camera, item),
            Seen::Level(camera) => add(list, camera, item),
        }
    }

    fn by<P, D, T>(&self) -> Result<(Outcomes, Frame<P>), String>
    where
        P: Pixel + PixelColor + RgbColor + Debug,
        D: Strips,
        T: Traversal,
    {
        let [words, triangles] = self.storage;
        let (mut words, mut triangles) = (vec![0; words], vec![ListTriangle::EMPTY; triangles]);
        let mut list = DrawList::<P, D, T>::with_traversal(&mut words, &mut triangles);
        let draw = |item: &_| {
            let result = self.add(&mut list, item);
            (result, list.stats())
        };
        let outcomes = self.items.iter().map(draw).collect();
        D::sort(&mut list);
        if list.words() > self.storage[0] {
            return Err(format!("{} words in use of {}", list.words(), self.storage[0]));
        }
        let strips = |rows: Range<i32>, height| rendered(&list, self.columns, rows, height, P::BLACK);
        let frame = strips(self.rows.clone(), self.rows.len());
        strips(self.rows.clone(), self.height).same("strips", &frame)?;
        let shown = strips(0..self.display[1].cast_signed(), self.height);
        self.check_display(&mut list, &shown)?;
        Ok((outcomes, frame))
    }

    /// A display is sent what strips show, once.
    fn check_display<P, D, T>(&self, list: &mut DrawList<'_, P, D, T>, shown: &Frame<P>) -> Result<(), String>
    where
        P: Pixel + PixelColor + RgbColor + Debug,
        D: Strips,
        T: Traversal,
    {
        let [width, height] = self.display;
        let mut display = StrictDisplay::new(Rectangle::new(Point::new(-3, 5), Size::new(width, height)));
        let cells = self.columns * self.height;
        let (mut colours, mut depths) = (vec![P::BLACK; cells], vec![0; cells]);
        let mut strip = D::strip(self.columns as u16, &mut colours, &mut depths);
        list.present(&mut strip, &mut display).map_err(|error| format!("{error:?}"))?;
        let seen = |(index, _): (usize, _)| {
            let (x, y) = (index % width as usize, index / width as usize);
            (x < self.columns).then(|| shown.colours[y * self.columns + x])
        };
        let expected: Vec<Option<P>> = display.pixels.iter().enumerate().map(seen).collect();
        same("a display", width as usize, &display.pixels, &expected)?;
        let once: Vec<u32> = expected.iter().map(|pixel| pixel.is_some().into()).collect();
        same("writes to a display", width as usize, &display.writes, &once)
    }

    /// Every face is accounted for, and nothing is refused without a reason.
    fn check_outcomes(&self, outcomes: &Outcomes) -> Result<(), String> {
        let mut before = Stats::default();
        let mut needed = [0; 2];
        for (item, &(result, after)) in self.items.iter().zip(outcomes) {
            let faces = item.mesh.faces().len();
            let [words, triangles] = most(item);
            needed = [needed[0] + words, needed[1] + triangles];
            match (result, Viewport::new(self.size)) {
                (Err(DrawError::TooLarge(size)), Err(_)) if size == self.size && after == before => {}
                (_, Err(_)) => return Err(format!("{result:?} for a target of {}", self.size)),
                (Err(DrawError::Full { .. }), Ok(_))
                    if self.storage[0] >= needed[0] && self.storage[1] >= needed[1] =>
                {
                    return Err(format!("{result:?}, and {needed:?} are enough"));
                }
                (_, Ok(_)) => adds_up(before, after, result, faces)?,
            }
            before = after;
        }
        Ok(())
    }
}

/// The most words and triangles that a mesh takes: nine vertices and seven triangles of each face that is cut, and
/// padding; up to eight words a vertex.
fn most(item: &Item<'_>) -> [usize; 2] {
    let (faces, vertices) = (item.mesh.faces().len(), item.mesh.positions().len());
    [(vertices + 9 * faces + 1) * 8, 7 * faces]
}

/// Draws a mesh into a list by its shader.
fn add<'a, P: Pixel, D: Strips, T: Traversal>(
    list: &mut DrawList<'a, P, D, T>,
    camera: &impl Camera,
    item: &Item<'a>,
) -> Result<(), DrawError> {
    let Item { mesh, pose, cull, look, material, sun, texture } = item;
    list.set_cull(*cull);
    let affine = Textured::new(texture, Affine);
    let exact = Textured::new(texture, PerPixel);
    let within = Textured::new(texture, Within::default());
    // Some triangles of any colours are of one, and others are not.
    let rough = ColourError::codes(Attribute::lit("60"));
    match look {
        Look::Flat => list.draw(camera, mesh, pose, &Flat::new(*material)),
        Look::FlatLit => list.draw(camera, mesh, pose, &Flat::new(*material).lit_by(sun)),
        Look::Gouraud => list.draw(camera, mesh, pose, &Gouraud::unlit(material)),
        Look::GouraudLit => list.draw(camera, mesh, pose, &Gouraud::new(sun, material)),
        Look::Affine => list.draw(camera, mesh, pose, &affine),
        Look::AffineLit => list.draw(camera, mesh, pose, &affine.lit_by(sun)),
        Look::PerPixel => list.draw(camera, mesh, pose, &exact),
        Look::PerPixelLit => list.draw(camera, mesh, pose, &exact.lit_by(sun)),
        Look::Subspans => list.draw(camera, mesh, pose, &Textured::new(texture, Subspans::Of8)),
        Look::Within => list.draw(camera, mesh, pose, &within),
        Look::WithinLit => list.draw(camera, mesh, pose, &within.lit_by(sun)),
        Look::GouraudWithin => list.draw(camera, mesh, pose, &Gouraud::unlit(material).within(rough)),
        Look::Divided => list.draw(camera, mesh, pose, &Textured::new(texture, Divided::<Portable>::new())),
    }
}

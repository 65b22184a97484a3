//! Frames in memory, rendered from a list strip by strip.

use std::fmt::Debug;
use std::ops::Range;

use topleft::stages::Traversal;
use topleft::{Depth, Depth16, DepthFloat, DrawList, NoDepth, Painter, Pixel, Strip};

use super::same;

/// A frame's bytes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Frame<P = u16> {
    pub(crate) width: usize,
    pub(crate) colours: Vec<P>,
    pub(crate) depths: Vec<u16>,
}

impl<P: PartialEq + Debug> Frame<P> {
    pub(crate) fn same(&self, what: &str, expected: &Self) -> Result<(), String> {
        same(&format!("{what}: colour"), self.width, &self.colours, &expected.colours)?;
        same(&format!("{what}: depth"), self.width, &self.depths, &expected.depths)
    }

    /// Pixels where something was drawn, of a frame with depth.
    pub(crate) fn seen(&self) -> usize {
        self.depths.iter().filter(|&&depth| depth != 0).count()
    }
}

/// A depth, and how a strip of it is made: without depth, the depths stay as they are.
pub(crate) trait Strips: Depth + Sized {
    fn strip<'s, P: Pixel>(width: u16, colours: &'s mut [P], depths: &'s mut [u16]) -> Strip<'s, P, Self>;

    /// Whether a list has an order of its own, whatever it is drawn in.
    const SORTED: bool = false;

    /// Puts it in that order.
    fn sort<P, T>(_: &mut DrawList<'_, P, Self, T>) {}
}

impl Strips for NoDepth {
    fn strip<'s, P: Pixel>(width: u16, colours: &'s mut [P], _: &'s mut [u16]) -> Strip<'s, P, Self> {
        Strip::new(width, colours).expect("whole rows")
    }
}

impl Strips for Painter {
    const SORTED: bool = true;

    fn strip<'s, P: Pixel>(width: u16, colours: &'s mut [P], _: &'s mut [u16]) -> Strip<'s, P, Self> {
        Strip::new(width, colours).expect("whole rows").for_painter()
    }

    fn sort<P, T>(list: &mut DrawList<'_, P, Self, T>) {
        list.sort(&mut vec![[0; 3]; list.stats().drawn]).expect("as many");
    }
}

impl Strips for Depth16 {
    fn strip<'s, P: Pixel>(width: u16, colours: &'s mut [P], depths: &'s mut [u16]) -> Strip<'s, P, Self> {
        Strip::new(width, colours).expect("whole rows").with_depth(depths).expect("as many depths")
    }
}

impl Strips for DepthFloat {
    fn strip<'s, P: Pixel>(width: u16, colours: &'s mut [P], depths: &'s mut [u16]) -> Strip<'s, P, Self> {
        Strip::new(width, colours).expect("whole rows").with_depth_float(depths).expect("as many depths")
    }
}

/// Renders the first `columns` of some rows of a list by strips of `height` rows each.
pub(crate) fn rendered<P: Pixel, D: Strips, T: Traversal>(
    list: &DrawList<'_, P, D, T>,
    columns: usize,
    rows: Range<i32>,
    height: usize,
    background: P,
) -> Frame<P> {
    let cells = columns * rows.len();
    // What was there before must not matter.
    let before = P::from_channels([1; 3]);
    let mut frame = Frame { width: columns, colours: vec![before; cells], depths: vec![7; cells] };
    let strips = frame.colours.chunks_mut(height * columns).zip(frame.depths.chunks_mut(height * columns));
    for (number, (colours, depths)) in strips.enumerate() {
        let mut strip = D::strip(columns as u16, colours, depths).with_background(background);
        strip.clear();
        let top = rows.start + (number * height) as i32;
        list.render(top..top.saturating_add(height as i32), &mut strip);
    }
    frame
}

//! Drawing: an SVG, panels with two scales, markers, and labels that keep clear of each other.

mod canvas;
mod label;
mod marker;
mod panel;
mod scale;

pub(crate) use canvas::{Anchor, BLACK, Canvas, Colour, GREY, svg};
pub(crate) use label::Labels;
pub(crate) use marker::{Fill, Shape};
pub(crate) use panel::{Edge, Panel};
pub(crate) use scale::{Scale, short};

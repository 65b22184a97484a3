//! One row of a table.

use core::fmt;

/// What drawing one scene in one way costs: cycles, or instructions, whichever the clock counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The scene's name.
    pub scene: &'static str,
    /// How it is drawn.
    pub method: &'static str,
    /// Rows of a strip; as many as the panel has for a whole frame.
    pub strip_rows: usize,
    /// Triangles in the list, after culling and clipping.
    pub triangles: usize,
    /// Pixels that they cover, before the depth test.
    pub pixels: u32,
    /// Once a frame: vertices to the screen, faces culled and put in order, and all triangles sorted where that is
    /// how they are drawn.
    pub vertex: u64,
    /// Triangles taken from the list, and their planes; once a strip that they touch.
    pub setup: u64,
    /// Edges, spans, depths and colours.
    pub raster: u64,
    /// The background everywhere: colours, and depths if there are any.
    pub clear: u64,
    /// Of the frame's RGB565 words, row by row, the low byte first.
    pub crc: u32,
}

/// The names of what a [`Row`] writes.
impl Row {
    /// The first line of a table of rows.
    pub const HEADER: &'static str =
        "scene,method,opt_level,strip_rows,triangles,pixels,total,vertex,setup,raster,clear,crc";
}

/// Values with commas between them.
impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scene, method, strip_rows, triangles, pixels, vertex, setup, raster, clear, crc } = *self;
        let (opt_level, total) = (crate::OPT_LEVEL, setup + raster);
        write!(f, "{scene},{method},{opt_level},{strip_rows},{triangles},{pixels},")?;
        write!(f, "{total},{vertex},{setup},{raster},{clear},{crc:08x}")
    }
}

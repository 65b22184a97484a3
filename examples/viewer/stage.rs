//! A scene with the memory that it is drawn in: a list, and strips of some rows.

use std::time::{Duration, Instant};

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::SimulatorDisplay;
use scenes::{Scene, View};
use topleft::stages::Traversal;
use topleft::{Depth16, DrawList, ListTriangle, Pixel, Spans, Stats, Strip};

/// Words of a vertex with everything: position, depth, 1/w, texel and light.
const WORDS_A_VERTEX: usize = 7;

/// A scene and its memory.
pub(crate) struct Stage<'s> {
    pub(crate) scene: &'s Scene,
    pub(crate) size: Size,
    words: Vec<u32>,
    triangles: Vec<ListTriangle>,
    colours: Vec<Rgb565>,
    depths: Vec<u16>,
}

/// What a frame took.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Took {
    pub(crate) stats: Stats,
    pub(crate) vertices: Duration,
    pub(crate) pixels: Duration,
}

impl<'s> Stage<'s> {
    /// Memory for a scene on a display of `size` pixels, drawn some rows at a time.
    pub(crate) fn new(scene: &'s Scene, size: Size, rows: u16) -> Self {
        // A face that is clipped becomes at most seven triangles with nine vertices; few are, unless all are few.
        let (faces, vertices) = (scene.faces(), scene.vertices());
        let mut stage = Self {
            scene,
            size,
            words: vec![0; WORDS_A_VERTEX * (vertices + 3 * faces + 100)],
            triangles: vec![ListTriangle::EMPTY; 3 * faces + 100],
            colours: Vec::new(),
            depths: Vec::new(),
        };
        stage.set_rows(rows);
        stage
    }

    /// Draws as many rows at a time.
    pub(crate) fn set_rows(&mut self, rows: u16) {
        let pixels = self.size.width as usize * usize::from(rows).min(self.size.height as usize);
        self.colours = vec![Rgb565::from_rgb([0; 3]); pixels];
        self.depths = vec![0; pixels];
    }

    /// Draws a frame to the display, strip by strip.
    pub(crate) fn draw(
        &mut self,
        view: &View,
        display: &mut SimulatorDisplay<Rgb565>,
    ) -> Result<Took, String> {
        let start = Instant::now();
        let mut list: DrawList<'_, Rgb565, Depth16, Spans> =
            DrawList::with_traversal(&mut self.words, &mut self.triangles);
        self.scene.draw(&mut list, self.size, view).map_err(|error| error.to_string())?;
        let vertices = start.elapsed();
        let start = Instant::now();
        let mut strip = Strip::new(self.size.width as u16, &mut self.colours)
            .and_then(|strip| strip.with_depth(&mut self.depths))
            .map_err(|error| error.to_string())?
            .with_background(Rgb565::from_rgb(self.scene.background));
        let Ok(()) = list.present(&mut strip, display);
        Ok(Took { stats: list.stats(), vertices, pixels: start.elapsed() })
    }

    /// Draws a frame to nowhere, with a traversal of the caller's.
    pub(crate) fn trace<T: Traversal>(&mut self, view: &View) -> Result<(), String> {
        let mut list: DrawList<'_, Rgb565, Depth16, T> =
            DrawList::with_traversal(&mut self.words, &mut self.triangles);
        self.scene.draw(&mut list, self.size, view).map_err(|error| error.to_string())?;
        let mut strip = Strip::new(self.size.width as u16, &mut self.colours)
            .and_then(|strip| strip.with_depth(&mut self.depths))
            .map_err(|error| error.to_string())?;
        let rows = i32::from(strip.height());
        for top in (0..self.size.height as i32).step_by(rows as usize) {
            strip.clear();
            list.render(top..top + rows, &mut strip);
        }
        Ok(())
    }
}

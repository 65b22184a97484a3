//! The scenes as they are, with depth.

use scenes::{SCENES, Scene, View};
use topleft::stages::Traversal;
use topleft::{Depth16, DrawError, DrawList};

use crate::measure::{Bench, Buffers, Case, PANEL};

/// Measures all scenes but the grid, which has cases of its own.
pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    for scene in SCENES.iter().filter(|scene| scene.name != "grid240") {
        bench.case(scene, buffers);
    }
}

impl Case for Scene {
    type Depth = Depth16;

    fn method(&self) -> &'static str {
        "as-it-is+depth"
    }

    fn scene(&self) -> &'static str {
        self.name
    }

    fn draw<T: Traversal>(&self, list: &mut DrawList<'_, u16, Self::Depth, T>) -> Result<(), DrawError> {
        Self::draw(self, list, PANEL, &View::default())
    }

    fn background(&self) -> [u8; 3] {
        self.background
    }
}

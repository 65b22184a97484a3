//! The scenes as they are, with depth; and in painter's order, those whose meshes hide themselves or each other.

use scenes::{SCENES, Scene, View, by_name};
use topleft::stages::Traversal;
use topleft::{Depth16, DrawError, DrawList, Painter};

use crate::measure::{Bench, Buffers, Case, PANEL};

/// Measures all scenes but the grid, which has cases of its own.
pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    for scene in SCENES.iter().filter(|scene| scene.name != "grid240") {
        bench.case(scene, buffers);
    }
    for scene in PAINTED.into_iter().filter_map(by_name) {
        bench.case(&Painted(scene), buffers);
    }
}

/// Small triangles all over the scene, and as many over a few large ones.
const PAINTED: [&str; 2] = ["knot", "teapot"];

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

/// A scene in painter's order.
struct Painted(&'static Scene);

impl Case for Painted {
    type Depth = Painter;

    fn method(&self) -> &'static str {
        "as-it-is+painter"
    }

    fn scene(&self) -> &'static str {
        self.0.name
    }

    fn draw<T: Traversal>(&self, list: &mut DrawList<'_, u16, Self::Depth, T>) -> Result<(), DrawError> {
        self.0.draw(list, PANEL, &View::default())
    }

    fn background(&self) -> [u8; 3] {
        self.0.background
    }
}

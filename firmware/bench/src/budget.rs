//! Scenes of smooth shading, with and without an error that is allowed.

use scenes::{Object, Scene, View, by_name, sun};
use topleft::stages::Traversal;
use topleft::{Attribute, ColourError, Depth16, DrawError, DrawList, Gouraud};

use crate::measure::{Bench, Buffers, Case, PANEL};

/// A curved mesh on a level floor, curved meshes by themselves, and one with a colour a vertex.
const SCENES: [&str; 4] = ["teapot", "sphere", "globe", "knot"];

/// Measures all errors in all of these scenes.
pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    for scene in SCENES.into_iter().filter_map(by_name) {
        let mut by = |method, error: Option<&str>| {
            let error = error.map(|codes| ColourError::codes(Attribute::lit(codes)));
            bench.case(&Way { scene, method, error }, buffers);
        };
        by("gouraud+depth", None);
        by("gouraud-within-0+depth", Some("0"));
        by("gouraud-within-1+depth", Some("1"));
        by("gouraud-within-2+depth", Some("2"));
        by("gouraud-within-4+depth", Some("4"));
        by("gouraud-within-8+depth", Some("8"));
    }
}

/// A scene's meshes, whatever their look, with a colour a vertex under one sun.
struct Way {
    scene: &'static Scene,
    method: &'static str,
    error: Option<ColourError>,
}

impl Case for Way {
    type Depth = Depth16;

    fn method(&self) -> &'static str {
        self.method
    }

    fn scene(&self) -> &'static str {
        self.scene.name
    }

    fn draw<T: Traversal>(&self, list: &mut DrawList<'_, u16, Self::Depth, T>) -> Result<(), DrawError> {
        let sun = sun();
        let gouraud = |object: &Object| Gouraud::new(&sun, &object.look.material);
        match self.error {
            None => self.scene.draw_with(list, PANEL, &View::default(), gouraud),
            Some(error) => {
                self.scene.draw_with(list, PANEL, &View::default(), |object| gouraud(object).within(error))
            }
        }
    }

    fn background(&self) -> [u8; 3] {
        self.scene.background
    }
}

//! Scenes of smooth shading, with and without an error budget for colour and light.

use scenes::{Scene, View, by_name, sun};
use topleft::stages::{Shader, Traversal};
use topleft::{Affine, Attribute, ColourError, Depth16, DrawError, DrawList, Gouraud, Textured};

use crate::measure::{Bench, Buffers, Case, PANEL};

/// Smooth meshes: large and small faces, and colours of their own.
const SCENES: [&str; 4] = ["teapot", "sphere", "knot", "globe"];

/// Measures all budgets in all of these scenes.
pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    let codes = |codes| ColourError::codes(Attribute::lit(codes));
    for scene in SCENES.into_iter().filter_map(by_name) {
        let mut case = |method, look| bench.case(&Budget { scene, method, look }, buffers);
        case("gouraud+depth", Look::Gouraud(None));
        case("gouraud-within-0+depth", Look::Gouraud(Some(codes("0"))));
        case("gouraud-within-1+depth", Look::Gouraud(Some(codes("1"))));
        case("gouraud-within-2+depth", Look::Gouraud(Some(codes("2"))));
        case("gouraud-within-4+depth", Look::Gouraud(Some(codes("4"))));
        case("gouraud-within-8+depth", Look::Gouraud(Some(codes("8"))));
        case("gouraud-within-128+depth", Look::Gouraud(Some(codes("128"))));
        case("lit-affine+depth", Look::Lit(None));
        case("lit-affine-within-0+depth", Look::Lit(Some(codes("0"))));
        case("lit-affine-within-1+depth", Look::Lit(Some(codes("1"))));
        case("lit-affine-within-2+depth", Look::Lit(Some(codes("2"))));
        case("lit-affine-within-4+depth", Look::Lit(Some(codes("4"))));
        case("lit-affine-within-8+depth", Look::Lit(Some(codes("8"))));
        case("lit-affine-within-128+depth", Look::Lit(Some(codes("128"))));
    }
}

/// What a scene's meshes are drawn with.
#[derive(Clone, Copy)]
enum Look {
    Gouraud(Option<ColourError>),
    Lit(Option<ColourError>),
}

struct Budget {
    scene: &'static Scene,
    method: &'static str,
    look: Look,
}

impl Budget {
    fn by<'a, T: Traversal, S: Shader<'a, u16>>(
        &self,
        list: &mut DrawList<'a, u16, Depth16, T>,
        shader: impl Fn(&scenes::Object) -> S,
    ) -> Result<(), DrawError> {
        self.scene.draw_with(list, PANEL, &View::default(), shader)
    }
}

impl Case for Budget {
    type Depth = Depth16;

    fn method(&self) -> &'static str {
        self.method
    }

    fn scene(&self) -> &'static str {
        self.scene.name
    }

    fn draw<T: Traversal>(&self, list: &mut DrawList<'_, u16, Self::Depth, T>) -> Result<(), DrawError> {
        let sun = sun();
        let gouraud = |object: &scenes::Object| Gouraud::new(&sun, &object.look.material);
        let lit = |object: &scenes::Object| Textured::new(&object.look.texture, Affine).lit_by(&sun);
        match self.look {
            Look::Gouraud(None) => self.by(list, gouraud),
            Look::Gouraud(Some(error)) => self.by(list, |object| gouraud(object).within(error)),
            Look::Lit(None) => self.by(list, lit),
            Look::Lit(Some(error)) => self.by(list, |object| lit(object).within(error)),
        }
    }

    fn background(&self) -> [u8; 3] {
        self.scene.background
    }
}

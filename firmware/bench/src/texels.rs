//! The scenes whose textures decide, with every way to find a texel.

use scenes::{Scene, View, by_name};
use topleft::stages::{Correction, Traversal};
use topleft::{
    Affine, Attribute, Depth16, Divided, DrawError, DrawList, PerPixel, Portable, Subspans, Within,
};

use crate::measure::{Bench, Buffers, Case, PANEL};

/// Few large faces, and many small ones.
const SCENES: [&str; 4] = ["leaning-cube", "globe", "horizon", "corridor"];

/// Measures all ways in all of these scenes.
pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    for scene in SCENES.into_iter().filter_map(by_name) {
        let mut texels = Texels { scene, bench, buffers };
        let within = |texels| Within::texels(Attribute::lit(texels));
        texels.by("affine+depth", Affine);
        texels.by("perspective-subspan-32+depth", Subspans::Of32);
        texels.by("perspective-subspan-16+depth", Subspans::Of16);
        texels.by("perspective-subspan-8+depth", Subspans::Of8);
        texels.by("perspective-subspan-4+depth", Subspans::Of4);
        texels.by("perspective-within-2+depth", within("2"));
        texels.by("perspective-within-1+depth", within("1"));
        texels.by("perspective-within-1/2+depth", within("0.5"));
        texels.by("perspective-within-1/4+depth", within("0.25"));
        texels.by("perspective-within-1/16+depth", within("0.0625"));
        texels.by("perspective-divided+depth", Divided::<Portable>::new());
        texels.by("perspective-pixel+depth", PerPixel);
    }
}

struct Texels<'t, 'b, 'c> {
    scene: &'static Scene,
    bench: &'t mut Bench<'c>,
    buffers: &'t mut Buffers<'b>,
}

impl Texels<'_, '_, '_> {
    fn by(&mut self, method: &'static str, correction: impl Correction) {
        self.bench.case(&Way { scene: self.scene, method, correction }, self.buffers);
    }
}

struct Way<C> {
    scene: &'static Scene,
    method: &'static str,
    correction: C,
}

impl<C: Correction> Case for Way<C> {
    type Depth = Depth16;

    fn method(&self) -> &'static str {
        self.method
    }

    fn scene(&self) -> &'static str {
        self.scene.name
    }

    fn draw<T: Traversal>(&self, list: &mut DrawList<'_, u16, Self::Depth, T>) -> Result<(), DrawError> {
        self.scene.draw_textured(list, PANEL, &View::default(), self.correction)
    }

    fn background(&self) -> [u8; 3] {
        self.scene.background
    }
}

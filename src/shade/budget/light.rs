//! A texture under nearly one light as under one.

use super::super::perspective::Correction;
use super::super::sampler::{Lit, Plain};
use super::super::textured::{LitTexturePixel, STEPS_PER_CODE};
use super::super::{PixelShader, Uniforms};
use super::{BudgetedPixel, middle};
use crate::depth::Depth;
use crate::gradients::{Gradients, Plane};
use crate::math::format::Attribute;
use crate::pixel::Pixel;
use crate::run::Run;
use crate::transform::PerVertexInverse;
use crate::varying::Varying;

/// Light in 64 steps, with a half for rounding, which may be one at all vertices: then it asks for no gradients.
#[derive(Clone, Copy, Debug)]
pub struct Light(Attribute);

impl Varying for Light {
    #[inline]
    fn plane(gradients: &Gradients, [Self(a), Self(b), Self(c)]: [Self; 3]) -> Plane<Self> {
        if a == b && b == c {
            return Plane::level(Self(a));
        }
        let Plane { start, dx, dy } = Attribute::plane(gradients, [a, b, c]);
        Plane { start: Self(start), dx: Self(dx), dy: Self(dy) }
    }

    #[inline(always)]
    fn plus(self, Self(other): Self) -> Self {
        Self(self.0.plus(other))
    }

    #[inline(always)]
    fn times(self, steps: i32) -> Self {
        Self(Varying::times(self.0, steps))
    }
}

impl<'a, P: Pixel, C: Correction> PixelShader<'a, P> for BudgetedPixel<LitTexturePixel<'a, C>> {
    type Vertex = ([Attribute; 2], Attribute);
    type Varying = (C::Varying, Light);
    /// And whether it is in full light.
    type Triangle = (C::Triangle, bool);
    const PERSPECTIVE: bool = C::PERSPECTIVE;

    fn uniforms(&self) -> Uniforms<'a> {
        PixelShader::<P>::uniforms(&self.0)
    }

    #[inline]
    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
        Self(PixelShader::<P>::from_uniforms(uniforms))
    }

    #[inline]
    fn triangle(
        &self,
        [spread, ..]: [u8; 3],
        vertices: [([Attribute; 2], Attribute); 3],
        inverses: [PerVertexInverse; 3],
    ) -> ((C::Triangle, bool), [(C::Varying, Light); 3]) {
        let (triangle, [(a, p), (b, q), (c, r)]) =
            PixelShader::<P>::triangle(&self.0, [0; 3], vertices, inverses);
        let one = middle([p, q, r], i32::from(spread) * STEPS_PER_CODE);
        let full = one.is_some_and(|light| light.to_bits() >> 16 >= 64);
        let [p, q, r] = one.map_or([p, q, r], |light| [light; 3]).map(Light);
        ((triangle, full), [(a, p), (b, q), (c, r)])
    }

    #[inline(always)]
    fn shade<D: Depth>(
        &self,
        (triangle, full): &(C::Triangle, bool),
        start: (C::Varying, Light),
        step: &(C::Varying, Light),
        run: Run<'_, P, D>,
    ) {
        let textured = &self.0.0;
        run.visible(|skipped, pixels| {
            let (start, Light(light)) = start.plus(step.times(skipped));
            if *full {
                textured.walk(triangle, start, &step.0, pixels, Plain);
            } else {
                textured.walk(triangle, start, &step.0, pixels, Lit(light, step.1.0));
            }
        });
    }
}

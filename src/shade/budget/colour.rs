//! A face of nearly one colour in one.

use super::super::gouraud::{GouraudPixel, in_steps};
use super::super::{PixelShader, Uniforms};
use super::BudgetedPixel;
use crate::depth::Depth;
use crate::math::format::Attribute;
use crate::pixel::{Pixel, Stepped};
use crate::run::Run;
use crate::transform::PerVertexInverse;

impl<'a, P: Pixel> PixelShader<'a, P> for BudgetedPixel<GouraudPixel> {
    type Vertex = [u8; 3];
    type Varying = [Attribute; 3];
    type Triangle = ();
    const PERSPECTIVE: bool = false;

    fn uniforms(&self) -> Uniforms<'a> {
        PixelShader::<P>::uniforms(&self.0)
    }

    #[inline]
    fn from_uniforms(uniforms: &Uniforms<'a>) -> Self {
        Self(PixelShader::<P>::from_uniforms(uniforms))
    }

    #[inline(always)]
    fn solid(&self, [spread, ..]: [u8; 3], vertices: &[[u8; 3]; 3]) -> Option<P> {
        one_colour(spread, *vertices)
    }

    #[inline]
    fn triangle(
        &self,
        colour: [u8; 3],
        vertices: [[u8; 3]; 3],
        inverses: [PerVertexInverse; 3],
    ) -> ((), [[Attribute; 3]; 3]) {
        PixelShader::<P>::triangle(&self.0, colour, vertices, inverses)
    }

    #[inline(always)]
    fn shade<D: Depth>(&self, (): &(), start: [Attribute; 3], step: &[Attribute; 3], run: Run<'_, P, D>) {
        self.0.shade(&(), start, step, run);
    }
}

/// What a triangle between these vertices may be drawn in: the middle of each channel.
#[inline(always)]
fn one_colour<P: Pixel>(spread: u8, [a, b, c]: [[u8; 3]; 3]) -> Option<P> {
    let ([ar, ag, ab], [br, bg, bb], [cr, cg, cb]) = (a, b, c);
    let ends = |a: u8, b: u8, c: u8| {
        let (least, most) = (a.min(b).min(c), a.max(b).max(c));
        if most - least > spread { None } else { Some([least, most]) }
    };
    let ([lr, mr], [lg, mg], [lb, mb]) = (ends(ar, br, cr)?, ends(ag, bg, cg)?, ends(ab, bb, cb)?);
    let (least, most) = (in_steps::<P>([lr, lg, lb]), in_steps::<P>([mr, mg, mb]));
    let ([lr, lg, lb], [mr, mg, mb]) = (least, most);
    let middle = |a: Attribute, b: Attribute| Attribute::from_bits((a.to_bits() + b.to_bits()) >> 1);
    Some(P::Stepped::new([middle(lr, mr), middle(lg, mg), middle(lb, mb)]).colour())
}

//! Row 10: which 1/w the pixels of a triangle are divided by.

use std::cell::Cell;

use topleft::stages::{PerVertexInverse, PixelShader, Run, Shader, Uniforms, Varying};
use topleft::{
    Attribute, Cull, Depth, DrawList, Inverse, Length, ListTriangle, Matrix, MatrixCamera, Mesh, NoDepth,
    Pixel, Pose, Spans,
};

use crate::clipping::{SIZE, in_view};
use crate::figure::grouped;
use crate::support::check;
use crate::support::frame::rendered;
use crate::support::tolerance::interpolation;

/// 1/w in steps of 2^-31 of the triangle's power of two: at a pixel, and the least and the greatest of its corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Divisor {
    here: i32,
    corners: [i32; 2],
}

impl Pixel for Divisor {
    const MAX: [u8; 3] = [0; 3];
    type Stepped = [Attribute; 3];

    fn from_channels(_: [u8; 3]) -> Self {
        Self::default()
    }

    fn channels(self) -> [u8; 3] {
        [0; 3]
    }

    fn from_texel(_: u16) -> Self {
        Self::default()
    }
}

/// Shows what a pixel is divided by.
#[derive(Clone, Copy, Debug)]
struct Divisors;

impl<'a> Shader<'a, Divisor> for Divisors {
    type Pixel = Self;
    type Local = ();

    fn pixel(&self) -> Self {
        *self
    }

    fn local(&self, _: &Mesh<'_>, _: &Pose) {}

    fn vertex(&self, (): &(), _: &Mesh<'_>, _: usize) {}

    fn face(&self, (): &(), _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

impl<'a> PixelShader<'a, Divisor> for Divisors {
    type Vertex = ();
    type Varying = Inverse;
    type Triangle = [i32; 2];
    type Simple = Self;
    const PERSPECTIVE: bool = true;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms::NONE
    }

    fn from_uniforms(_: &Uniforms<'a>) -> Self {
        Self
    }

    fn triangle(&self, _: [u8; 3], _: [(); 3], inverses: [PerVertexInverse; 3]) -> ([i32; 2], [Inverse; 3]) {
        let q = PerVertexInverse::aligned(inverses);
        let ends = q.iter().fold([i32::MAX, i32::MIN], |[least, most], &q| [least.min(q), most.max(q)]);
        (ends, q.map(Inverse::from_bits))
    }

    fn shade<D: Depth>(&self, corners: &[i32; 2], start: Inverse, step: &Inverse, run: Run<'_, Divisor, D>) {
        let mut q = start;
        for place in run.pixels() {
            place.shade(|| Divisor { here: q.to_bits(), corners: *corners });
            q = q.plus(*step);
        }
    }
}

/// The greatest w in steps of 2^-15: less than 64 times a near plane of 1/64 or a step of 2^-16 nearer.
const FAR: i16 = 32_700;

/// The least and the greatest 1/w of corners that is drawn with, and at how many pixels, of triangles that reach up to
/// the eye and behind it.
pub(crate) fn divisors() -> ([i32; 2], usize) {
    let (ends, pixels) = (Cell::new([i32::MAX, i32::MIN]), Cell::new(0));
    let third = [-32_767..=32_767_i16, -32_767..=32_767_i16, -32_767..=3_i16];
    check(3_000, &(in_view(), in_view(), third, 1_023..=1_024_i32), |(a, b, c, near)| {
        let (o, one) = (Length::ZERO, Length::ONE);
        let near = Length::from_bits(-near);
        let rows = [[one, o, o, o], [o, one, o, o], [o, o, one, near], [o, o, one, o]];
        let camera = MatrixCamera::<true>::new(SIZE, Matrix::new(rows));
        let positions = [a, b, c].map(|[x, y, z]| [x, y, z.min(FAR)]);
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).expect("three vertices");
        let mesh = mesh.with_box([Length::ZERO; 3], Length::ONE);
        let (mut words, mut triangles) = ([0; 64], [ListTriangle::EMPTY; 8]);
        let mut list = DrawList::<Divisor, NoDepth, Spans>::with_traversal(&mut words, &mut triangles);
        list.set_cull(Cull::None);
        list.draw(&camera, &mesh, &Pose::new(), &Divisors).expect("it fits");
        let (width, height) = (SIZE.width as usize, SIZE.height as usize);
        let shown = rendered(&list, width, 0..height as i32, height, Divisor::default()).colours;
        // From a corner in the guard rectangle, 1024 px round the panel.
        let off = interpolation(31, 2 * 1_024 + 64 + 48, 1.0) * 2.0_f64.powi(31);
        for &Divisor { here, corners: [least, most] } in shown.iter().filter(|cell| cell.corners != [0; 2]) {
            // A w ratio of 64 or less. That none is above 2^31 - 1 is in their type: 2^31 would be negative.
            if least < 1 << 24 || most < 1 << 30 {
                return Err(format!("1/w of corners from {least} to {most}"));
            }
            if f64::from(here) < f64::from(least) - off || f64::from(here) > f64::from(most) + off {
                return Err(format!("1/w is {here} at a pixel, and from {least} to {most} at corners"));
            }
            let [low, high] = ends.get();
            ends.set([low.min(least), high.max(most)]);
            pixels.set(pixels.get() + 1);
        }
        Ok(())
    });
    (ends.get(), pixels.get())
}

// Red when the near plane is nearer (`distances`), or `aligned` does not shift.
#[test]
fn row_10_the_inverses_of_a_triangle_are_of_the_near_planes_range() {
    let ([least, most], pixels) = divisors();
    let log2 = |q: i32| f64::from(q).log2();
    println!(
        "row 10, w ratios up to 64: topleft divides {} px by 2^{:.2} to 2^{:.2}, bound 2^24 to 2^31",
        grouped(pixels as u64),
        log2(least),
        log2(most)
    );
    // Both ends are reached. On a near plane of 1/64 a corner's 1/w is the power of two, 2^31; a step nearer it is just
    // above half of the next one, 2^30, and of a w of 7/8 or more, as one in six in view has, 1/56 of it.
    assert!(least < (1 << 30) / 55 && most > i32::MAX - (1 << 20));
    assert!(pixels > 100_000);
}

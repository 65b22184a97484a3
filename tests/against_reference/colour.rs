//! Triangles that are drawn in one colour where the caller allows it, against exact colours at the same snapped vertices.

use embedded_graphics_core::pixelcolor::Rgb888;
use reference::varying::linear;
use topleft::stages::{DrawTriangle, PerVertexInverse, PixelShader, Run, Shader, Varying};
use topleft::{ColourError, Gouraud, Material, Pixel};

use crate::measured::{Errors, Row, hold};
use crate::probe::{Covered, range, sampled};
use crate::random::{Kind, Random};
use crate::tolerance::{MIDDLE, REACHED, channel, shown};

/// What is allowed, in codes: less than nothing, nothing, what a step of a half has no room for, and more than there is.
pub(crate) const ALLOWED: [&str; 8] = ["-3", "0", "0.75", "1", "2", "4", "8", "32767"];

const KINDS: [Kind; 3] = [Kind::Ordinary, Kind::Small, Kind::FullScreen];

/// The colours of a triangle's pixels in a span, and whether they are of one colour.
fn coloured<'a, P: Pixel, S: Shader<'a, P>>(
    shader: &S,
    covered: &Covered,
    vertices: [[u8; 3]; 3],
    each: impl FnMut(usize, &[P], bool),
) where
    S::Pixel: PixelShader<'a, P, Vertex = [u8; 3]>,
{
    let shader = S::Pixel::from_uniforms(&shader.pixel().uniforms());
    shader.choose([0; 3], vertices, [PerVertexInverse::ONE; 3], Onto { covered, each });
}

/// Where a triangle is drawn, by the shader that was chosen for it.
struct Onto<'c, F> {
    covered: &'c Covered,
    each: F,
}

impl<'a, P: Pixel, F: FnMut(usize, &[P], bool)> DrawTriangle<'a, P> for Onto<'_, F> {
    type Output = ();

    fn draw<S: PixelShader<'a, P>>(self, shader: S, triangle: S::Triangle, varyings: [S::Varying; 3]) {
        let Self { covered, mut each } = self;
        let gradients = covered.setup.gradients();
        let plane = S::Varying::plane(&gradients, varyings);
        let [ax, ay] = gradients.anchor();
        for (index, span) in covered.spans.iter().enumerate() {
            let mut cells = vec![P::from_channels([0; 3]); (span.end - span.start) as usize];
            let start = plane.at(span.start - ax, span.y - ay);
            shader.shade(&triangle, start, &plane.dx, Run::new(&mut cells));
            each(index, &cells, shader.solid(&triangle).is_some());
        }
    }
}

/// Three colours that differ by anything, or by little.
fn colours(random: &mut Random) -> [[u8; 3]; 3] {
    let narrow = random.within(0, 8) as u32;
    let base = [(); 3].map(|()| random.next() as u8);
    [(); 3].map(|()| base.map(|channel| channel ^ ((random.next() as u8 as u32) >> narrow) as u8))
}

/// The errors of channels, in codes of 255, of pixels `P`.
fn errors<P: Pixel>(allowed: &str) -> Errors {
    let mut random = Random::new(41);
    let mut errors = Errors::default();
    let codes: f64 = allowed.parse::<f64>().expect("a number").clamp(0.0, 127.5);
    let shader = Gouraud::unlit(&Material::OfMesh).within(ColourError::codes(allowed.parse().unwrap()));
    let (mut ones, mut others) = (0, 0);
    for round in 0..6000 {
        let covered = Covered::new(KINDS[round % 3].triangle(&mut random));
        let vertices = colours(&mut random);
        coloured::<P, _>(&shader, &covered, vertices, |index, cells, one| {
            *(if one { &mut ones } else { &mut others }) += 1;
            let span = &covered.spans[index];
            for x in sampled(span, &mut random) {
                let channels = cells[(x - span.start) as usize].channels();
                for k in 0..3 {
                    let max = f64::from(P::MAX[k]);
                    let codes_at = vertices.map(|colour| f64::from(colour[k]));
                    let exact = linear(covered.triangle, codes_at, x.into(), span.y.into());
                    let ours = f64::from(channels[k]) * 255.0 / max;
                    let steps = range(codes_at) * max / 255.0;
                    let bound = if one {
                        codes + shown(max, MIDDLE)
                    } else {
                        shown(max, channel(covered.steps(x, span.y), steps))
                    };
                    errors.add(ours - exact, bound, || {
                        format!("{allowed}: {:?} {vertices:?}: {ours} for {exact}", covered.triangle)
                    });
                }
            }
        });
    }
    // The greatest error leaves no triangle to interpolate.
    assert!(ones > 1000 && (others > 1000) != (codes > 127.0), "{ones} spans of one colour, {others} others");
    errors
}

/// Every error that is allowed, on displays of 8 bits a channel, and of 5 and 6.
pub(crate) fn within(allowed: &'static str) -> Vec<Row> {
    let row = |display, errors: &Errors| {
        let method = format!("gouraud within {allowed} in {display}");
        Row::new("colour", "triangles of all sizes", method, ["shown", "code of 255"], errors)
            .reaching(REACHED)
    };
    vec![row("Rgb888", &errors::<Rgb888>(allowed)), row("Rgb565", &errors::<u16>(allowed))]
}

/// Turned red by: one colour where vertices differ by three times the error, or a channel of them does; a vertex's colour
/// for the middle; a middle that is rounded to whole codes.
#[test]
fn colours_are_off_by_what_is_allowed() {
    ALLOWED.into_iter().for_each(|allowed| hold(&within(allowed)));
}

/// Turned red by: one colour where vertices differ, if by one code only; a middle without the half that rounds.
#[test]
fn without_an_error_triangles_are_as_interpolated() {
    fn check<P: Pixel + PartialEq + core::fmt::Debug>() {
        let mut random = Random::new(42);
        let exact = Gouraud::unlit(&Material::OfMesh);
        let mut ones = 0;
        for round in 0..4000 {
            let covered = Covered::new(KINDS[round % 3].triangle(&mut random));
            let vertices = colours(&mut random);
            let mut expected: Vec<Vec<P>> = Vec::new();
            coloured::<P, _>(&exact, &covered, vertices, |_, cells, _| expected.push(cells.to_vec()));
            for least in ["0", "-1", "-32768"] {
                let none = exact.within(ColourError::codes(least.parse().unwrap()));
                coloured::<P, _>(&none, &covered, vertices, |index, cells, one| {
                    ones += u32::from(one);
                    assert_eq!(cells, expected[index], "{:?} {vertices:?}", covered.triangle);
                });
            }
        }
        assert!(ones > 1000, "{ones} spans of one colour");
    }
    check::<Rgb888>();
    check::<u16>();
}

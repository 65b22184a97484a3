//! Ways to see what the library computes between a vertex and a pixel.

use embedded_graphics_core::geometry::Size;
use reference::matrix::Matrix;
use reference::setup::Triangle;
use reference::varying::linear;
use topleft::stages::{
    Correction, DrawTexels, PerVertexInverse, PixelShader, Run, Setup, Shader, Snapped, Span, Traversal,
    Uniforms, Varying, Window,
};
use topleft::{Affine, Attribute, Depth, Length, MatrixCamera, Mesh, Pixel, Pose, Spans};

use crate::random::Random;

/// A triangle set up, its vertices in canonical order, and its spans on a target of 320 x 240.
pub(crate) struct Covered {
    pub(crate) setup: Setup,
    pub(crate) triangle: Triangle,
    pub(crate) spans: Vec<Span>,
}

impl Covered {
    pub(crate) fn new(triangle: Triangle) -> Self {
        let (setup, order) =
            Setup::new(triangle.map(|[x, y]| Snapped::from_bits(x, y))).expect("it has an area");
        let mut spans = Vec::new();
        let window = Window { columns: 0..320, rows: 0..240 };
        let Ok(()) = Spans::walk(&setup, &window, |span| {
            spans.push(span);
            Ok::<_, core::convert::Infallible>(())
        });
        Self { setup, triangle: order.map(|i| triangle[i]), spans }
    }

    /// Pixels from the anchor to one at `x`, `y`: n + m.
    pub(crate) fn steps(&self, x: i32, y: i32) -> u64 {
        let [ax, ay] = self.setup.gradients().anchor();
        u64::from(x.abs_diff(ax)) + u64::from(y.abs_diff(ay))
    }
}

/// The columns and rows of the texels that a method shows in a run.
pub(crate) fn texels_of<C: Correction>(
    method: C,
    triangle: &C::Triangle,
    start: C::Varying,
    step: &C::Varying,
    pixels: i32,
) -> Vec<[i32; 2]> {
    let mut run = vec![[0; 2]; pixels as usize];
    method.walk(triangle, start, step, &mut run, &mut |texel: &mut [i32; 2], u, v| *texel = [u, v]);
    run
}

impl Covered {
    /// The texels of each span, as a method draws them, or what it hands the triangle to: at once, as in a list, or later.
    pub(crate) fn texels(
        &self,
        method: impl Correction,
        texels: [[Attribute; 2]; 3],
        inverses: [PerVertexInverse; 3],
        sizes_log2: [u8; 2],
    ) -> Vec<Vec<[i32; 2]>> {
        if method.is_affine(texels, inverses) {
            return Affine.choose(texels, inverses, sizes_log2, self);
        }
        method.choose(texels, inverses, sizes_log2, self)
    }
}

impl DrawTexels for &Covered {
    type Output = Vec<Vec<[i32; 2]>>;

    fn draw<C: Correction>(
        self,
        method: C,
        triangle: C::Triangle,
        varyings: [C::Varying; 3],
    ) -> Self::Output {
        let gradients = self.setup.gradients();
        let plane = C::Varying::plane(&gradients, varyings);
        let [ax, ay] = gradients.anchor();
        let shown = |span: &Span| {
            let start = plane.at(span.start - ax, span.y - ay);
            texels_of(method, &triangle, start, &plane.dx, span.end - span.start)
        };
        self.spans.iter().map(shown).collect()
    }
}

/// The ends of a span and a place or two inside.
pub(crate) fn sampled(span: &Span, random: &mut Random) -> [i32; 4] {
    let inside = |random: &mut Random| random.within(span.start.into(), i64::from(span.end) - 1) as i32;
    [span.start, inside(random), inside(random), span.end - 1]
}

/// The largest difference between three values.
pub(crate) fn range(values: [f64; 3]) -> f64 {
    let [a, b, c] = values;
    a.max(b).max(c) - a.min(b).min(c)
}

/// How far a value lies from the one that was rounded down for it: 0 inside of its step.
pub(crate) fn outside(rounded_down: i32, exact: f64) -> f64 {
    (f64::from(rounded_down) - exact).max(exact - f64::from(rounded_down) - 1.0).max(0.0)
}

/// The slopes of a plane in units a pixel, to the right and down.
pub(crate) fn slopes(triangle: Triangle, values: [f64; 3]) -> [f64; 2] {
    let at = |x, y| linear(triangle, values, x, y);
    [at(1, 0) - at(0, 0), at(0, 1) - at(0, 0)]
}

/// A matrix of the library's, exactly.
pub(crate) fn exact(matrix: &topleft::Matrix) -> Matrix {
    let unit = 2.0_f64.powi(-matrix.exponent());
    Matrix([0, 1, 2, 3].map(|row| matrix.row(row).map(|mantissa| f64::from(mantissa) * unit)))
}

/// The widest side of a target that [`exact_camera`] sees.
pub(crate) const SIZE: u32 = 256;

fn eighths(of_128: [i32; 4]) -> [Length; 4] {
    of_128.map(|value| Length::from_bits(value << 9))
}

/// A camera for 256 x 256 pixels whose snapped vertices are known exactly: a position's step is 1/256 px at w = 1.
///
/// Without perspective w is 1 and z is (1 + p) / 2.
pub(crate) fn exact_camera() -> MatrixCamera<false> {
    let rows = [[128, 0, 0, 0], [0, 128, 0, 0], [0, 0, 64, 64], [0, 0, 0, 128]];
    MatrixCamera::new(Size::new(SIZE, SIZE), topleft::Matrix::new(rows.map(eighths)))
}

/// The same with perspective: w goes with z from 1/64 to 1, and z is w - 1/64.
pub(crate) fn exact_perspective() -> MatrixCamera<true> {
    let rows = [[128, 0, 0, 0], [0, 128, 0, 0], [0, 0, 63, 63], [0, 0, 63, 65]];
    MatrixCamera::new(Size::new(SIZE, SIZE), topleft::Matrix::new(rows.map(eighths)))
}

/// The same far beyond a near plane that is 2^-16 away: z is w less that.
pub(crate) fn exact_far_away() -> MatrixCamera<true> {
    let mut rows = [[128, 0, 0, 0], [0, 128, 0, 0], [0, 0, 63, 65], [0, 0, 63, 65]].map(eighths);
    rows[2][3] -= Length::DELTA;
    MatrixCamera::new(Size::new(SIZE, SIZE), topleft::Matrix::new(rows))
}

/// w of a vertex under [`exact_perspective`] and [`exact_far_away`].
pub(crate) fn w_of(position: [i16; 3]) -> f64 {
    65.0 / 128.0 + 63.0 / 128.0 * f64::from(position[2]) / 32_768.0
}

/// Where a vertex is snapped to under a camera above, `w` being 1 without perspective; nothing where it is too near to
/// a tie for the reciprocal's 2^-27.9 of 2^18 steps.
pub(crate) fn snapped(position: [i16; 3], w: f64) -> Option<[i32; 2]> {
    let [x, y, _] = position.map(f64::from);
    let place = [32_768.0 + x / w, 32_768.0 - y / w];
    let clear = |c: f64| w == 1.0 || ((c - c.floor()) - 0.5).abs() > 0.004;
    if place.into_iter().all(clear) { Some(place.map(|c| (c + 0.5).floor() as i32)) } else { None }
}

/// A cell that keeps what a shader was given: the face's colour and three values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Seen {
    pub(crate) face: [u8; 3],
    pub(crate) values: [i32; 3],
}

impl Seen {
    /// The face that is seen, if one is.
    pub(crate) fn face(&self) -> Option<usize> {
        let [a, b, c] = self.face;
        (u32::from_le_bytes([a, b, c, 0]) as usize).checked_sub(1)
    }
}

/// The cell that nothing was drawn to.
pub(crate) const UNSEEN: Seen = Seen { face: [0; 3], values: [0; 3] };

impl Pixel for Seen {
    const MAX: [u8; 3] = [255; 3];
    type Stepped = [Attribute; 3];

    fn from_channels(face: [u8; 3]) -> Self {
        Self { face, ..UNSEEN }
    }

    fn channels(self) -> [u8; 3] {
        self.face
    }

    fn from_texel(_: u16) -> Self {
        UNSEEN
    }
}

/// Shows values given a vertex, as they are interpolated, and faces by their number.
pub(crate) struct Probe<'v> {
    pub(crate) values: &'v [[Attribute; 3]],
    /// The number of the mesh's face 0.
    pub(crate) first_face: usize,
}

#[derive(Clone, Copy)]
pub(crate) struct ProbePixel;

/// Counted from 1, little end first.
pub(crate) fn face_colour(face: usize) -> [u8; 3] {
    let [a, b, c, _] = (face as u32 + 1).to_le_bytes();
    [a, b, c]
}

impl<'a> Shader<'a, Seen> for Probe<'_> {
    type Pixel = ProbePixel;
    type Local = ();

    fn pixel(&self) -> ProbePixel {
        ProbePixel
    }

    fn local(&self, _: &Mesh<'_>, _: &Pose) {}

    fn vertex(&self, (): &(), _: &Mesh<'_>, vertex: usize) -> ([Attribute; 2], Attribute) {
        let [a, b, c] = self.values.get(vertex).copied().unwrap_or_default();
        ([a, b], c)
    }

    fn face(&self, (): &(), _: &Mesh<'_>, face: usize) -> [u8; 3] {
        face_colour(self.first_face + face)
    }
}

impl<'a> PixelShader<'a, Seen> for ProbePixel {
    type Vertex = ([Attribute; 2], Attribute);
    type Varying = [Attribute; 3];
    type Triangle = [u8; 3];
    type Simple = Self;
    const PERSPECTIVE: bool = false;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms::NONE
    }

    fn from_uniforms(_: &Uniforms<'a>) -> Self {
        Self
    }

    fn triangle(
        &self,
        face: [u8; 3],
        vertices: [Self::Vertex; 3],
        _: [PerVertexInverse; 3],
    ) -> ([u8; 3], [[Attribute; 3]; 3]) {
        (face, vertices.map(|([a, b], c)| [a, b, c]))
    }

    fn shade<D: Depth>(
        &self,
        &face: &[u8; 3],
        start: [Attribute; 3],
        step: &[Attribute; 3],
        run: Run<'_, Seen, D>,
    ) {
        let (mut bits, step) = (start.map(Attribute::to_bits), step.map(Attribute::to_bits));
        for place in run.pixels() {
            place.shade(|| Seen { face, values: bits });
            for (value, step) in bits.iter_mut().zip(step) {
                *value = value.wrapping_add(step);
            }
        }
    }
}

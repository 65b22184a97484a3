//! How far texels are off along one span, by its length and the ratio of w at its ends.

use reference::setup::Triangle;
use reference::transform::inverse_word;
use reference::varying::{linear, perspective};
use topleft::stages::{
    Correction, PerVertexInverse, Setup, Snapped, Span, Traversal, Varying, Window, Words,
};
use topleft::{Affine, Attribute, PerPixel, Spans, Subspans};

use crate::axis::{Axis, Bar, Scale, ticks};
use crate::canvas::Canvas;
use crate::map::{Map, Panel};

/// What a texel may be off.
const ALLOWED: f64 = 0.25;
/// As many texels as a span can have are shown over it, so that errors below a pixel's share of them are seen.
const FINEST: f64 = 32_000.0;

/// A span that shows one texel a pixel on the whole, with w from 1 at its left end to `ratio` at its right.
struct Case {
    triangle: Triangle,
    /// At the corners: 1/w, and texels.
    q: [f64; 3],
    texels: [f64; 3],
}

/// The largest error of one method, in texels.
type Measure = fn(&Case) -> f64;

impl Case {
    fn new(length: f64, ratio: f64) -> Self {
        let right = (length * 256.0).round() as i32;
        // So tall that its first row is almost as long as it is wide.
        let triangle = [[0, 0], [right, 0], [0, 200 * 256]];
        Self { triangle, q: [1.0, 1.0 / ratio, 1.0], texels: [0.0, length, 0.0] }
    }

    /// The exact texel of a pixel in the first row.
    fn exact(&self, x: i32) -> f64 {
        perspective(self.triangle, self.texels, self.q, x.into(), 0)
    }

    /// The first row.
    fn span(&self) -> Span {
        let (mut first, setup) = (None, self.setup());
        let window = Window { columns: 0..1024, rows: 0..1 };
        let Ok(()) = Spans::walk(&setup, &window, |span| {
            first = Some(span);
            Ok::<_, core::convert::Infallible>(())
        });
        first.expect("its first row has pixels")
    }

    /// The corners are in canonical order as they are.
    fn setup(&self) -> Setup {
        let corners = self.triangle.map(|[x, y]| Snapped::from_bits(x, y));
        Setup::new(corners).expect("it has an area").0
    }
}

/// A method of the library, drawn by it.
fn of_library<C: Correction + Default>(case: &Case) -> f64 {
    let method = C::default();
    let w = case.q.map(|q| (f64::from(1 << 24) / q) as u32);
    let inverses = w.map(|w| PerVertexInverse::load(&mut [inverse_word(w)].into_iter()).expect("a word"));
    let finer = FINEST / case.texels[1];
    let texels = case.texels.map(|u| [Attribute::from_num(u * finer - FINEST / 2.0), Attribute::ZERO]);
    let (shared, varyings) = method.triangle(texels, inverses, [8, 8]);
    let (gradients, span) = (case.setup().gradients(), case.span());
    let plane = C::Varying::plane(&gradients, varyings);
    let [ax, ay] = gradients.anchor();
    let start = plane.at(span.start - ax, span.y - ay);
    let mut worst = 0.0_f64;
    let mut run: Vec<i32> = (span.start..span.end).collect();
    method.walk(&shared, start, &plane.dx, &mut run, &mut |x: &mut i32, u, _| {
        let shown = (f64::from(u) + FINEST / 2.0) / finer;
        // The texel that was rounded down to holds all of its step.
        let exact = case.exact(*x);
        worst = worst.max(shown - exact).max(exact - shown - 1.0 / finer);
    });
    worst
}

/// The largest error of linear texels between two places, with what texels and 1/w change by there.
fn between(texels: f64, ratio: f64) -> f64 {
    texels.abs() * (ratio.sqrt() - 1.0) / (ratio.sqrt() + 1.0)
}

/// The same between the ends of the subspan where it is largest, and what those are off by.
fn subspans_bound(length: f64, ratio: f64) -> f64 {
    let (case, pixels) = (Case::new(length, ratio), Subspans::default().pixels() as i32);
    let Span { start, end, .. } = case.span();
    let q = |x: i32| linear(case.triangle, case.q, x.into(), 0);
    let bent = (start..end)
        .step_by(pixels as usize)
        .map(|left| {
            let right = (left + pixels).min(end - 1);
            between(case.exact(right) - case.exact(left), q(left) / q(right))
        })
        .fold(0.0, f64::max);
    bent + per_pixel_bound(length)
}

/// `PerPixel` documents it: a share of the power of two that holds the texels.
fn per_pixel_bound(length: f64) -> f64 {
    FINEST.log2().ceil().exp2() * length / FINEST * 2.0_f64.powi(-13)
}

pub(crate) fn map() -> Canvas {
    let x = Axis {
        name: "span length in px",
        scale: Scale::Log,
        ends: [8.0, 512.0],
        cells: 36,
        ticks: ticks(&[8.0, 32.0, 128.0, 512.0]),
    };
    // By how much w grows, so that ratios near 1 can be told apart.
    let y = Axis {
        name: "ratio of w at the span's ends",
        scale: Scale::Log,
        ends: [0.005, 63.0],
        cells: 36,
        ticks: [1.01, 1.1, 2.0, 4.0, 16.0, 64.0].map(|ratio| (ratio - 1.0, crate::axis::short(ratio))).into(),
    };
    let panel = |title: &str, measure: Measure, label: &str, beyond: fn(f64, f64) -> f64| Panel {
        title: title.into(),
        values: Map::cells(&x, &y, |length, grown| measure(&Case::new(length, 1.0 + grown))),
        line: (label.into(), Box::new(move |length, grown| beyond(length, 1.0 + grown) > ALLOWED)),
    };
    let panels = vec![
        panel("Affine", of_library::<Affine>, "bound = 1/4 texel", between),
        panel("Subspans of 16 px", of_library::<Subspans>, "bound = 1/4 texel", subspans_bound),
        panel("PerPixel", of_library::<PerPixel>, "bound = 1/4 texel: nowhere", |length, _| {
            per_pixel_bound(length)
        }),
    ];
    let bar = Bar {
        name: "texels",
        ends: [1e-3, 512.0],
        ticks: ticks(&[0.001, 0.01, 0.1, 0.25, 1.0, 10.0, 100.0]),
    };
    let notes = vec![
        "Largest texel error along one span, with one texel a pixel on the whole.".into(),
        "Bounds: U (sqrt r - 1) / (sqrt r + 1) for what is linear over U texels at a ratio r of w, for each"
            .into(),
        "subspan by its own, and U 2^-13 more; and U 2^-13 with a reciprocal a pixel.".into(),
    ];
    Map {
        title: "Where texture mapping breaks: error by the length of a span and its ratio of w",
        x,
        y,
        cell: [6, 6],
        bar,
        allowed: ALLOWED,
        panels,
        notes,
    }
    .draw()
}

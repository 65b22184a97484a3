//! The methods between linear texels and a reciprocal a pixel, against exact perspective.

use reference::varying::{linear, perspective};
use topleft::stages::Correction;
use topleft::{Attribute, Divided, PerPixel, Portable, Subspans, Within};

use crate::measured::{Errors, Row, hold};
use crate::probe::{Covered, outside, range, sampled};
use crate::random::{Kind, Random};
use crate::texels::{SIZES, distances, inverse, texel_box};
use crate::tolerance::{DIVIDED, RECIPROCAL, per_pixel, subspan, within};

/// A triangle with texels and 1/w at its corners.
struct Case {
    covered: Covered,
    w: [u32; 3],
    q: [f64; 3],
    texels: [[Attribute; 2]; 3],
    exact: [[f64; 2]; 3],
    /// Of its box of texels, and of its 1/w.
    unit: f64,
    of_q: f64,
}

impl Case {
    fn new(kind: Kind, ratio: f64, size: f64, random: &mut Random) -> Self {
        let covered = Covered::new(kind.triangle(random));
        let w = distances(ratio, random);
        Self::of(covered, w, size, random)
    }

    /// Of a triangle with these w at its corners.
    fn of(covered: Covered, w: [u32; 3], size: f64, random: &mut Random) -> Self {
        let texels = [(); 3].map(|()| {
            [(); 2].map(|()| Attribute::from_bits(((random.unit() - 0.5) * size * 65_536.0) as i32))
        });
        let exact = texels.map(|texel| texel.map(|c| f64::from(c.to_bits()) / 65_536.0));
        let of_q = f64::from(1_u32 << w.into_iter().min().unwrap().ilog2());
        Self { covered, w, q: w.map(|w| 1.0 / f64::from(w)), texels, exact, unit: texel_box(exact), of_q }
    }

    fn wanted(&self, x: i32, y: i32, axis: usize) -> f64 {
        perspective(self.covered.triangle, self.exact.map(|texel| texel[axis]), self.q, x.into(), y.into())
    }

    /// 1/w as a share of the power of two at or above the largest.
    fn q(&self, x: i32, y: i32) -> f64 {
        linear(self.covered.triangle, self.q, x.into(), y.into()) * self.of_q
    }

    /// The texels of each span.
    fn shown(&self, method: impl Correction) -> Vec<Vec<[i32; 2]>> {
        self.covered.texels(method, self.texels, self.w.map(inverse), SIZES)
    }

    /// What an exact texel may be off, in units of its box.
    fn ends(&self, x: i32, y: i32) -> f64 {
        per_pixel(self.covered.steps(x, y), self.q(x, y))
    }

    /// Compares some texels of all spans; `bound` is given the span, the place in it, and the axis.
    fn add<C: Correction>(
        &self,
        method: C,
        errors: &mut Errors,
        random: &mut Random,
        bound: impl Fn(&topleft::stages::Span, i32, usize) -> f64,
    ) {
        for (span, shown) in self.covered.spans.iter().zip(self.shown(method)) {
            for x in sampled(span, random) {
                for (axis, texel) in shown[(x - span.start) as usize].into_iter().enumerate() {
                    let wanted = self.wanted(x, span.y, axis);
                    errors.add(outside(texel, wanted), bound(span, x, axis), || {
                        let Self { covered, w, exact, .. } = self;
                        format!(
                            "{:?}, w {w:?}, texels {exact:?}: {texel} for {wanted} at {x}, {}",
                            covered.triangle, span.y
                        )
                    });
                }
            }
        }
    }
}

/// Triangles that methods differ on.
pub(crate) const KINDS: [Kind; 4] = [Kind::Ordinary, Kind::Small, Kind::FullScreen, Kind::Sliver];

/// Subspans of every length, on triangles of a kind, by the ratio of w.
pub(crate) fn subspans_of(kind: Kind) -> Vec<Row> {
    let rows = |method: Subspans| {
        [1.5, 4.0, 16.0].map(|ratio| {
            let (mut errors, mut random) = (Errors::default(), Random::new(20 + ratio as u64));
            let pixels = method.pixels() as i32;
            for _ in 0..if kind == Kind::Small { 2000 } else { 100 } {
                let case = Case::new(kind, ratio, 255.0, &mut random);
                case.add(method, &mut errors, &mut random, |span, x, axis| {
                    let from = x - (x - span.start) % pixels;
                    let to = (from + pixels).min(span.end - 1);
                    let ([u, v], [p, q]) = (
                        [from, to].map(|x| case.wanted(x, span.y, axis)),
                        [from, to].map(|x| case.q(x, span.y)),
                    );
                    let ends = case.ends(from, span.y).max(case.ends(to, span.y));
                    subspan((u - v).abs(), (p / q).max(q / p), case.unit, ends)
                });
            }
            let name = format!("subspans of {pixels} w 1:{ratio}");
            Row::new("texels", kind.name(), name, ["of 255 by subspans", "texel"], &errors)
        })
    };
    Subspans::ALL.into_iter().flat_map(rows).collect()
}

/// A reciprocal a pixel by division.
pub(crate) fn divided_of(kind: Kind) -> Row {
    let (mut errors, mut random) = (Errors::default(), Random::new(21));
    for _ in 0..100 {
        let case = Case::new(kind, 16.0, 32_767.0, &mut random);
        case.add(Divided::<Portable>::new(), &mut errors, &mut random, |span, x, _| {
            case.unit * (case.ends(x, span.y) + DIVIDED - RECIPROCAL)
        });
    }
    Row::new("texels", kind.name(), "divided w 1:16", ["of 32768", "texel"], &errors)
}

/// Errors that a caller may allow, in texels.
pub(crate) const ALLOWED: [(f64, &str); 5] =
    [(0.0625, "1/16"), (0.25, "1/4"), (0.5, "1/2"), (1.0, "1"), (2.0, "2")];

/// The method that keeps an error, on 20 000 triangles: most are small, as in meshes; w by up to 1:64, mostly less.
pub(crate) fn within_error((error, name): (f64, &'static str)) -> Row {
    let (mut errors, mut random) = (Errors::default(), Random::new(22));
    let method = Within::texels(Attribute::from_num(error));
    for i in 0..20_000 {
        let kind = match i % 100 {
            0 => Kind::FullScreen,
            1..5 => Kind::Ordinary,
            5..15 => Kind::Sliver,
            _ => Kind::Small,
        };
        let ratio = 64_f64.powf(random.unit().powi(3));
        let size = 2_f64.powf(1.0 + 9.0 * random.unit());
        let covered = Covered::new(kind.triangle(&mut random));
        let [a, b, c] = distances(ratio, &mut random);
        // One in seven has a level edge, as floors have.
        let case = Case::of(covered, if i % 7 == 0 { [a, a, c] } else { [a, b, c] }, size, &mut random);
        let least = case.q.into_iter().fold(f64::MAX, f64::min) * case.of_q;
        case.add(method, &mut errors, &mut random, |span, x, axis| {
            // The ends of the subspan may be anywhere in the row.
            let steps = case.covered.steps(span.start, span.y).max(case.covered.steps(span.end, span.y));
            let range = range(case.exact.map(|texel| texel[axis]));
            within(error, case.unit, per_pixel(steps, least), case.covered.steps(x, span.y), range)
        });
    }
    Row::new(
        "texels",
        "triangles of all sizes",
        format!("within {name} texel"),
        ["as allowed", "texel"],
        &errors,
    )
    .reaching(0.5)
}

/// Red when a subspan's step is that of its neighbour, or the last one ends a pixel late.
#[test]
fn subspans_are_within_their_bound() {
    KINDS.into_iter().for_each(|kind| hold(&subspans_of(kind)));
}

/// Red when the denominator has three bits less.
#[test]
fn divided_texels_are_within_the_bound_of_a_reciprocal() {
    hold(&KINDS.map(divided_of));
}

/// Red when affine is chosen for twice the bend, its texels are moved the other way, or subspans are twice as long.
#[test]
fn no_texel_is_further_off_than_allowed() {
    hold(&ALLOWED.map(within_error));
}

/// What has no sense as an error still has a meaning.
///
/// Red when less than 0 wraps, or the largest error overflows.
#[test]
fn none_is_exact_and_any_is_affine() {
    let mut random = Random::new(23);
    for _ in 0..200 {
        let case = Case::new(Kind::Ordinary, 8.0, 255.0, &mut random);
        let [exact, affine] = [case.shown(PerPixel), case.shown(topleft::Affine)];
        for none in [Attribute::ZERO, Attribute::from_bits(-1), Attribute::MIN] {
            assert_eq!(case.shown(Within::texels(none)), exact);
        }
        assert_eq!(case.shown(Within::texels(Attribute::MAX)), affine);
    }
}

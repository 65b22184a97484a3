//! Rows 14 to 16: texels where w changes by much.

use reference::naive::texel;
use reference::setup::Triangle;
use reference::transform::inverse_word;
use reference::varying::{linear, perspective};
use topleft::stages::{Correction, PerVertexInverse, Varying, Words};
use topleft::{Attribute, PerPixel};

use crate::figure::grouped;
use crate::probe::{Covered, outside, texels_of};
use crate::random::{Kind, Random};
use crate::support::tolerance::{SIXTEENTH, affine, per_pixel};

/// Texels across, and of the power of two that holds them.
const TEXELS: f64 = 256.0;

/// A triangle over all of the screen, u from 0 at its nearest corner to 255 at its furthest.
pub(crate) struct Receding {
    pub(crate) covered: Covered,
    q: [f64; 3],
    u: [f64; 3],
    w: [u32; 3],
}

impl Receding {
    /// w from 1 to `ratio`; the corner at `nearest` is the one at 1.
    pub(crate) fn new(triangle: Triangle, ratio: f64, nearest: usize, random: &mut Random) -> Self {
        let covered = Covered::new(triangle);
        let between = random.unit();
        let mut share = [0.0, 1.0, between];
        share.rotate_right(nearest);
        let w = share.map(|share| ((1.0 + (ratio - 1.0) * share) * f64::from(1 << 22)) as u32);
        let u = share.map(|share| (share * 255.0 * 65_536.0).floor() / 65_536.0);
        Self { covered, q: w.map(|w| 1.0 / f64::from(w)), u, w }
    }

    pub(crate) fn exact(&self, x: i32, y: i32) -> f64 {
        perspective(self.covered.triangle, self.u, self.q, x.into(), y.into())
    }

    /// Calls `each` with every pixel and what `PerPixel` shows there.
    pub(crate) fn shown(&self, mut each: impl FnMut(i32, i32, i32)) {
        let inverses =
            self.w.map(|w| PerVertexInverse::load(&mut [inverse_word(w)].into_iter()).expect("a word"));
        let texels = self.u.map(|u| [Attribute::from_num(u), Attribute::ZERO]);
        let (shared, varyings) = PerPixel.triangle(texels, inverses, [8, 8]);
        let gradients = self.covered.setup.gradients();
        let plane = <PerPixel as Correction>::Varying::plane(&gradients, varyings);
        let [ax, ay] = gradients.anchor();
        for span in &self.covered.spans {
            let start = plane.at(span.start - ax, span.y - ay);
            let shown = texels_of(PerPixel, &shared, start, &plane.dx, span.end - span.start);
            (span.start..).zip(shown).for_each(|(x, [u, _])| each(x, span.y, u));
        }
    }

    /// What a texel may be off.
    fn bound(&self, x: i32, y: i32) -> f64 {
        // 1/w as a share of the power of two at or above the largest.
        let least = self.w.into_iter().fold(u32::MAX, u32::min);
        let unit = f64::from(1_u32 << least.ilog2());
        let share = linear(self.covered.triangle, self.q, x.into(), y.into()) * unit;
        TEXELS * per_pixel(self.covered.steps(x, y), share)
    }
}

/// The largest errors of a naive method and of the library, and the library's largest share of its bound.
#[derive(Debug, Default)]
pub(crate) struct Worst {
    pub(crate) naive: f64,
    pub(crate) ours: f64,
    share: f64,
    pixels: u64,
}

impl Worst {
    /// `naive` is given a pixel, and the first one of its row.
    fn add(&mut self, case: &Receding, naive: impl Fn([i64; 2], i64) -> f64) {
        let mut starts = case.covered.spans.iter();
        let (mut row, mut start) = (i32::MIN, 0);
        case.shown(|x, y, u| {
            if y != row {
                (row, start) = (y, starts.next().expect("a span for each row").start.into());
            }
            let exact = case.exact(x, y);
            self.naive = self.naive.max((naive([x.into(), y.into()], start) - exact).abs());
            let error = outside(u, exact);
            self.ours = self.ours.max(error);
            self.share = self.share.max(error / case.bound(x, y));
            self.pixels += 1;
        });
    }

    fn print(&self, row: u32, method: &str) {
        println!(
            "row {row}, {method}: {:.3} texels off at worst; topleft {:.4}, {:.2} of its bound; {} px",
            self.naive,
            self.ours,
            self.share,
            grouped(self.pixels)
        );
    }
}

/// 1/w of 24 bits, at w ratios from 200 to 400.
pub(crate) fn extreme_ratios() -> Worst {
    let (mut worst, mut random) = (Worst::default(), Random::new(14));
    for i in 0..30 {
        let ratio = 200.0 + 200.0 * random.unit();
        let case = Receding::new(Kind::FullScreen.triangle(&mut random), ratio, i % 3, &mut random);
        worst.add(&case, |at, _| texel::with_fraction_bits(case.covered.triangle, case.u, case.q, 24, at));
    }
    worst
}

// Red when 1/w keeps fewer than its 31 bits: `Inverse`, `PerVertexInverse::aligned`.
#[test]
fn row_14_a_1_over_w_of_24_bits_is_not_enough_for_a_ratio_of_400() {
    let worst = extreme_ratios();
    worst.print(14, "1/w of 24 bits");
    // U rho (n + m) 2^-25 is 256 * 400 * 560 / 2^25 = 1.7 texels at worst; a seventh of it is often reached.
    assert!(worst.naive > 0.25);
    assert!(worst.share <= 1.0 && worst.ours < SIXTEENTH);
}

/// Linear texels at ratios from 2 to 4, and the least share of the closed form that the worst pixel of one reaches.
pub(crate) fn near_faces() -> (Worst, f64) {
    let (mut all, mut least, mut random) = (Worst::default(), f64::MAX, Random::new(15));
    for i in 0..30 {
        let ratio = 2.0 + 2.0 * random.unit();
        let case = Receding::new(Kind::FullScreen.triangle(&mut random), ratio, i % 3, &mut random);
        let mut worst = Worst::default();
        worst.add(&case, |[x, y], _| linear(case.covered.triangle, case.u, x, y));
        least = least.min(worst.naive / affine(255.0, ratio));
        all.naive = all.naive.max(worst.naive);
        all.ours = all.ours.max(worst.ours);
        all.share = all.share.max(worst.share);
        all.pixels += worst.pixels;
    }
    (all, least)
}

// Red when `PerPixel` divides by a 1/w of another pixel.
#[test]
fn row_15_linear_texels_bend_on_near_faces() {
    let (worst, least) = near_faces();
    worst.print(15, "affine");
    // The closed form is that of the worst line, from corner to corner; the screen shows most of it.
    assert!(least > 0.8 && worst.naive > 40.0, "{least}");
    assert!(worst.share <= 1.0 && worst.ours < SIXTEENTH);
}

/// Whole subspans of 32 px, where the furthest corner is on the right.
pub(crate) fn beyond_the_edge() -> Worst {
    let (mut worst, mut random) = (Worst::default(), Random::new(16));
    for _ in 0..60 {
        let mut at = |left: i64, right: i64, top: i64, bottom: i64| {
            [random.within(left * 256, right * 256) as i32, random.within(top * 256, bottom * 256) as i32]
        };
        // In canonical order: the far corner is the second.
        let triangle = [at(0, 60, 0, 20), at(200, 319, 60, 160), at(0, 60, 200, 239)];
        let case = Receding::new(triangle, 64.0, 0, &mut random);
        worst.add(&case, |at, start| {
            texel::of_whole_subspans(case.covered.triangle, case.u, case.q, [start, 32], at)
        });
    }
    worst
}

// Red when texels are taken from beyond a run's end.
#[test]
fn row_16_subspans_that_end_beyond_the_edge_show_spikes() {
    let worst = beyond_the_edge();
    worst.print(16, "whole subspans of 32 px");
    // Beyond the far corner 1/w goes through 0: some quotient of a few hundred rows is many times the texture.
    assert!(worst.naive > 4.0 * TEXELS);
    assert!(worst.share <= 1.0 && worst.ours < SIXTEENTH);
}

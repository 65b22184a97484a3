//! Stages 6 and 7. The pixels of a span on their way to the target: depth decides which of them are shaded.

use crate::depth::{Depth, NoDepth};
use crate::math::product::NARROW;
use crate::varying::Varying;

/// Some pixels of a row, ready to be shaded: their colours, and what lies there already.
#[expect(missing_debug_implementations, reason = "its cells are of any kind")]
pub struct Run<'r, P, D: Depth> {
    pub(crate) colours: &'r mut [P],
    pub(crate) depths: D::Plane<'r>,
    /// At the first pixel, and the step to the next.
    pub(crate) depth: D::Varying,
    pub(crate) step: D::Varying,
}

/// A pixel of a run.
#[expect(missing_debug_implementations, reason = "its cell is of any kind")]
pub struct Place<'r, P, D: Depth> {
    colour: &'r mut P,
    cell: D::Cell<'r>,
    depth: D::Varying,
}

impl<'r, P> Run<'r, P, NoDepth> {
    /// Pixels that nothing hides.
    ///
    /// ```
    /// use topleft::stages::Run;
    ///
    /// let mut colours = [0_u16; 4];
    /// for (x, place) in Run::new(&mut colours).pixels().enumerate() {
    ///     place.shade(|| x as u16 * 10);
    /// }
    /// assert_eq!(colours, [0, 10, 20, 30]);
    /// ```
    #[inline]
    pub fn new(colours: &'r mut [P]) -> Self {
        Self { colours, depths: (), depth: (), step: () }
    }
}

impl<'r, P, D: Depth> Run<'r, P, D> {
    /// How many there are.
    #[inline]
    pub fn len(&self) -> usize {
        self.colours.len()
    }

    /// Whether there is none.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.colours.is_empty()
    }

    /// Gives all visible pixels one colour.
    #[inline(always)]
    pub fn fill(self, colour: P)
    where
        P: Copy,
    {
        if D::ALWAYS_VISIBLE {
            // Written out for a small core: spans are short, so what is left after fours counts.
            // As a `while let`, a Cortex-M0+ takes 6 % longer at opt-level 3.
            let mut rest = self.colours;
            let rest = loop {
                core::hint::black_box(());
                match rest {
                    [a, b, c, d, after @ ..] => {
                        (*a, *b, *c, *d) = (colour, colour, colour, colour);
                        rest = after;
                    }
                    short => break short,
                }
            };
            let rest = match rest {
                [a, b, after @ ..] => {
                    (*a, *b) = (colour, colour);
                    after
                }
                short => short,
            };
            if let [one, ..] = rest {
                *one = colour;
            }
        } else {
            // Opaque, it is loaded before the loop and not at each pixel: where registers are few.
            let step = if NARROW { core::hint::black_box(self.step) } else { self.step };
            for place in (Self { step, ..self }).pixels() {
                place.shade(|| colour);
            }
        }
    }

    /// Calls `shade` with each run of visible pixels, and how far from the first of all it starts: for what costs more
    /// than a test a pixel.
    #[inline(always)]
    pub fn visible(self, mut shade: impl FnMut(i32, &mut [P])) {
        let Self { colours, depths, depth, step } = self;
        D::runs(colours, depths, depth, step, |skipped, shown| shade(skipped as i32, shown));
    }

    /// The pixels, from left to right, each to be tested: for what costs little.
    #[inline(always)]
    pub fn pixels(self) -> impl Iterator<Item = Place<'r, P, D>> {
        let Self { colours, depths, mut depth, step } = self;
        colours.iter_mut().zip(D::cells(depths)).map(move |(colour, cell)| {
            // Keeps the loop as it is: unrolled, it needs more registers than a small core has.
            core::hint::black_box(());
            let place = Place { colour, cell, depth };
            depth = depth.plus(step);
            place
        })
    }
}

impl<P, D: Depth> Place<'_, P, D> {
    /// Gives the pixel a colour where the triangle is nearer than what it shows.
    #[inline(always)]
    pub fn shade(self, colour: impl FnOnce() -> P) {
        self.blend(|place| *place = colour());
    }

    /// Changes the pixel's colour where the triangle is nearer than what it shows.
    #[inline(always)]
    pub fn blend(self, change: impl FnOnce(&mut P)) {
        if D::cover(self.cell, self.depth) {
            change(self.colour);
        }
    }
}

//! Pixels, counted: by a traversal that notes what another one finds.

use std::cell::RefCell;

use embedded_graphics::geometry::Size;
use scenes::View;
use topleft::Spans;
use topleft::stages::{DrawSpan, Setup, Traversal, Window};

use crate::stage::Stage;

/// How many pixels triangles cover, and how many of the display's are covered at all.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pixels {
    pub(crate) covered: usize,
    pub(crate) distinct: usize,
}

impl Pixels {
    /// Counts a frame.
    pub(crate) fn count(stage: &mut Stage<'_>, view: &View) -> Result<Self, String> {
        let Size { width, height } = stage.size;
        HITS.replace(Hits { width: width as usize, hits: vec![0; width as usize * height as usize] });
        stage.trace::<Counted>(view)?;
        let hits = HITS.take().hits;
        Ok(Self {
            covered: hits.iter().map(|&hits| hits as usize).sum(),
            distinct: hits.iter().filter(|&&hits| hits > 0).count(),
        })
    }

    /// How often a covered pixel is covered.
    pub(crate) fn overdraw(&self) -> f64 {
        self.covered as f64 / self.distinct.max(1) as f64
    }
}

#[derive(Default)]
struct Hits {
    width: usize,
    hits: Vec<u32>,
}

thread_local! {
    static HITS: RefCell<Hits> = RefCell::default();
}

/// The span walk, with every pixel noted.
struct Counted;

impl Traversal for Counted {
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        Spans::walk(setup, window, |span| {
            HITS.with_borrow_mut(|hits| {
                let row = span.y as usize * hits.width;
                for pixel in &mut hits.hits[row + span.start as usize..row + span.end as usize] {
                    *pixel += 1;
                }
            });
            target.draw(span)
        })
    }
}

//! Traversals that draw nothing: one to tell set-up from raster, one to count pixels.

use core::hint::black_box;
use core::sync::atomic::{AtomicU32, Ordering};

use topleft::Spans;
use topleft::stages::{DrawSpan, Setup, Traversal, Window};

/// Walks nothing: what is left is taking triangles from the list and making their planes.
#[derive(Debug)]
pub(crate) enum Nothing {}

impl Traversal for Nothing {
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        // The compiler has to believe that all of it is used.
        black_box((setup, window, &target));
        Ok(())
    }
}

/// Counts the pixels of all spans.
#[derive(Debug)]
pub(crate) enum Counting {}

static COUNT: AtomicU32 = AtomicU32::new(0);

impl Counting {
    /// What was counted since the last call.
    pub(crate) fn take() -> u32 {
        let count = COUNT.load(Ordering::Relaxed);
        COUNT.store(0, Ordering::Relaxed);
        count
    }
}

impl Traversal for Counting {
    fn spans<E>(setup: &Setup, window: &Window, _: &mut impl DrawSpan<E>) -> Result<(), E> {
        Spans::walk(setup, window, |span| {
            // One core, and no interrupt counts: the chip needs no atomic addition.
            let count = COUNT.load(Ordering::Relaxed);
            COUNT.store(count + span.end.abs_diff(span.start), Ordering::Relaxed);
            Ok(())
        })
    }
}

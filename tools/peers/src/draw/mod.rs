//! Each rasterizer in a file of its own.

mod embedded_3dgfx;
mod embedded_graphics;
mod euc;
mod frame;
mod ours;
mod retrofire;

use crate::peer::Peer;

/// All of them: ours first.
pub(crate) fn all() -> Vec<Box<dyn Peer>> {
    vec![
        Box::new(ours::WholeDepth::default()),
        Box::new(ours::ListDepth::default()),
        Box::new(retrofire::TriFill::default()),
        Box::new(euc::Filled::default()),
        Box::new(embedded_3dgfx::Engine::default()),
        Box::new(embedded_3dgfx::FixedDepth::default()),
        Box::new(ours::WholeFlat::default()),
        Box::new(ours::ListFlat::default()),
        Box::new(embedded_3dgfx::FixedFlat::default()),
        Box::new(embedded_graphics::Filled::default()),
    ]
}

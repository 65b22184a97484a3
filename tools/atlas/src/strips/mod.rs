//! Strips of what is seen where a method fails, by family; named by their row in the failure suite.

mod coverage;
mod order;
mod perspective;
mod slivers;
mod textures;

use crate::Entry;

pub(crate) const ALL: &[Entry] = &[
    ("01-shared-edges", coverage::shared_edges),
    ("02-fan", coverage::fan),
    ("03-guard-sized", coverage::guard_sized),
    ("04-beyond-the-guard", coverage::beyond_the_guard),
    ("06-turned-over", coverage::turned_over),
    ("07-needles", slivers::needles),
    ("08-large", slivers::large),
    ("13-clipped-by-size", coverage::clipped_by_size),
    ("15-affine-cube", perspective::affine_cube),
    ("19-below-zero", textures::below_zero),
    ("31-strips", order::strips),
    ("33-alpha-inside", coverage::alpha_inside),
];

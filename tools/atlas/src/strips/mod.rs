//! Strips of what is seen where a method fails, by family; named by their row in the failure suite.

mod coverage;
mod depth;
mod order;
mod perspective;
mod slivers;
mod snapped;
mod subspans;
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
    ("09-t-junction", snapped::t_junction),
    ("11-behind-the-eye", perspective::behind_the_eye),
    ("13-clipped-by-size", coverage::clipped_by_size),
    ("15-affine-cube", perspective::affine_cube),
    ("16-subspans", subspans::beyond_the_edge),
    ("17-slow-motion", snapped::slow_motion),
    ("18-minified", perspective::minified),
    ("19-below-zero", textures::below_zero),
    ("20-beyond-the-last", textures::beyond_the_last),
    ("24-coplanar", depth::coplanar),
    ("25-crossing-planes", depth::crossing_planes),
    ("27-not-a-number", snapped::not_a_number),
    ("31-strips", order::strips),
    ("32-corners", order::corners),
    ("33-alpha-inside", coverage::alpha_inside),
];

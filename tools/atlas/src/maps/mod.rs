//! Maps of where methods break, by what is hard for them.

mod coverage;
mod depth;
mod slivers;
mod texels;

use crate::Entry;

pub(crate) const ALL: &[Entry] = &[
    ("map-coverage", coverage::map),
    ("map-depth", depth::map),
    ("map-slivers", slivers::map),
    ("map-texels", texels::map),
];

//! What the table of cycles measures on `grid240`, by the library alone.
#![cfg_attr(target_os = "none", no_std, no_main)]

footprint::image!(|memory| footprint::methods::<topleft::Spans>(memory));

//! A scene as people ship it.
#![cfg_attr(target_os = "none", no_std, no_main)]

footprint::image!(|memory| footprint::demo::<topleft::Spans>(memory));

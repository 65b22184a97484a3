//! The same as `methods`, with small triangles in Thumb instructions.
#![cfg_attr(target_os = "none", no_std, no_main)]

footprint::image!(|memory| footprint::methods::<topleft_thumb::Spans>(memory));

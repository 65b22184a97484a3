//! The same scene as `demo`, with small triangles in Thumb instructions.
#![cfg_attr(target_os = "none", no_std, no_main)]

footprint::image!(|memory| footprint::demo::<topleft_thumb::Spans>(memory));

//! Any meshes, poses, camera, target, strips, list, shaders and depth.
#![no_main]

use libfuzzer_sys::{Corpus, fuzz_target};

// What shows nothing is tried, and not kept: it would lead to more of its kind.
fuzz_target!(|frame: topleft_fuzz::Frame| -> Corpus {
    if frame.check() == 0 { Corpus::Reject } else { Corpus::Keep }
});

//! Any bytes as a mesh and as a texture, drawn where they are one.
#![no_main]

use libfuzzer_sys::{Corpus, fuzz_target};

// What shows nothing is tried, and not kept: most of it is no blob.
fuzz_target!(|bytes: &[u8]| -> Corpus {
    if topleft_fuzz::check_blob(bytes) == 0 { Corpus::Reject } else { Corpus::Keep }
});

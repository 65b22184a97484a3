//! Nothing: what the others have as well.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

footprint::image!(|memory| {
    black_box((footprint::mesh(), memory));
});

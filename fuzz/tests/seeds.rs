//! The seeds through the same functions as in the fuzz targets: no fuzzer is needed for it.

use std::fs;
use std::path::Path;

use arbitrary::{Arbitrary, Unstructured};
use topleft_fuzz::{Case, Frame, check_blob};

/// The files of a target's seeds, by name.
fn seeds(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds").join(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry of a folder").path()).collect();
    paths.sort();
    paths.iter().map(|path| fs::read(path).expect("a seed can be read")).collect()
}

/// Each seed as it is, and 50 times with a few other bytes: a fuzzer without feedback. `check` gives back pixels.
///
/// All seeds were kept because they draw something. A change of what an input means would make them worthless unseen.
fn replay(target: &str, check: impl Fn(&[u8]) -> usize) {
    let mut random = 1_u64;
    let seeds = seeds(target);
    let (mut drawing, mut pixels) = (0, 0);
    for seed in &seeds {
        let drawn = check(seed);
        (drawing, pixels) = (drawing + usize::from(drawn > 0), pixels + drawn);
        for _ in 0..50 {
            let mut changed = seed.clone();
            for _ in 0..3 {
                random =
                    random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                if let Some(byte) = changed.get_mut((random >> 40) as usize % seed.len().max(1)) {
                    *byte = (random >> 32) as u8;
                }
            }
            pixels += check(&changed);
        }
    }
    println!("{drawing} of {} seeds of {target} draw something; {pixels} pixels", seeds.len());
    assert!(
        drawing >= 10 && drawing * 10 >= seeds.len() * 9,
        "{drawing} of {} seeds of {target}",
        seeds.len()
    );
}

/// An input as the fuzzer would make it.
fn input<'a, T: Arbitrary<'a>>(bytes: &'a [u8]) -> Option<T> {
    T::arbitrary_take_rest(Unstructured::new(bytes)).ok()
}

#[test]
fn mesh_blob() {
    replay("mesh_blob", check_blob);
}

#[test]
fn pipeline() {
    replay("pipeline", |bytes| input(bytes).map_or(0, |frame: Frame| frame.check()));
}

#[test]
fn triangle_i128() {
    replay("triangle_i128", |bytes| input(bytes).map_or(0, |case: Case| case.check()));
}

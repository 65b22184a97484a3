//! The reference against itself: each stage has a second, independent answer or a case worked out by hand.

mod transform;
mod clip;
mod setup;
mod raster;
mod homogeneous;
mod varying;
mod shade;
mod render;
mod compare;

/// Fails unless the two are within `tolerance`, each component on its own.
#[track_caller]
fn assert_near<const N: usize>(got: [f64; N], wanted: [f64; N], tolerance: f64) {
    let near = got.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= tolerance);
    assert!(near, "got {got:?}, wanted {wanted:?} within {tolerance}");
}

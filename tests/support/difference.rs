//! What two results differ in.

use std::fmt::Debug;

/// Nothing where both are equal; else their first difference, as the pixel of a frame `width` pixels wide.
pub(crate) fn same<T: PartialEq + Debug>(
    what: &str,
    width: usize,
    got: &[T],
    expected: &[T],
) -> Result<(), String> {
    if got.len() != expected.len() {
        return Err(format!("{what}: {} pixels instead of {}", got.len(), expected.len()));
    }
    match got.iter().zip(expected).position(|(a, b)| a != b) {
        None => Ok(()),
        Some(i) => {
            let (x, y) = (i % width.max(1), i / width.max(1));
            let differing = got.iter().zip(expected).filter(|(a, b)| a != b).count();
            let (a, b) = (&got[i], &expected[i]);
            Err(format!("{what}: {a:?} instead of {b:?} at column {x}, row {y}; {differing} pixels differ"))
        }
    }
}

//! The f64 and i128 reference.

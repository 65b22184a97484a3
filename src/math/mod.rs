//! Numbers only: formats, reciprocals, angles, matrices. Nothing here knows of triangles.

pub(crate) mod format;
pub(crate) mod product;
pub(crate) mod recip;
pub(crate) mod turn;
pub(crate) mod matrix;

//! What lectures teach and peers ship, written plainly and kept to be measured against: each method here fails
//! somewhere, and `tests/stability` shows where and by how much.

pub mod triangles;

pub mod snap;
pub mod screen_clip;
pub mod near;
pub mod edge_function;
pub mod scanline;
pub mod plane;
pub mod sample;
pub mod texel;
pub mod alpha_edges;

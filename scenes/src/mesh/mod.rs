//! The meshes of the scenes, made by `meshpack make`.

mod cube;
mod floor;
mod grid240;
mod grid240_tilted;
mod icosphere;
mod icosphere_fine;
mod teapot;
mod torus_knot;

pub use cube::CUBE;
pub use floor::FLOOR;
pub use grid240::GRID240;
pub use grid240_tilted::GRID240_TILTED;
pub use icosphere::ICOSPHERE;
pub use icosphere_fine::ICOSPHERE_FINE;
pub use teapot::TEAPOT;
pub use torus_knot::TORUS_KNOT;

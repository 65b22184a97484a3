//! The meshes of the scenes, made by `meshpack make`.

mod corridor;
mod cube;
mod dial;
mod floor;
mod globe;
mod grid240;
mod grid240_tilted;
mod ground;
mod icosphere;
mod icosphere_fine;
mod ladder;
mod star;
mod teapot;
mod torus_knot;

pub use corridor::CORRIDOR;
pub use cube::CUBE;
pub use dial::DIAL;
pub use floor::FLOOR;
pub use globe::GLOBE;
pub use grid240::GRID240;
pub use grid240_tilted::GRID240_TILTED;
pub use ground::GROUND;
pub use icosphere::ICOSPHERE;
pub use icosphere_fine::ICOSPHERE_FINE;
pub use ladder::LADDER;
pub use star::STAR;
pub use teapot::TEAPOT;
pub use torus_knot::TORUS_KNOT;

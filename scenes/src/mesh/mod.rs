//! The meshes of the scenes, made by `meshpack make`.

mod cube;
mod floor;
mod grid240;
mod grid240_tilted;
mod icosphere;
mod icosphere_fine;
mod island_boats;
mod island_land;
mod island_lighthouse;
mod island_props;
mod island_sea;
mod teapot;
mod torus_knot;

pub use cube::CUBE;
pub use floor::FLOOR;
pub use grid240::GRID240;
pub use grid240_tilted::GRID240_TILTED;
pub use icosphere::ICOSPHERE;
pub use icosphere_fine::ICOSPHERE_FINE;
pub use island_boats::ISLAND_BOATS;
pub use island_land::ISLAND_LAND;
pub use island_lighthouse::ISLAND_LIGHTHOUSE;
pub use island_props::ISLAND_PROPS;
pub use island_sea::ISLAND_SEA;
pub use teapot::TEAPOT;
pub use torus_knot::TORUS_KNOT;

//! The textures of the scenes, made by `meshpack make`.

mod brick;
mod checker;
mod test_card;
mod waves;

pub use brick::BRICK;
pub use checker::CHECKER;
pub use test_card::TEST_CARD;
pub use waves::WAVES;

//! The board: its clocks, its pins, and the panel on its bus.

mod board;
mod bus;
mod button;
mod device;

pub use board::{Board, Driver, Parts};
pub use bus::Panel;
pub use button::Next;
pub use device::Only;

/// The boot ROM copies it to RAM, and it sets up the flash.
#[expect(unsafe_code, reason = "the boot ROM wants it in the first 256 bytes of flash")]
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

//! The RP2040: the emulator counts its cycles.

use bench::{Clock, Part};
use semihosting::sys::arm_compat::{sys_elapsed, sys_write0};

/// The boot ROM copies it to RAM, and it sets up the flash; in the emulator it is passed over.
#[expect(unsafe_code, reason = "the boot ROM wants it in the first 256 bytes of flash")]
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// The core's clock cycles, which semihosting calls elapsed ticks.
pub(super) struct Cycles(());

impl Cycles {
    pub(super) fn new() -> Self {
        Self(())
    }
}

impl Clock for Cycles {
    #[inline(never)]
    fn now(&mut self) -> u64 {
        sys_elapsed().unwrap_or_default()
    }

    /// By the debugger's string call: the emulator takes what it is given for the name of the next part.
    fn next(&mut self, part: Part) {
        sys_write0(match part {
            Part::Overhead => c"overhead",
            Part::Vertex => c"vertex",
            Part::Clear => c"clear",
            Part::Setup => c"setup",
            Part::Render => c"render",
        });
    }
}

//! QEMU's virt machine with a 32-bit RISC-V core: a register of the core counts instructions.

use bench::Clock;
use riscv::register::minstret;

/// Instructions since the start.
pub(super) struct Instructions(());

impl Instructions {
    pub(super) fn new() -> Self {
        Self(())
    }
}

impl Clock for Instructions {
    #[inline(never)]
    fn now(&mut self) -> u64 {
        minstret::read64()
    }
}

//! QEMU's mps2-an386: its `SysTick` counts instructions.

use core::sync::atomic::{AtomicU32, Ordering};

use bench::Clock;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// Instructions since the start. With `-icount shift=6` one takes 64 ns, and a tick of 25 MHz takes 40 ns.
pub(super) struct Instructions(());

const WRAP: u32 = 1 << 24;
static WRAPS: AtomicU32 = AtomicU32::new(0);

impl Instructions {
    pub(super) fn new() -> Self {
        let Some(peripherals) = cortex_m::Peripherals::take() else { return Self(()) };
        let mut timer = peripherals.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(WRAP - 1);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
        Self(())
    }
}

impl Clock for Instructions {
    #[inline(never)]
    fn now(&mut self) -> u64 {
        loop {
            let before = WRAPS.load(Ordering::Relaxed);
            let ticks = WRAP - 1 - SYST::get_current();
            if before == WRAPS.load(Ordering::Relaxed) {
                let ticks = u64::from(before) * u64::from(WRAP) + u64::from(ticks);
                return ticks * 40 / 64;
            }
        }
    }
}

#[cortex_m_rt::exception]
fn SysTick() {
    WRAPS.store(WRAPS.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
}

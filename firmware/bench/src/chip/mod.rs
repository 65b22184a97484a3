//! The chip's entry.

use bench::Row;
use semihosting::println;

#[cfg(armv6m)]
mod rp2040;
#[cfg(armv6m)]
use rp2040::Cycles as Counter;

#[cfg(all(target_arch = "arm", not(armv6m)))]
mod mps2;
#[cfg(all(target_arch = "arm", not(armv6m)))]
use mps2::Instructions as Counter;

#[cfg(target_arch = "riscv32")]
mod virt;
#[cfg(target_arch = "riscv32")]
use virt::Instructions as Counter;

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn entry() -> ! {
    println!("# {}\n{}", bench::COMPILER, Row::HEADER);
    bench::run(&mut Counter::new(), &mut |row| println!("{row}"));
    semihosting::process::exit(0)
}

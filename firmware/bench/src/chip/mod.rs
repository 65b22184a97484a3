//! The chip's entry.

use bench::Row;
use semihosting::println;

#[cfg(armv6m)]
mod rp2040;
#[cfg(armv6m)]
use rp2040::Cycles as Counter;

#[cfg(not(armv6m))]
mod mps2;
#[cfg(not(armv6m))]
use mps2::Instructions as Counter;

#[cortex_m_rt::entry]
fn entry() -> ! {
    println!("# {}\n{}", bench::COMPILER, Row::HEADER);
    bench::run(&mut Counter::new(), &mut |row| println!("{row}"));
    semihosting::process::exit(0)
}

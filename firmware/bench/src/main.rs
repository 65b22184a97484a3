//! The bench as an image for a chip, which reports by semihosting, or as a host's command, which measures nothing.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod chip;

#[cfg(not(target_os = "none"))]
fn main() {
    struct Nothing;

    impl bench::Clock for Nothing {
        fn now(&mut self) -> u64 {
            0
        }
    }

    println!("# {}\n{}", bench::COMPILER, bench::Row::HEADER);
    bench::run(&mut Nothing, &mut |row| println!("{row}"));
}

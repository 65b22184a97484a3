//! Hands on what the tables say about the build.

use std::env;
use std::process::Command;

fn main() {
    let variable = |name: &str| env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"));
    println!("cargo::rustc-check-cfg=cfg(armv6m)");
    if variable("TARGET").starts_with("thumbv6m") {
        println!("cargo::rustc-cfg=armv6m");
    }
    let version = Command::new(variable("RUSTC")).arg("--version").output().expect("the compiler runs");
    println!("cargo::rustc-env=BENCH_COMPILER={}", String::from_utf8_lossy(&version.stdout).trim());
    println!("cargo::rustc-env=BENCH_OPT_LEVEL={}", variable("OPT_LEVEL"));
    println!("cargo::rerun-if-changed=build.rs");
}

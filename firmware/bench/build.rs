//! Picks the chip's memory map, and hands on what the tables say about the build.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

fn main() {
    let variable = |name: &str| env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"));
    let memory = match variable("TARGET").as_str() {
        "thumbv6m-none-eabi" => Some("rp2040.x"),
        "thumbv7em-none-eabihf" => Some("mps2-an386.x"),
        _ => None,
    };
    if let Some(memory) = memory {
        let out = PathBuf::from(variable("OUT_DIR"));
        fs::copy(memory, out.join("memory.x")).expect("the memory map can be copied");
        println!("cargo::rustc-link-search={}", out.display());
        println!("cargo::rerun-if-changed={memory}");
    }
    println!("cargo::rustc-check-cfg=cfg(armv6m)");
    if variable("TARGET").starts_with("thumbv6m") {
        println!("cargo::rustc-cfg=armv6m");
    }
    let version = Command::new(variable("RUSTC")).arg("--version").output().expect("the compiler runs");
    println!("cargo::rustc-env=BENCH_COMPILER={}", String::from_utf8_lossy(&version.stdout).trim());
    println!("cargo::rustc-env=BENCH_OPT_LEVEL={}", variable("OPT_LEVEL"));
    println!("cargo::rerun-if-changed=build.rs");
}

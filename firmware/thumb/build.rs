//! Tells the code whether its chip has the Thumb instructions of a Cortex-M, and whether it has no others.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(thumb, narrow)");
    let target = std::env::var("TARGET").unwrap_or_default();
    if ["thumbv6m-", "thumbv7", "thumbv8"].iter().any(|name| target.starts_with(name)) {
        println!("cargo::rustc-cfg=thumb");
    }
    if ["thumbv6m-", "thumbv8m.base-"].iter().any(|name| target.starts_with(name)) {
        println!("cargo::rustc-cfg=narrow");
    }
}

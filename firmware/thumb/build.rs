//! Tells the code whether its chip has Thumb instructions.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(thumb)");
    if std::env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv")) {
        println!("cargo::rustc-cfg=thumb");
    }
}

//! Passes two scripts to the linker. `fast.x`, which is beside this file, comes first: it takes its code before `link.x` of `cortex-m-rt` takes the rest.

fn main() {
    println!("cargo::rerun-if-changed=fast.x");
    let is_board = std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "none");
    if let (true, Ok(package)) = (is_board, std::env::var("CARGO_MANIFEST_DIR")) {
        println!("cargo::rustc-link-arg-bins=-T{package}/fast.x");
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
}

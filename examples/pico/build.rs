//! Passes two scripts to the linker. `fast.x`, which is beside this file, comes first: it takes its code before `link.x` of `cortex-m-rt` takes the rest.

use std::{env, fs};

fn main() {
    println!("cargo::rerun-if-changed=fast.x");
    let is_board = env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "none");
    if let (true, Ok(out)) = (is_board, env::var("OUT_DIR")) {
        // the script is copied, because this package may be moved after the build script has run
        fs::write(format!("{out}/fast.x"), include_bytes!("fast.x")).expect("the build folder can be written");
        println!("cargo::rustc-link-arg-bins=-T{out}/fast.x");
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
}

//! Builds firmware with the commands of its users and runs it in third-party emulators: QEMU, rp2040js and node.
//!
//! * [`Firmware`] is a program of a package in this repository; [`Firmware::build`] builds it.
//! * [`Machine`](machine::Machine) runs a program that prints and ends, on any Cortex-M or in WebAssembly.
//! * [`Counter`](counter::Counter) counts the instructions of parts of a run.
//! * [`board`] has the boards with an output: their programs, and their displays or printed lines during a run.
//! * [`Qemu`](qemu::Qemu) runs a board from one picture to the next.
//! * [`Program`](program::Program) and [`footprint`](footprint::footprint) read linked programs.
#![allow(clippy::missing_errors_doc, reason = "what fails says what cargo, the emulator or the program did wrong")]

pub mod board;
pub mod counter;
pub mod film;
mod firmware;
pub mod footprint;
mod gdb;
pub mod machine;
pub mod photograph;
pub mod program;
pub mod qemu;

use std::path::{Path, PathBuf};

pub use firmware::{Firmware, Programs};

/// An error with a message for the user.
pub type Error = Box<dyn std::error::Error + Send + Sync>;

/// A result whose error is a message for the user.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// The oldest supported Rust.
pub const TOOLCHAIN: &str = concat!(env!("CARGO_PKG_RUST_VERSION"), ".0");

/// The target folder of programs for boards. All packages share it, so that each dependency is compiled once.
pub fn target() -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    root().join(target).join("boards")
}

/// The root of the repository.
///
/// # Panics
///
/// If this package has been moved out of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("the package lies in laboratory/emulator")
}

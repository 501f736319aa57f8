//! Builds firmware as its users do and runs it in emulators that others wrote.
//!
//! * [`Firmware`] is a program of a package in this repository; [`Firmware::build`] builds it.
//! * [`Machine`](machine::Machine) runs a program that prints and ends, on any Cortex-M or in WebAssembly.
//! * [`Counter`](counter::Counter) counts the instructions of a part of a run.
//! * [`board`] has the boards that show something: their programs, and what is seen of them while they run.
//! * [`Qemu`](qemu::Qemu) runs a board from one picture to the next; [`Program`](program::Program) and [`footprint`](footprint::footprint) look into programs.
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

/// What went wrong, in words for a user.
pub type Error = Box<dyn std::error::Error + Send + Sync>;

/// What was asked for, or what went wrong.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// The oldest supported Rust.
pub const TOOLCHAIN: &str = concat!(env!("CARGO_PKG_RUST_VERSION"), ".0");

/// Where programs for boards are built: one place for all packages, so that they share what they depend on.
pub fn target() -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    root().join(target).join("boards")
}

/// The root of the repository.
///
/// # Panics
///
/// Where this package has been taken out of it.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("the package lies in laboratory/emulator")
}

//! What the number types run, and the clock that they run against. The race knows no board: a host runs the same, to the last bit.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(target_os = "none")]
pub mod clock;
pub mod race;

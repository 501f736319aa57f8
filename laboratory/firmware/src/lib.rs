//! What the programs of this package share.
#![no_std]

#[cfg(target_os = "none")]
pub mod clock;

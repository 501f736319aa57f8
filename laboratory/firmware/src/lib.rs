//! What the programs of this package share.
#![no_std]

#[cfg(target_os = "none")]
pub mod clock;

/// The frequency of `SysTick` on QEMU's LM3S6965 board, Hz: its divider is 16 after a reset, of 200 MHz.
pub const FREQUENCY: u32 = 12_500_000;

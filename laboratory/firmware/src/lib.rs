//! Code shared by the programs of this package.
#![no_std]

#[cfg(target_os = "none")]
pub mod clock;

/// The frequency of `SysTick` on QEMU's LM3S6965 board, Hz: 200 MHz, divided by 16 after a reset.
pub const FREQUENCY: u32 = 12_500_000;

//! A race of number types, and the clock that measures it. The race does not depend on the board: a host runs it with the same results, to the last bit.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(target_os = "none")]
pub mod clock;
pub mod race;

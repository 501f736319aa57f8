//! The flag and its picture on the LEDs. Nothing here depends on the board: a host computes the same, to the last bit.
#![no_std]
#![forbid(unsafe_code)]

pub mod leds;
pub mod show;

//! What the round LCD shows. Nothing here knows the board: a host plays the same, to the last bit.
#![no_std]
#![forbid(unsafe_code)]

pub mod picture;
pub mod show;

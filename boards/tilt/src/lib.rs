//! The kerchief and its picture on the round LCD. Nothing here depends on the board: a host computes the same, to the last bit.
#![no_std]
#![forbid(unsafe_code)]

pub mod picture;
pub mod show;

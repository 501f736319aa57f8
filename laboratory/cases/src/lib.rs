//! The scenes that both hosts and boards play.
//!
//! [`CASES`] are the scenes of the digests. All [`METHODS`] play each of them in all [`NUMBERS`], and [`TABLE`] has the digests. [`bench`] has the scenes
//! whose instructions are counted.
#![no_std]
#![forbid(unsafe_code)]

pub mod bench;
mod cases;
mod play;
mod setup;
mod table;

pub use cases::CASES;
pub use play::{METHODS, Method, NUMBERS, Number, Outcome};
pub use setup::{Ball, Drag, Ground, Mass, Rod, SIDE, Setup, Spring, Surface, Wind};
pub use table::TABLE;

//! Cloth that runs on a microcontroller.
#![no_std]

pub mod cloth;
pub mod grid;
#[cfg(feature = "graphics")]
pub mod render;
pub mod scalar;
pub mod units;
pub mod vec3;

pub use cloth::Cloth;
pub use grid::{Grid, Node};
pub use scalar::{Q24, Scalar};
pub use units::{Point, Units};
pub use vec3::Vec3;

//! The boards with a display or a serial output.

pub mod feather;
pub mod lcd;
pub mod microbit;
pub mod oled;
pub mod pico;
mod rp2040;
pub mod ssd1306;
pub mod tilt;

//! The programs for boards, in third-party emulators: each board shows the pixels that a host draws, and prints the results that a host computes.

mod feather;
mod figures;
mod microbit;
mod oled;
mod pico;
mod report;
mod ssd1306;
mod tilt;

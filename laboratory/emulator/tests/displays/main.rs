//! The programs for boards, in emulators that others wrote: what a board shows is what a host draws, pixel for pixel, and what it prints is what a host computes.

mod feather;
mod figures;
mod microbit;
mod oled;
mod pico;
mod report;
mod ssd1306;
mod tilt;

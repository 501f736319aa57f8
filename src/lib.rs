//! Cloth that runs on a microcontroller.
#![no_std]

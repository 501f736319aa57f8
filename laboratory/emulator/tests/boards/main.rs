//! Firmware on emulated boards: equal digests on every machine, executed instructions, flash and RAM, and the functions that a step links.
//!
//! `UPDATE_INSTRUCTIONS=1 cargo test -p emulator --test boards -- --ignored published` rewrites the figures.

mod capacity;
mod counters;
mod digests;
mod figures;
mod image;
mod measure;
mod report;
mod rules;

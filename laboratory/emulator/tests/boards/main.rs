//! Firmware on emulated boards: equal digests on every machine, executed instructions, flash and RAM, and what a step links.
//!
//! `UPDATE_INSTRUCTIONS=1 cargo test -p emulator --test boards -- --ignored published` writes the figures anew.

mod capacity;
mod counters;
mod digests;
mod figures;
mod image;
mod measure;
mod report;
mod rules;

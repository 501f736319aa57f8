//! Firmware on emulated boards: equal digests on every machine, executed instructions, flash and RAM, and what a step links.
//!
//! `UPDATE_INSTRUCTIONS=1 cargo test --test boards` writes the figures anew.

mod capacity;
mod digests;
mod figures;
mod image;
mod measure;
mod report;
mod rules;

#[path = "../../examples/firmware/bench.rs"]
mod bench;
#[path = "../digests/cases.rs"]
mod cases;
#[path = "../../examples/emulate/firmware.rs"]
mod firmware;
#[path = "../../examples/emulate/footprint.rs"]
mod footprint;
#[path = "../../examples/emulate/machine.rs"]
mod machine;
#[path = "../digests/play.rs"]
mod play;
#[path = "../digests/setup.rs"]
mod setup;
#[path = "../digests/table.rs"]
mod table;

//! A step from a state and with parameters of any bits.
#![no_main]

#[path = "../state.rs"]
mod state;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| state::play(bytes));

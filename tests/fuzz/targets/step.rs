//! Plays steps from a state and parameters of arbitrary bits.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kerchief_fuzz::state::play(bytes));

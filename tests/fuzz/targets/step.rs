//! A step from a state and with parameters of any bits.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kerchief_fuzz::state::play(bytes));

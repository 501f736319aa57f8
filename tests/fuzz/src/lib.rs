//! What fuzzers play, and ordinary tests play again.

pub mod file;
pub mod state;

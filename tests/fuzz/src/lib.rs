//! Scenes from arbitrary bytes, played by fuzzers and again by ordinary tests.

pub mod file;
pub mod state;

//! Solvers against what mathematics solves, and the thesis' question.

#[path = "../reference/mod.rs"]
mod reference;
#[path = "../rig/mod.rs"]
mod rig;

mod chain;
mod thesis;

//! Solvers against what mathematics solves, and the thesis' question.

mod chain;
mod thesis;

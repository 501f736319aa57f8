//! Solvers against closed forms, and the thesis' question of super-elasticity.

mod chain;
mod thesis;

//! What sheets must survive: in every run finite, bounded, the same twice, without a panic, and afterwards they settle.

mod day;
mod elasticity;
mod hands;
mod materials;
mod ordeal;
mod stage;
mod starts;

//! What the laboratory's programs share: configurations, the reference, costs, plots, pages.

// Each program takes what it needs.
#![allow(dead_code)]

pub(crate) mod callgrind;
pub(crate) mod configuration;
pub(crate) mod cost;
pub(crate) mod front;
pub(crate) mod measurement;
pub(crate) mod motion;
pub(crate) mod page;
pub(crate) mod plot;
pub(crate) mod reference;
pub(crate) mod scenes;
pub(crate) mod study;
pub(crate) mod verdict;

/// Stack of a worker, bytes: grids of 64 × 64 pass through it.
const STACK: usize = 64 << 20;

/// Gives the workers of parallel loops stacks that large grids fit.
pub(crate) fn prepare_workers() -> Result<(), String> {
    rayon::ThreadPoolBuilder::new().stack_size(STACK).build_global().map_err(|error| error.to_string())
}

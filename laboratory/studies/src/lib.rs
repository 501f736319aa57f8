//! What the laboratory's programs share: configurations, the reference, plots, pages.

// Each program takes what it needs.
#![allow(dead_code)]

pub(crate) mod configuration;
pub(crate) mod front;
pub(crate) mod measurement;
pub(crate) mod page;
pub(crate) mod plot;
pub(crate) mod reference;
pub(crate) mod scenes;

use kerchief::host::{Description, ScalarKind, SceneError, Simulation};

/// How a program sets scenes in motion.
pub(crate) type Start = fn(&Description, ScalarKind) -> Result<Box<dyn Simulation>, SceneError>;

/// Stack of a worker, bytes: grids of 64 × 64 pass through it.
const STACK: usize = 64 << 20;

/// Gives the workers of parallel loops stacks that large grids fit.
pub(crate) fn prepare_workers() -> Result<(), String> {
    rayon::ThreadPoolBuilder::new().stack_size(STACK).build_global().map_err(|error| error.to_string())
}

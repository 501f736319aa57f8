//! Common parts of the laboratory's programs: configurations, the reference, plots, pages.
#![allow(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    reason = "not published: names and signatures say it"
)]

pub mod configuration;
pub mod front;
pub mod measurement;
pub mod page;
pub mod plot;
pub mod reference;
pub mod scenes;
pub mod strip;

pub use console::Start;

/// Stack of a worker, bytes: grids of 64 × 64 are passed by value.
const STACK: usize = 64 << 20;

/// Gives the workers of parallel loops stacks that are large enough for large grids.
pub fn prepare_workers() -> Result<(), String> {
    rayon::ThreadPoolBuilder::new().stack_size(STACK).build_global().map_err(|error| error.to_string())
}

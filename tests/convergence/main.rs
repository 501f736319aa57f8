//! Every solver against the reference.

#[path = "../reference/mod.rs"]
mod reference;
#[path = "../rig/mod.rs"]
mod rig;

mod agreement;
mod floors;
mod orders;

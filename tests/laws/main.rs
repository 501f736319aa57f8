//! Laws that hold for every solver and number type.

#[path = "../reference/mod.rs"]
mod reference;
#[path = "../rig/mod.rs"]
mod rig;

mod absent;
mod constraints;
mod contact;
mod dampers;
mod falling;
mod symmetry;

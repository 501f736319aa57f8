//! Laws for every solver and number type.

mod absent;
mod changed;
mod constraints;
mod contact;
mod dampers;
mod falling;
mod symmetry;
mod wrappers;

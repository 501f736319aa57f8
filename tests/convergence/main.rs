//! Every solver against the reference.

mod agreement;
mod floors;
mod orders;

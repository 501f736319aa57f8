//! Every grid and number type that a scene file may name, compiled once for all host programs.
//!
//! No other crate of the workspace takes as long to compile: each pair compiles the whole core again, with all six solvers. Programs and tests that need few
//! pairs call [`kerchief::simulations!`] themselves.

use kerchief::{Q13, Q24};

macro_rules! all {
    ($(($columns:literal, $rows:literal, $faces:literal))*) => {
        kerchief::simulations! {
            /// Sets a scene up in a number type, on any of [`SHAPES`](kerchief::host::SHAPES).
            pub fn simulation;
            scalars: F32 = f32, F64 = f64, Q24 = Q24, Q13 = Q13;
            grids: $(($columns, $rows))*
        }
    };
}
kerchief::for_each_shape!(all);

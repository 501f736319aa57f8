//! The laboratory's own scenes.

use kerchief::host::{BUILT_IN, BuiltIn};

macro_rules! scenes {
    ($(#[$doc:meta])* $list:ident: $($name:literal)*) => {
        $(#[$doc])*
        pub const $list: &[BuiltIn] = &[$(
            BuiltIn { name: $name, text: include_str!(concat!("../../../examples/scenes/laboratory/", $name, ".toml")) }
        ),*];
    };
}
scenes! {
    /// The scenes of the solver's goals.
    GOALS: "two-corners-16" "two-corners-32" "top-edge-32" "flag-32" "ball-32"
        "two-corners-16-stiff" "two-corners-32-stiff" "ball-32-stiff" "upright-32"
}
scenes! {
    /// Scenes that show every solver's order, without and with forces that depend on velocities.
    ORDERS: "swing-8" "breeze-8"
}

/// Scenes of which only the strain is measured: a solution in time to the precision of interest is out of reach.
pub const STRAIN_ONLY: [&str; 4] = ["two-corners-16-stiff", "two-corners-32-stiff", "ball-32-stiff", "upright-32"];

/// Every scene that has a name.
pub fn named() -> Vec<BuiltIn> {
    GOALS.iter().chain(ORDERS).chain(BUILT_IN).copied().collect()
}

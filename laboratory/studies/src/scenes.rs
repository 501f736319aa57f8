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
    /// Scenes for the goals of the line solver.
    GOALS: "two-corners-16" "two-corners-32" "top-edge-32" "flag-32" "ball-32"
        "two-corners-16-stiff" "two-corners-32-stiff" "ball-32-stiff" "upright-32"
}
scenes! {
    /// Scenes that show every solver's order: one without and one with forces that depend on velocities.
    ORDERS: "swing-8" "breeze-8"
}

/// Scenes in which only the strain is measured: their motion cannot be solved to the precision of interest.
pub const STRAIN_ONLY: [&str; 4] = ["two-corners-16-stiff", "two-corners-32-stiff", "ball-32-stiff", "upright-32"];

/// All named scenes.
pub fn named() -> Vec<BuiltIn> {
    GOALS.iter().chain(ORDERS).chain(BUILT_IN).copied().collect()
}

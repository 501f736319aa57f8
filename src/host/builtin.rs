//! The scenes that need no file.

/// A scene of the crate.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// What it is called on the command line.
    pub name: &'static str,
    /// Its scene file.
    pub text: &'static str,
}

macro_rules! built_in {
    ($($name:literal)*) => {
        /// Every built-in scene.
        pub const BUILT_IN: &[BuiltIn] = &[$(
            BuiltIn { name: $name, text: include_str!(concat!("../../examples/scenes/", $name, ".toml")) }
        ),*];
    };
}
built_in! { "gravity" "sphere" "wind" "no-shear" "flag" "curtain" "drape" "heap" "fold" }

/// The scene that runs where none is named.
pub const DEFAULT_SCENE: &str = "drape";

/// The built-in scene called `name`.
pub fn built_in(name: &str) -> Option<BuiltIn> {
    BUILT_IN.iter().copied().find(|scene| scene.name == name)
}

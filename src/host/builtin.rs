//! The built-in scenes, which need no file.

/// A built-in scene.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// Its name on the command line.
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

/// The scene that runs if none is named.
pub const DEFAULT_SCENE: &str = "drape";

/// The built-in scene called `name`.
pub fn built_in(name: &str) -> Option<BuiltIn> {
    BUILT_IN.iter().copied().find(|scene| scene.name == name)
}

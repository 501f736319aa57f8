//! Scenes read from files, for programs on a host (cargo feature `std`).
//!
//! [`Description::parse`] turns the text of a scene file into plain SI numbers, or into the one line that says which
//! key is wrong and why. [`BUILT_IN`] holds the scenes that need no file.

mod build;
mod builtin;
mod description;
mod error;
mod file;
mod fit;
#[cfg(feature = "graphics")]
mod painter;
mod quantity;
mod resolve;
mod run;
mod shape;
mod solver;

pub use builtin::{BUILT_IN, BuiltIn, DEFAULT_SCENE, built_in};
pub use description::{
    Capsule, Description, Drag, Picture, Plane, Pose, Sheet, Solver, SolverKind, Sphere, Spring, Surface, Weave, Wind,
    WindModel,
};
pub use error::SceneError;
#[cfg(feature = "graphics")]
pub use painter::Painter;
pub use quantity::MOST;
pub use run::{ScalarKind, Simulation, State, Still, Strain, Strains};
pub use shape::SHAPES;

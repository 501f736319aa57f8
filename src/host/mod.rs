//! Scenes read from files and run in a number type, on a grid and by a solver chosen at run time, for programs on a host (cargo feature
//! `std`).
//!
//! [`Description::parse`] turns the text of a scene file into plain SI numbers, or into the one line that says which key is wrong and why;
//! [`Description::simulation_on`] sets it in motion; [`simulations!`](crate::simulations) chooses number type and grid while the program runs; [`Painter`] draws it.
//! [`BUILT_IN`] holds the scenes that need no file.
//!
//! ```
//! use kerchief::Q24;
//! use kerchief::host::{Description, Everything, built_in};
//!
//! let scene = Description::parse(built_in("gravity").unwrap().text)?;
//! let mut simulation = scene.simulation_on::<Everything, Q24, 32, 32>()?;
//! for _ in 0..10 {
//!     simulation.frame();
//! }
//! assert!(simulation.strains().stretch.unwrap().largest < 1.0);
//! # Ok::<(), kerchief::host::SceneError>(())
//! ```
//!
//! [The scene file](crate::guide::scene_file) has every key with its unit, range and default.

mod build;
mod builtin;
mod choice;
mod counted;
mod description;
mod error;
mod file;
mod fit;
mod grip;
mod instances;
mod obstacles;
#[cfg(feature = "graphics")]
mod painter;
mod parts;
mod quantity;
mod range;
mod resolve;
mod run;
mod shape;
mod solver;

pub use builtin::{BUILT_IN, BuiltIn, DEFAULT_SCENE, built_in};
pub use choice::{Pose, SolverKind, Weave};
pub use counted::{Counted, Operations};
pub use description::{
    Capsule, Description, Drag, Picture, Plane, Sheet, Solver, Sphere, Spring, Surface, Wind, WindModel,
};
pub use error::{SceneError, printable};
pub use grip::Grip;
pub use obstacles::Obstacles;
#[cfg(feature = "graphics")]
pub use painter::{Bounds, Painter};
pub use parts::{Bare, Everything, Parts, Springs};
pub use quantity::MOST;
pub use run::{Explosion, ScalarKind, Simulation, State, Still, Strain, Strains};
pub use shape::SHAPES;

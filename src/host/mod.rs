//! Scenes read from files, with number type, grid and solver chosen at run time, for programs on a host (cargo feature `std`).
//!
//! [`Description::parse`] turns the text of a scene file into plain SI numbers, or into an error of one line that names the wrong key and the reason.
//! [`Description::simulation_on`] makes a simulation of it; [`simulations!`](crate::simulations) chooses number type and grid at run time; [`Painter`] draws it.
//! [`BUILT_IN`] lists the scenes that need no file.
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
//! [The scene file](crate::guide::scene_file) documents every key with its unit, range and default.

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

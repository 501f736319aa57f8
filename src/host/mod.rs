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
//! # The file
//!
//! TOML, SI units, z up. What is left out is off; a default is in brackets. Every number is finite. A file has at most 262 144 values and, in programs, 16 MB.
//!
//! | table | key | meaning |
//! |---|---|---|
//! | | `name` | \[the file's name\] |
//! | `[cloth]` | `columns`, `rows` | particles: one of [`SHAPES`]; a sheet of one column is a chain |
//! | | `width`, `height` | m, > 0; the width of a chain, which has none, is ignored |
//! | | `mass` or `density` | kg per particle, or kg/m² of which each particle gets its share of the cells around it; > 0 |
//! | | `hem` | factor of border particles' mass, > 0 \[1\] |
//! | | `pose` | `"lay"` flat in the x-y plane, or `"hang"` upright in the x-z plane, row 0 on top \[`"lay"`\] |
//! | | `origin` | where particle (0, 0) starts, m \[0, 0, 0\] |
//! | | `pins` | a list of `[column, row]`, or `"top"`, `"left"`, `"corners"`, `"top-corners"` |
//! | `[stretch]`, `[shear]`, `[bend]` | `stiffness` or `compliance` | N/m, ≥ 0, or m/N, > 0 |
//! | | `damping` | N·s/m, ≥ 0 \[0\] |
//! | `[tether]` | `slack` | no particle further from a pin than 1 + slack times its distance at rest, ≥ 0 \[0\] |
//! | `[environment]` | `gravity` | m/s² |
//! | | `drag` or `verlet_damping` | γ in 1/s, or the share of its displacement that a sheet loses in a step, `0 <= x < 1` |
//! | | `wind.velocity` | m/s |
//! | | `wind.model` | `"facet"`, `"aerodynamic"` or `"panel"`: see [`WindModel`] |
//! | | `wind.density`, `wind.drag_coefficient` | of the air, not for facets: kg/m³ \[1.2\], no unit \[1.2\] |
//! | `[[sphere]]` | `centre`, `radius`, `velocity` | m, m > 0, m/s \[0, 0, 0\] |
//! | `[[plane]]` | `point`, `normal` | m; outwards, any length |
//! | `[[capsule]]` | `a`, `b`, `radius` | ends of the axis and radius, m |
//! | all three | `margin`, `friction` | distance that particles keep, m ≥ 0 \[0\]; Coulomb's coefficient, ≥ 0 \[0\] |
//! | `[solver]` | `kind` | a [`SolverKind`] \[`"lines"`\] |
//! | | `step` | a frame, s > 0 \[1/60\] |
//! | | `substeps` | solver steps in a frame \[8\] |
//! | | `iterations` | sweeps of Verlet, pairs of sweeps of lines, Newton steps of backward Euler in a substep \[1\] |
//! | | `sweeps` | sweeps of lines in a substep \[2 · `iterations`\] |
//! | | `tolerance` | strain of a row for which lines spend further sweeps, > 0 \[0.02\] |
//! | | `strain_limit` | no link longer than 1 + limit times its rest length, > 0 |
//! | `[self]` | `thickness` | the sheet meets itself: how far it keeps from itself, m, 0.75 to 1 of a cell's longer side \[1 of it\] |
//! | | `friction` | Coulomb's coefficient on itself, ≥ 0 \[0\] |
//! | `[rest]` | `speed`, `acceleration`, `time` | a sheet that is as still as this is not computed: see [`Stillness`](crate::rest::Stillness); m/s, m/s², s > 0 \[0.001, 0.001, 0.5\] |
//! | `[run]` | `frames` | \[100\] |
//! | `[picture]` | `azimuth`, `elevation` | from where it is looked at, degrees \[30, 20\] |
//! | | `low`, `high` | corners of the box that fills the picture, m \[all that is seen\] |
//! | | `pattern` | `"plain"`, `"stripes"`, `"checks"`, `"gingham"` or `"kerchief"` \[`"plain"`\] |
//! | | `bands` | of the pattern along the longer side \[15\] |
//! | | `colours` | two, `"#rrggbb"`; a plain sheet has the second |

mod build;
mod builtin;
mod choice;
mod counted;
mod description;
mod error;
mod file;
mod fit;
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
pub use obstacles::Obstacles;
#[cfg(feature = "graphics")]
pub use painter::{Bounds, Painter};
pub use parts::{Bare, Everything, Parts, Springs};
pub use quantity::MOST;
pub use run::{Explosion, ScalarKind, Simulation, State, Still, Strain, Strains};
pub use shape::SHAPES;

//! Cloth that runs on a microcontroller: a sheet of particles held together by springs, without an allocator and, where the chip
//! has no floating point, without a float.
//!
//! The state ([`Cloth`]) is in RAM and its size is known at compile time. The description ([`Scene`]) lists the forces, links and colliders as tuples: `()` is
//! none. A part that a scene doesn't name costs neither a byte nor an instruction. The number type and the solver are type parameters.
//!
//! ```
//! use kerchief::*;
//!
//! const SHEET: Sheet<Q24, 16, 16> = Sheet::new([0.3, 0.3], 1e-4, 1.0 / 60.0, 8); // m, kg of a particle, s, substeps
//!
//! let mut cloth = SHEET.hang([0.0, 0.0, 0.3]);
//! cloth.pin(Node::new(0, 0));
//! cloth.pin(Node::new(15, 0));
//! let gravity = SHEET.gravity([0.0, 0.0, -9.81]);
//! let links = (SHEET.stretch(100.0), SHEET.shear(1.0));
//! let scene = SHEET.scene(gravity, links, (), Lines::new());
//! let mut memory = scene.memory();
//! for _frame in 0..60 {
//!     scene.step(&mut cloth, &mut memory);
//! }
//! assert!(measure::strain(&cloth, &scene.links.0).largest.to_f64() < 0.02);
//! ```
//!
//! `examples/hello.rs` draws this sheet in a terminal, `examples/draw.rs` draws a denim sheet as a picture. On a host, [scene files](guide::scene_file)
//! describe sheets without a line of Rust (feature `std`). [The guide](guide) has short pages on sizes, solvers, wind, colliders, drawing, boards and common
//! problems.
//!
//! To change the number type, change the name in `Sheet<Q24, …>`. To change the solver, change the last argument of `scene`. A wind is one more member of a
//! tuple of forces.
//!
//! # Reading order
//!
//! Each module uses only those above it.
//!
//! | module or type | contents |
//! |---|---|
//! | [`scalar`] | numbers: `f32`, `f64`, fixed point |
//! | [`Vec3`], [`Grid`], [`Vectors`] | vectors, and numbers and vectors on a grid |
//! | [`units`] | cells, ticks and particle masses; conversion from and to SI |
//! | [`Moment`] | the position of a substep in its frame |
//! | [`fingerprint`] | a hash that shows whether numbers have changed |
//! | [`Particles`] | the particles that forces, links, colliders and solvers act on |
//! | [`Cloth`] | the state of a sheet |
//! | `saved` | saving and restoring it (feature `serde`) |
//! | [`force`], [`link`], [`collider`] | the physics that acts on it |
//! | [`solver`] | the solvers that move it |
//! | [`self_contact`] | contact of a sheet with itself |
//! | [`rest`] | sheets at rest, which are not computed |
//! | [`scene`] | the description, and the step |
//! | [`Sheet`] | size, number type and units in one constant; the usual entry point |
//! | [`measure`] | strain, energy, momentum, digest |
//! | [`mesh`] | positions, normals and triangles for a graphics engine |
//! | [`Ray`] | the particle under a pixel |
//! | `render` | drawing on any `embedded-graphics` display (feature `graphics`) |
//! | [`host`] | scene files, for programs on a host (feature `std`) |
//!
//! # Guarantees
//!
//! A step cannot fail: invalid parameters are rejected when a scene is built, by the compiler in constants and with a panic elsewhere. The same scene gives the
//! same bits on every target, for every number type: floats use only `+ − × ÷` and the square root, each rounded once, fixed point only integer arithmetic, and
//! the order of operations is fixed. There is no unsafe code.
#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "std")]
extern crate std;

#[cfg(all(target_os = "none", feature = "std"))]
compile_error!("the feature `std` is for programs on a host: build firmware without it");

mod cloth;
pub mod collider;
pub mod fingerprint;
pub mod force;
mod grid;
// documentation only: it contains no items
#[cfg(doc)]
pub mod guide;
#[cfg(feature = "std")]
pub mod host;
pub mod link;
pub mod material;
pub mod measure;
pub mod mesh;
mod moment;
mod particles;
mod ray;
#[cfg(feature = "graphics")]
pub mod render;
pub mod rest;
#[cfg(feature = "serde")]
pub mod saved;
pub mod scalar;
pub mod scene;
pub mod self_contact;
mod sheet;
pub mod solver;
pub mod units;
mod vec3;
mod vectors;

pub use cloth::Cloth;
pub use collider::{Capsule, Collider, Moving, Plane, Sphere};
pub use force::{AerodynamicWind, Drag, FacetWind, Force, Gravity, Hand, PanelWind};
pub use grid::{Grid, Node};
pub use link::{Bend, Damped, Links, Shear, StrainLimited, Stretch, Tether};
pub use material::Material;
pub use mesh::Mesh;
pub use moment::Moment;
pub use particles::Particles;
pub use ray::{Hit, Ray};
pub use rest::{Resting, Stillness};
pub use scalar::{Fixed24, Q13, Q24, Scalar};
pub use scene::Scene;
pub use self_contact::SelfContact;
pub use sheet::Sheet;
pub use solver::{BackwardEuler, ForwardEuler, Leapfrog, Lines, LinesMemory, Solver, Verlet, Xpbd};
pub use units::{Point, Units};
pub use vec3::Vec3;
pub use vectors::Vectors;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

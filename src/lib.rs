//! Cloth that runs on a microcontroller: a sheet of particles held together by springs, without an allocator and, where the chip
//! has no floating point, without a float.
//!
//! The state ([`Cloth`]) is in RAM and its size is known when it is compiled. The description ([`Scene`]) says what acts on it, as
//! tuples: `()` is nothing, and what a scene doesn't name costs neither a byte nor an instruction. The number type is a type
//! parameter, and so is the solver.
//!
//! ```
//! use kerchief::*;
//!
//! const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-4, 1.0 / 60.0, 8); // particles, m, kg, s, substeps
//!
//! let mut cloth = Cloth::<Q24, 16, 16>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
//! cloth.pin(Node::new(0, 0));
//! cloth.pin(Node::new(15, 0));
//! let gravity = Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81]));
//! let links = (Stretch::new(&UNITS, UNITS.stiffness(100.0)), Shear::new(&UNITS, UNITS.stiffness(1.0)));
//! let scene = Scene::new(&UNITS, gravity, links, (), Lines::new());
//! let mut memory = scene.memory();
//! for _frame in 0..60 {
//!     scene.step(&mut cloth, &mut memory);
//! }
//! assert!(measure::strain(&cloth, &scene.links.0).largest.to_f64() < 0.02);
//! ```
//!
//! `examples/hello.rs` draws this sheet in a terminal, `examples/draw.rs` a denim one as a picture. On a host [scene files](host#the-file) describe sheets without a
//! line of Rust (feature `std`).
//!
//! Another number type is another name in `Cloth::<Q24, …>`; another solver is another last argument; a wind is one more member of a tuple.
//!
//! # In which order to read
//!
//! Each room uses only those above it.
//!
//! | room | what it holds |
//! |---|---|
//! | [`scalar`] | numbers: `f32`, `f64`, fixed point |
//! | [`vec3`], [`grid`], [`vectors`] | vectors, and numbers and vectors on a grid |
//! | [`units`] | cells, ticks and particle masses; the way in from SI |
//! | [`moment`] | where in a frame a solver is |
//! | [`fingerprint`] | whether numbers have changed |
//! | [`particles`] | what forces, links, colliders and solvers act on |
//! | [`cloth`] | the state of a sheet |
//! | [`force`], [`link`], [`collider`] | what acts on it |
//! | [`solver`] | the ways to move it |
//! | [`rest`] | when nothing moves, nothing is computed |
//! | [`scene`] | the description, and the step |
//! | [`measure`] | strain, energy, momentum, digest |
//! | `render` | drawing on any `embedded-graphics` display (feature `graphics`) |
//! | [`host`] | scene files, for programs on a host (feature `std`) |
//!
//! # Guarantees
//!
//! A step cannot fail: what makes no sense is refused where a scene is put together, by the compiler in constants and with a panic elsewhere. The same scene
//! gives the same bits on every target, for every number type: only `+ − × ÷` and the square root are used, each rounded once, in one order. There is no unsafe code.
#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "std")]
extern crate std;

#[cfg(all(target_os = "none", feature = "std"))]
compile_error!("the feature `std` is for programs on a host: build firmware without it");

pub mod cloth;
pub mod collider;
pub mod fingerprint;
pub mod force;
pub mod grid;
#[cfg(feature = "std")]
pub mod host;
pub mod link;
pub mod material;
pub mod measure;
pub mod moment;
pub mod particles;
#[cfg(feature = "graphics")]
pub mod render;
pub mod rest;
pub mod scalar;
pub mod scene;
pub mod solver;
pub mod units;
pub mod vec3;
pub mod vectors;

pub use cloth::Cloth;
pub use collider::{Capsule, Collider, Plane, Sphere};
pub use force::{AerodynamicWind, Drag, FacetWind, Force, Gravity};
pub use grid::{Grid, Node};
pub use link::{Bend, Damped, Links, Shear, StrainLimited, Stretch, Tether};
pub use material::Material;
pub use moment::Moment;
pub use particles::Particles;
pub use rest::{Resting, Stillness};
pub use scalar::{Fixed24, Q13, Q24, Scalar};
pub use scene::Scene;
pub use solver::{BackwardEuler, ForwardEuler, Leapfrog, Lines, LinesMemory, Solver, Verlet, Xpbd};
pub use units::{Point, Units};
pub use vec3::Vec3;
pub use vectors::Vectors;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

//! Cloth that runs on a microcontroller.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

#[cfg(all(target_os = "none", feature = "std"))]
compile_error!("the features `std` and `window` are for programs on a host: build firmware without them");

pub mod cloth;
pub mod collider;
pub mod force;
pub mod grid;
#[cfg(feature = "std")]
pub mod host;
pub mod link;
pub mod measure;
pub mod moment;
#[cfg(feature = "graphics")]
pub mod render;
pub mod scalar;
pub mod scene;
pub mod solver;
pub mod units;
pub mod vec3;

pub use cloth::Cloth;
pub use collider::{Capsule, Collider, Plane, Sphere};
pub use force::{AerodynamicWind, Drag, FacetWind, Force, Gravity};
pub use grid::{Grid, Node};
pub use link::{Bend, Damped, Links, Shear, StrainLimited, Stretch, Tether};
pub use moment::Moment;
pub use scalar::{Q24, Scalar};
pub use scene::Scene;
pub use solver::{BackwardEuler, ForwardEuler, Leapfrog, Lines, Solver, Verlet, Xpbd};
pub use units::{Point, Units};
pub use vec3::Vec3;

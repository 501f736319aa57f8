//! An independent solution of the sheet's equation of motion, in f64 and SI units, to hold every solver against.
//!
//! Nothing here uses the crate: the model is written down a second time, from its definition alone, as lists
//! instead of patterns and as one ordinary differential equation instead of a solver. Colliders and the strain
//! limit are no part of that equation.
//!
//! [`Model`] says what is meant, [`Ode`] is its right-hand side, [`Ode::solve`] its converged solution, and
//! [`closed_forms`] holds the cases that mathematics solves.

pub mod closed_forms;
mod ode;
mod rk4;
mod sheet;
pub mod vector;

pub use ode::{Ode, State};
pub use rk4::{Solution, rms_distance};
pub use sheet::{Pose, Sheet};
pub use vector::Vector;

/// Neighbours along rows and columns, as (column, row).
pub const STRETCH: &[(i32, i32)] = &[(1, 0), (0, 1)];
/// Both diagonals of a cell.
pub const SHEAR: &[(i32, i32)] = &[(1, 1), (1, -1)];
/// Neighbours but one along rows and columns.
pub const BEND: &[(i32, i32)] = &[(2, 0), (0, 2)];

/// All links of the same offsets; the rest length of each is its length at the start.
#[derive(Clone, Debug)]
pub struct Family {
    pub offsets: &'static [(i32, i32)],
    /// Spring constant k, N/m.
    pub stiffness: f64,
    /// Factor of the relative velocity, `N·s/m`.
    pub damping: f64,
}

impl Family {
    /// Links without damping.
    pub fn new(offsets: &'static [(i32, i32)], stiffness: f64) -> Self {
        Self { offsets, stiffness, damping: 0.0 }
    }

    #[must_use]
    pub fn damped(self, damping: f64) -> Self {
        Self { damping, ..self }
    }
}

#[derive(Clone, Debug)]
pub enum Wind {
    /// Force n·(n/|n| · wind) on each corner of a triangle with edge product n.
    Facet(Vector),
    /// Quadratic drag along the normal, relative to the triangle's own velocity, a third of it on each corner.
    Aerodynamic { velocity: Vector, density: f64, drag_coefficient: f64 },
    /// The same for cells, whose area and normal are half the product of their diagonals, a quarter of it on each corner.
    Panel { velocity: Vector, density: f64, drag_coefficient: f64 },
}

/// Everything that decides how the sheet moves.
#[derive(Clone, Debug)]
pub struct Model {
    pub sheet: Sheet,
    pub families: Vec<Family>,
    /// m/s².
    pub gravity: Vector,
    /// γ, 1/s.
    pub drag: f64,
    pub wind: Option<Wind>,
}

impl Model {
    /// Only the sheet: nothing links it and nothing acts on it.
    pub fn new(sheet: Sheet) -> Self {
        Self { sheet, families: Vec::new(), gravity: [0.0; 3], drag: 0.0, wind: None }
    }

    /// The sheet at rest in its pose.
    pub fn start(&self) -> State {
        let position = self.sheet.positions();
        State { velocity: vec![[0.0; 3]; position.len()], position }
    }

    pub fn ode(&self) -> Ode {
        Ode::new(self)
    }

    /// [`Ode::solve`] from the start.
    pub fn solve(&self, times: &[f64], tolerance: f64) -> Solution {
        self.ode().solve(&self.start(), times, tolerance)
    }
}

/// The drag γ that a position Verlet step with displacement factor `1 - damping` stands for, 1/s.
pub fn drag_of_verlet_damping(damping: f64, step: f64) -> f64 {
    -(1.0 - damping).ln() / step
}

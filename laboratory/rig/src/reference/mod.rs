//! An independent solution of the sheet's equation of motion, in f64 and SI units, with which every solver is compared.
//!
//! No code here uses the crate. The model is implemented a second time from its definition: lists replace the
//! crate's patterns, and one ordinary differential equation replaces a solver. Colliders and the strain
//! limit are not part of that equation.
//!
//! [`Model`] describes the sheet, [`Ode`] is the right-hand side of its equation, and [`Ode::solve`] gives the
//! converged solution. [`closed_forms`] has cases with an exact solution.

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
/// Second neighbours along rows and columns.
pub const BEND: &[(i32, i32)] = &[(2, 0), (0, 2)];

/// All links of the same offsets. The rest length of a link is its length at the start.
#[derive(Clone, Debug)]
pub struct Family {
    pub offsets: &'static [(i32, i32)],
    /// Spring constant k, N/m.
    pub stiffness: f64,
    /// Damping coefficient: force per relative velocity of the ends, `N·s/m`.
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
    /// Quadratic drag along a triangle's normal, from the wind relative to the triangle's velocity; a third of it on each corner.
    Aerodynamic { velocity: Vector, density: f64, drag_coefficient: f64 },
    /// The same for cells: half the cross product of the diagonals gives area and normal; a quarter of the drag on each corner.
    Panel { velocity: Vector, density: f64, drag_coefficient: f64 },
}

/// A sheet with everything that acts on it.
#[derive(Clone, Debug)]
pub struct Model {
    pub sheet: Sheet,
    pub families: Vec<Family>,
    /// Gravitational acceleration, m/s².
    pub gravity: Vector,
    /// Drag γ, 1/s.
    pub drag: f64,
    pub wind: Option<Wind>,
}

impl Model {
    /// The sheet alone, without links and forces.
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

/// The drag γ that is equivalent to the displacement factor `1 - damping` of a position Verlet step, 1/s.
pub fn drag_of_verlet_damping(damping: f64, step: f64) -> f64 {
    -(1.0 - damping).ln() / step
}

//! A complete scene: plain SI numbers in `f64`, checked, with all defaults filled in.

use std::string::String;
use std::vec::Vec;

use super::choice::{Pose, SolverKind, Weave};
use super::error::SceneError;
use super::file::File;
use crate::rest::Stillness;

/// A scene with all defaults filled in, before a number type and a grid are chosen.
#[derive(Clone, Debug)]
pub struct Description {
    /// The file's `name`; empty where it has none.
    pub name: String,
    /// The sheet.
    pub sheet: Sheet,
    /// Links to the next particle of the row and of the column.
    pub stretch: Option<Spring>,
    /// Links along both diagonals of every cell.
    pub shear: Option<Spring>,
    /// Links to the particle after the next of the row and of the column.
    pub bend: Option<Spring>,
    /// The distance by which a particle may exceed its rest distance from a pin, as a fraction of that distance.
    pub tether_slack: Option<f64>,
    /// Acceleration of gravity, m/s².
    pub gravity: [f64; 3],
    /// Damping of the whole sheet.
    pub drag: Option<Drag>,
    /// Moving air.
    pub wind: Option<Wind>,
    /// Balls.
    pub spheres: Vec<Sphere>,
    /// Half spaces.
    pub planes: Vec<Plane>,
    /// Rods with round ends.
    pub capsules: Vec<Capsule>,
    /// The solver and its parameters.
    pub solver: Solver,
    /// Contact of the sheet with itself.
    pub self_contact: Option<SelfContact>,
    /// The thresholds of motion below which the sheet rests and is not computed.
    pub rest: Option<Stillness>,
    /// Number of frames of [`Solver::step`] each.
    pub frames: u32,
    /// Parameters of pictures.
    pub picture: Picture,
}

impl Description {
    /// Reads the text of a scene file.
    ///
    /// # Errors
    ///
    /// The first error found, with its key: see [`SceneError`].
    ///
    /// ```
    /// use kerchief::host::Description;
    ///
    /// let scene = "[cloth]\ncolumns = 8\nrows = 8\nwidth = 1.0\nheight = 1.0\nmass = 0.0\n";
    /// let error = Description::parse(scene).unwrap_err();
    /// assert_eq!(error.to_string(), "cloth.mass: must be above zero, is 0");
    /// ```
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        File::parse(text)?.resolve()
    }
}

/// Contact of a sheet with itself.
#[derive(Clone, Copy, Debug)]
pub struct SelfContact {
    /// The distance that particles which are not neighbours keep from each other, m. `None` stands for a cell's longer side.
    pub thickness: Option<f64>,
    /// Coulomb's coefficient of friction.
    pub friction: f64,
}

/// The sheet at the start.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Particles in a row.
    pub columns: usize,
    /// Particles in a column.
    pub rows: usize,
    /// Distance between the first and the last column, m; 0 for a chain.
    pub width: f64,
    /// Distance between the first and the last row, m.
    pub height: f64,
    /// The initial pose.
    pub pose: Pose,
    /// The initial position of particle (0, 0), m.
    pub origin: [f64; 3],
    /// Mass of a particle with inverse mass 1, kg.
    pub mass: f64,
    /// Which key gave [`mass`](Self::mass): `mass` or `density`. With a density, masses follow the area around particles: a particle
    /// on an edge has half of `mass`, a particle in a corner a quarter.
    pub mass_key: &'static str,
    /// The factor by which border particles are heavier.
    pub hem: Option<f64>,
    /// Particles pinned at their initial positions, `[column, row]`, each once.
    pub pins: Vec<[usize; 2]>,
}

impl Sheet {
    /// Whether masses follow the area around each particle.
    pub fn shares_area(&self) -> bool {
        self.mass_key == "density"
    }

    /// The mass of a particle, kg.
    pub fn mass_at(&self, column: usize, row: usize) -> f64 {
        let edges = [(column, self.columns), (row, self.rows)].map(|(index, count)| index == 0 || index == count - 1);
        let share = |on_edge| if on_edge && self.shares_area() { 0.5 } else { 1.0 };
        let hem = self.hem.filter(|_| edges.contains(&true)).unwrap_or(1.0);
        self.mass * share(edges[0]) * share(edges[1]) * hem
    }
}

/// The force of a link family, `f = -k (|d| - L) d/|d| - k_d (v_i - v_j)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// k, N/m.
    pub stiffness: f64,
    /// Which key gave [`stiffness`](Self::stiffness): `stiffness` or `compliance` (= 1/k, m/N).
    pub key: &'static str,
    /// `k_d`, N·s/m.
    pub damping: f64,
}

/// Damping of the whole sheet, `-m γ v` on a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// γ, 1/s.
    pub rate: f64,
    /// Which key gave it: `drag` or `verlet_damping`.
    pub key: &'static str,
}

/// Moving air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wind {
    /// Velocity of the air, m/s.
    pub velocity: [f64; 3],
    /// The force on a cell.
    pub model: WindModel,
}

/// The force of moving air on a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindModel {
    /// `n (n/|n| · wind)` on each corner of a triangle, with `|n|` twice its area; the sheet's own motion is ignored.
    Facet,
    /// The pressure of the relative wind, `½ ρ c A (n·u) |n·u| n`, a third on each corner.
    Aerodynamic {
        /// ρ, density of the air, kg/m³.
        density: f64,
        /// c, dimensionless.
        drag_coefficient: f64,
    },
    /// The same pressure on each cell as one panel, a quarter on each corner: see [`PanelWind`](crate::PanelWind).
    Panel {
        /// ρ, density of the air, kg/m³.
        density: f64,
        /// c, dimensionless.
        drag_coefficient: f64,
    },
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its initial centre, m.
    pub centre: [f64; 3],
    /// Its radius, m.
    pub radius: f64,
    /// Its velocity, m/s.
    pub velocity: [f64; 3],
    /// The properties of its surface.
    pub surface: Surface,
}

/// A half space that particles do not enter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of its surface, m.
    pub point: [f64; 3],
    /// The outward normal, of length 1.
    pub normal: [f64; 3],
    /// The properties of its surface.
    pub surface: Surface,
}

/// A rod with round ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    /// One end of its axis, m.
    pub a: [f64; 3],
    /// The other end, m.
    pub b: [f64; 3],
    /// Its radius, m.
    pub radius: f64,
    /// The properties of its surface.
    pub surface: Surface,
}

/// The contact properties of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Distance that particles keep from it, m.
    pub margin: f64,
    /// Coulomb's coefficient of friction, dimensionless.
    pub friction: f64,
}

/// Parameters of pictures of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picture {
    /// The camera's azimuth, degrees: at 0 it looks along y, at 90 it stands on the side of positive x.
    pub azimuth: f64,
    /// The camera's elevation, degrees.
    pub elevation: f64,
    /// The box that fills the picture, m. `None` stands for the box around everything visible.
    pub frame: Option<[[f64; 3]; 2]>,
    /// The pattern of the sheet.
    pub pattern: Weave,
    /// Bands of the pattern along the longer side of the sheet.
    pub bands: u32,
    /// Colours of the pattern: red, green, blue.
    pub colours: [[u8; 3]; 2],
}

/// The solver and its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solver {
    /// The method.
    pub kind: SolverKind,
    /// Duration of a frame, s.
    pub step: f64,
    /// Solver steps per frame.
    pub substeps: u32,
    /// Per substep: relaxation sweeps of position Verlet, pairs of sweeps of the line solver, or Newton steps of backward Euler. Other methods ignore it.
    pub iterations: u32,
    /// Sweeps of the line solver per substep, in place of `iterations`. Other methods ignore it.
    pub sweeps: Option<u32>,
    /// The strain of a row above which the line solver makes further sweeps. Other methods ignore it.
    pub tolerance: f64,
    /// No link is longer than `1 + strain_limit` times its rest length after a step.
    pub strain_limit: Option<f64>,
}

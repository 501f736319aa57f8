//! A scene with everything said: plain SI numbers in `f64`, checked, no key left to look up.

use std::string::String;
use std::vec::Vec;

use super::choice::{Pose, SolverKind, Weave};
use super::error::SceneError;
use super::file::File;
use crate::rest::Stillness;

/// A scene as its file means it, before a number type and a grid are chosen.
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
    /// How much further from a pin than its rest distance a particle may go, as a share of that distance.
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
    /// How the sheet is moved.
    pub solver: Solver,
    /// How the sheet meets itself.
    pub self_contact: Option<SelfContact>,
    /// How still the sheet has to be for nothing to be computed.
    pub rest: Option<Stillness>,
    /// Number of frames of [`Solver::step`] each.
    pub frames: u32,
    /// How pictures show it.
    pub picture: Picture,
}

impl Description {
    /// Reads the text of a scene file.
    ///
    /// # Errors
    ///
    /// The first thing found wrong, with its key: see [`SceneError`].
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

/// A sheet that meets itself.
#[derive(Clone, Copy, Debug)]
pub struct SelfContact {
    /// How far particles that are no neighbours keep apart, m; a cell's longer side where a file does not say.
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
    /// How it starts.
    pub pose: Pose,
    /// Where particle (0, 0) starts, m.
    pub origin: [f64; 3],
    /// Mass of an ordinary particle, kg.
    pub mass: f64,
    /// Which key gave [`mass`](Self::mass): `mass` or `density`. From a density, a particle on an edge has the area and so
    /// the mass of half an ordinary one, a particle in a corner of a quarter.
    pub mass_key: &'static str,
    /// By how much border particles are heavier.
    pub hem: Option<f64>,
    /// Particles held where they start, `[column, row]`, each once.
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

/// The law of a link family, `f = -k (|d| - L) d/|d| - k_d (v_i - v_j)`.
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
    /// How it pushes a cell.
    pub model: WindModel,
}

/// How moving air pushes a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindModel {
    /// `n (n/|n| · wind)` on each corner, `n` twice the triangle's area; the sheet's own motion does not count.
    Facet,
    /// The pressure of the relative wind, `½ ρ c A (n·u) |n·u| n`, a third on each corner.
    Aerodynamic {
        /// ρ, density of the air, kg/m³.
        density: f64,
        /// c, no unit.
        drag_coefficient: f64,
    },
    /// The same on each cell as one panel, a quarter on each corner: see [`PanelWind`](crate::PanelWind).
    Panel {
        /// ρ, density of the air, kg/m³.
        density: f64,
        /// c, no unit.
        drag_coefficient: f64,
    },
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Where it starts, m.
    pub centre: [f64; 3],
    /// m.
    pub radius: f64,
    /// Its own motion, m/s.
    pub velocity: [f64; 3],
    /// What its surface does to a particle.
    pub surface: Surface,
}

/// A half space that nothing enters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of its surface, m.
    pub point: [f64; 3],
    /// Outwards, of length 1.
    pub normal: [f64; 3],
    /// What its surface does to a particle.
    pub surface: Surface,
}

/// A rod with round ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    /// One end of its axis, m.
    pub a: [f64; 3],
    /// The other end, m.
    pub b: [f64; 3],
    /// m.
    pub radius: f64,
    /// What its surface does to a particle.
    pub surface: Surface,
}

/// What a surface does to a particle that comes near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Distance that particles keep, m.
    pub margin: f64,
    /// Coulomb's coefficient, no unit.
    pub friction: f64,
}

/// How pictures show a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picture {
    /// From where it is looked at, degrees: 0 looks along y, 90 stands on the side of positive x.
    pub azimuth: f64,
    /// The same, upwards, degrees.
    pub elevation: f64,
    /// The box that fills the picture, m; where there is none, the box around all that is seen.
    pub frame: Option<[[f64; 3]; 2]>,
    /// What is woven into the sheet.
    pub pattern: Weave,
    /// Bands of the pattern along the longer side of the sheet.
    pub bands: u32,
    /// Colours of the pattern: red, green, blue.
    pub colours: [[u8; 3]; 2],
}

/// How the sheet is moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solver {
    /// The method.
    pub kind: SolverKind,
    /// Duration of a frame, s.
    pub step: f64,
    /// Solver steps per frame.
    pub substeps: u32,
    /// Per substep, relaxation sweeps of position Verlet, pairs of sweeps of lines and Newton steps of backward Euler; the others have none.
    pub iterations: u32,
    /// Sweeps of lines per substep, in place of `iterations`; the others have none.
    pub sweeps: Option<u32>,
    /// The strain of a row for which lines spend further sweeps; the others have none.
    pub tolerance: f64,
    /// No link longer than `1 + strain_limit` times its rest length after a step.
    pub strain_limit: Option<f64>,
}

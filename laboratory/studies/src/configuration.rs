//! Configurations: solver, number type and settings for a scene.

use std::fmt;

use kerchief::host::{Description, ScalarKind, SolverKind};

/// A solver with its settings and number type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Configuration {
    pub solver: SolverKind,
    pub scalar: ScalarKind,
    /// Solver steps per frame.
    pub substeps: u32,
    /// Relaxation sweeps (Newton steps of backward Euler) per substep; 1 for solvers without sweeps.
    pub sweeps: u32,
    /// The strain above which the line solver sweeps again; `None` takes the scene's value.
    pub tolerance: Option<f64>,
}

impl Configuration {
    /// The scene with this configuration.
    pub fn of(self, scene: &Description) -> Description {
        let mut scene = scene.clone();
        (scene.solver.kind, scene.solver.substeps, scene.solver.iterations) = (self.solver, self.substeps, self.sweeps);
        scene.solver.sweeps = Some(self.sweeps);
        scene.solver.tolerance = self.tolerance.unwrap_or(scene.solver.tolerance);
        scene
    }

    /// The configuration as words of a command line.
    pub fn words(self) -> Vec<String> {
        let Self { solver, scalar, substeps, sweeps, tolerance } = self;
        let words = [solver.name().to_string(), scalar.name().to_string(), substeps.to_string(), sweeps.to_string()];
        words.into_iter().chain(tolerance.map(|tolerance| tolerance.to_string())).collect()
    }

    /// Parses the output of [`words`](Self::words).
    pub fn from_words(words: &[String]) -> Option<Self> {
        let [solver, scalar, substeps, sweeps, tolerance @ ..] = words else { return None };
        Some(Self {
            solver: SolverKind::from_name(solver)?,
            scalar: ScalarKind::from_name(scalar)?,
            substeps: substeps.parse().ok()?,
            sweeps: sweeps.parse().ok()?,
            tolerance: tolerance.first().map(|tolerance| tolerance.parse()).transpose().ok()?,
        })
    }

    /// The solver and number type.
    pub fn kind(self) -> String {
        format!("{} {}", self.solver.name(), self.scalar.name())
    }

    /// Everything but the substeps.
    pub fn group(self) -> String {
        let sweeps = if has_sweeps(self.solver) { format!(" × {}", self.sweeps) } else { String::new() };
        let tolerance = self.tolerance.map_or(String::new(), |tolerance| format!(" within {tolerance}"));
        format!("{}{sweeps}{tolerance}", self.kind())
    }

    /// Substeps, sweeps and tolerance.
    pub fn settings(self) -> String {
        format!("{}{}", self.substeps, self.group().trim_start_matches(&self.kind()))
    }
}

impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.kind(), self.settings())
    }
}

/// Whether a solver has a number of sweeps or Newton steps.
pub const fn has_sweeps(solver: SolverKind) -> bool {
    matches!(solver, SolverKind::Verlet | SolverKind::BackwardEuler | SolverKind::Lines)
}

/// The work of a solver's sweep, in plain sweeps: about 2 for a sweep of the line solver over all families, with its further sweeps, and about 64 for a Newton step of
/// backward Euler with its conjugate gradients.
const fn weight(solver: SolverKind) -> u32 {
    match solver {
        SolverKind::Lines => 2,
        SolverKind::BackwardEuler => 64,
        _ => 1,
    }
}

/// The configurations that a study compares.
#[derive(Clone, Debug)]
pub struct Choice {
    pub solvers: Vec<SolverKind>,
    pub scalars: Vec<ScalarKind>,
    pub substeps: Vec<u32>,
    /// For every solver that has sweeps; if empty, usual values for each solver.
    pub sweeps: Vec<u32>,
    /// For the line solver.
    pub tolerances: Vec<f64>,
    /// The most plain sweeps in a frame; see `weight`.
    pub work: u32,
}

impl Choice {
    /// All configurations. Those that differ only in substeps follow each other.
    pub fn configurations(&self) -> Vec<Configuration> {
        let mut all = Vec::new();
        for &solver in &self.solvers {
            let mut kinds = Vec::new();
            for &sweeps in self.sweeps(solver) {
                if solver == SolverKind::Lines {
                    kinds.extend(self.tolerances.iter().map(|&tolerance| (sweeps, Some(tolerance))));
                } else {
                    kinds.push((sweeps, None));
                }
            }
            for ((sweeps, tolerance), &scalar) in
                kinds.iter().flat_map(|&kind| self.scalars.iter().map(move |s| (kind, s)))
            {
                let work = sweeps.saturating_mul(weight(solver));
                let substeps = self.substeps.iter().filter(|&&substeps| substeps.saturating_mul(work) <= self.work);
                all.extend(substeps.map(|&substeps| Configuration { solver, scalar, substeps, sweeps, tolerance }));
            }
        }
        all
    }

    fn sweeps(&self, solver: SolverKind) -> &[u32] {
        match solver {
            _ if !has_sweeps(solver) => &[1],
            _ if !self.sweeps.is_empty() => &self.sweeps,
            SolverKind::Verlet => &[1, 4, 16],
            SolverKind::BackwardEuler | SolverKind::Lines => &[1, 2],
            _ => &[1],
        }
    }
}

//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Parser, value_parser};
use kerchief::host::{DEFAULT_SCENE, Description, MOST, ScalarKind, SolverKind};

use console::{scalar_kind, solver_kind};

/// Runs a scene of cloth: writes an animation and a report, or opens a window.
#[derive(Debug, Parser)]
///
/// Exit status: 0; 2 if the scene or an option is refused, and nothing written; 3 if the sheet exploded: a number that is not finite, a particle further
/// than a million sheet sizes from the start, or one that left the range of fixed point. What was recorded is written all the same, and the report says
/// finite: false. A signal ends the program with 128 and the signal's number.
#[command(name = "simulate", version)]
// One bool for each flag.
#[allow(clippy::struct_excessive_bools)]
pub(crate) struct Args {
    /// A scene file, or a built-in scene: gravity, sphere, wind, no-shear, flag, curtain, drape, heap, fold
    #[arg(default_value = DEFAULT_SCENE)]
    pub(crate) scene: OsString,
    /// Number type
    #[arg(long, value_name = "TYPE", default_value = ScalarKind::F32.name(), value_parser = scalar_kind())]
    pub(crate) scalar: ScalarKind,
    /// Solver, instead of the scene's
    #[arg(long, value_name = "KIND", value_parser = solver_kind())]
    pub(crate) solver: Option<SolverKind>,
    /// Solver steps per frame, instead of the scene's
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u32).range(1..=i64::from(MOST)))]
    pub(crate) substeps: Option<u32>,
    /// Relaxation sweeps per substep (lines: pairs of sweeps; backward Euler: Newton steps), instead of the scene's
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u32).range(1..=i64::from(MOST)))]
    pub(crate) iterations: Option<u32>,
    /// Number of frames, instead of the scene's
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u32).range(1..=i64::from(MOST)))]
    pub(crate) frames: Option<u32>,
    /// Where pictures and data go
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub(crate) out: PathBuf,
    /// Write animation.gif (as a run does that is asked for nothing else)
    #[arg(long)]
    pub(crate) gif: bool,
    /// Write every recorded frame as frame-NNNNN.png
    #[arg(long)]
    pub(crate) png: bool,
    /// Write every recorded frame as frame-NNNNN.obj: a mesh with normals and texture coordinates, in metres, z up
    #[arg(long)]
    pub(crate) obj: bool,
    /// Write positions.csv
    #[arg(long)]
    pub(crate) csv: bool,
    /// Count in every frame how often the sheet passes through itself, by every edge and triangle of it: slow on large grids
    #[arg(long)]
    pub(crate) intersections: bool,
    /// Record every Nth frame; the first and the last always
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 1, value_parser = value_parser!(u32).range(1..=i64::from(MOST)))]
    pub(crate) every: u32,
    /// Open a live window instead, which names its keys and buttons; needs the cargo feature `window`
    #[arg(long, conflicts_with_all = ["gif", "png", "obj", "csv"])]
    pub(crate) window: bool,
}

impl Args {
    /// Whether an animation is to be written.
    pub(crate) fn animation(&self) -> bool {
        self.gif || !(self.png || self.obj || self.csv)
    }

    /// Overrides the scene with the options of the command line.
    pub(crate) fn override_scene(&self, scene: &mut Description) {
        let solver = &mut scene.solver;
        solver.kind = self.solver.unwrap_or(solver.kind);
        solver.substeps = self.substeps.unwrap_or(solver.substeps);
        if let Some(iterations) = self.iterations {
            // The file's sweeps would take precedence.
            (solver.iterations, solver.sweeps) = (iterations, None);
        }
        scene.frames = self.frames.unwrap_or(scene.frames);
    }
}

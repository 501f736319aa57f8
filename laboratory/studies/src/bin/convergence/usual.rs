//! All solvers with usual numbers of sweeps.

use kerchief::host::{ScalarKind, SolverKind};

use plotters::style::RGBColor;

use laboratory::configuration::{Configuration, has_sweeps};
use laboratory::plot::{COLOURS, colour};

/// All solvers with usual numbers of sweeps.
pub(crate) const USUAL: [(SolverKind, u32); 7] = [
    (SolverKind::Lines, 2),
    (SolverKind::Lines, 1),
    (SolverKind::Leapfrog, 1),
    (SolverKind::Xpbd, 1),
    (SolverKind::BackwardEuler, 2),
    (SolverKind::Verlet, 4),
    (SolverKind::ForwardEuler, 1),
];

/// A colour for each entry of [`USUAL`].
pub(crate) const fn colour_of((solver, sweeps): (SolverKind, u32)) -> RGBColor {
    match solver {
        SolverKind::Lines if sweeps > 1 => COLOURS[5],
        _ => colour(solver),
    }
}

/// The name of a solver with its sweeps.
pub(crate) fn name(solver: SolverKind, sweeps: u32) -> String {
    if has_sweeps(solver) { format!("{} × {sweeps}", solver.name()) } else { solver.name().to_string() }
}

/// The configurations of [`USUAL`] in a number type.
pub(crate) fn usual(scalar: ScalarKind, substeps: u32) -> impl Iterator<Item = Configuration> {
    USUAL.into_iter().map(move |(solver, sweeps)| Configuration { solver, scalar, substeps, sweeps, tolerance: None })
}

//! Goals of the line solver: bounds on position errors against the equation of motion, on strains, and on the operations spent.
//!
//! Operations are counted (`Counted`), so that no bound depends on the machine. The laboratory plots operations and instructions.

mod sheet;

use std::fmt::Write;

use sheet::{Hold, Sheet};

/// A setting of the line solver in `f32`, with its bounds.
struct Goal {
    sheet: Sheet,
    /// Substeps of a frame of 0.1 s.
    substeps: u32,
    /// The largest strain of a row that needs no more than two sweeps in a substep.
    tolerance: f64,
    /// Position error, RMS over particles and frames / sheet size.
    error: f64,
    /// The largest strain of a stretch link at the end of any frame.
    strain: f64,
    /// Operations per particle and frame.
    operations: f64,
}

const TWO_CORNERS: Sheet = Sheet { side: 16, mass: 1.0, hold: Hold::TwoCorners, wind: None, frames: 20 };
const TOP_EDGE: Sheet = Sheet { side: 32, mass: 1.0, hold: Hold::TopEdge, wind: None, frames: 20 };
const FLAG: Sheet = Sheet { side: 32, mass: 1.0, hold: Hold::LeftEdge, wind: Some([5.0, 0.0, -3.0]), frames: 20 };
/// Fewer, larger cells: the same wind presses four times as hard on each particle. After the first second this flag flutters, and errors grow with any step.
const WIND: Sheet = Sheet { side: 16, frames: 10, ..FLAG };
/// The flag on cells twice as wide, with the same total mass in the same wind.
const COARSE_FLAG: Sheet = Sheet { side: 16, mass: 4.0, ..FLAG };

#[rustfmt::skip]
const GOALS: [Goal; 12] = [
    Goal { sheet: TWO_CORNERS, substeps:  4, tolerance: 0.1,   error: 1e-2, strain: 0.1,   operations:  2_900.0 },
    Goal { sheet: TWO_CORNERS, substeps:  7, tolerance: 0.005, error: 1e-3, strain: 0.005, operations:  8_600.0 },
    Goal { sheet: TWO_CORNERS, substeps:  9, tolerance: 0.02,  error: 2e-3, strain: 0.005, operations:  5_700.0 },
    Goal { sheet: TWO_CORNERS, substeps: 24, tolerance: 0.02,  error: 1e-4, strain: 0.005, operations: 17_000.0 },
    Goal { sheet: TOP_EDGE,    substeps:  3, tolerance: 0.02,  error: 1e-3, strain: 0.005, operations:  2_200.0 },
    Goal { sheet: TOP_EDGE,    substeps: 12, tolerance: 0.02,  error: 1e-4, strain: 0.005, operations:  8_700.0 },
    Goal { sheet: FLAG,        substeps:  2, tolerance: 0.02,  error: 5e-3, strain: 0.01,  operations:  1_900.0 },
    Goal { sheet: FLAG,        substeps:  8, tolerance: 0.02,  error: 1e-3, strain: 0.005, operations:  7_000.0 },
    Goal { sheet: WIND,        substeps:  8, tolerance: 0.02,  error: 2e-3, strain: 0.005, operations:  7_000.0 },
    Goal { sheet: WIND,        substeps: 24, tolerance: 0.02,  error: 1.5e-4, strain: 0.005, operations: 21_000.0 },
    Goal { sheet: COARSE_FLAG, substeps:  8, tolerance: 0.02,  error: 1e-3, strain: 0.005, operations:  7_000.0 },
    Goal { sheet: COARSE_FLAG, substeps: 24, tolerance: 0.02,  error: 1e-4, strain: 0.005, operations: 21_000.0 },
];

/// Asserts the goals of one sheet against one reference.
fn assert_goals(sheet: &Sheet) {
    let reference = sheet.reference();
    let mut missed = String::new();
    for goal in GOALS.iter().filter(|goal| goal.sheet == *sheet) {
        let Goal { substeps, tolerance, error, strain, operations, .. } = *goal;
        let found = sheet.run(substeps, tolerance, &reference);
        let within = found.error <= error && found.strain <= strain && found.operations <= operations;
        if !within {
            let _ = write!(
                missed,
                "\n{substeps} substeps within {tolerance}: at most {error:.1e}, {strain:.1e}, {operations:.0}, found {found:?}"
            );
        }
    }
    assert!(missed.is_empty(), "{sheet:?}: error, strain, operations{missed}");
}

#[test]
fn two_corners() {
    assert_goals(&TWO_CORNERS);
}

#[test]
fn top_edge() {
    assert_goals(&TOP_EDGE);
}

#[test]
fn flag() {
    assert_goals(&FLAG);
}

#[test]
fn wind() {
    assert_goals(&WIND);
}

#[test]
fn coarse_flag() {
    assert_goals(&COARSE_FLAG);
}

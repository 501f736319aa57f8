//! What the line solver promises for its cost: position errors against the equation of motion, strains, and the operations they take.
//!
//! Operations are counted (`Counted`), so that no bound depends on the machine. The laboratory puts them and instructions into plots.

mod sheet;

use sheet::{Hold, Sheet};

/// A setting of the line solver in `f32` and what it has to reach in 2 s.
struct Goal {
    sheet: Sheet,
    /// Substeps of a frame of 0.1 s, and sweeps in each.
    substeps: u32,
    sweeps: u32,
    /// Position error, RMS over particles and frames / sheet size.
    error: f64,
    /// The largest strain of a stretch link at the end of any frame.
    strain: f64,
    /// Operations per particle and frame.
    operations: f64,
}

const TWO_CORNERS: Sheet = Sheet { side: 16, hold: Hold::TwoCorners, wind: None };
const TOP_EDGE: Sheet = Sheet { side: 32, hold: Hold::TopEdge, wind: None };
const FLAG: Sheet = Sheet { side: 32, hold: Hold::LeftEdge, wind: Some([5.0, 0.0, -3.0]) };

#[rustfmt::skip]
const GOALS: [Goal; 7] = [
    Goal { sheet: TWO_CORNERS, substeps:  2, sweeps: 2, error: 1.6e-2, strain: 3.5e-2, operations:  1_400.0 },
    Goal { sheet: TWO_CORNERS, substeps:  8, sweeps: 2, error: 2.7e-3, strain: 3.7e-3, operations:  3_900.0 },
    Goal { sheet: TWO_CORNERS, substeps: 24, sweeps: 2, error: 3.5e-4, strain: 3.8e-3, operations: 11_700.0 },
    Goal { sheet: TOP_EDGE,    substeps:  3, sweeps: 2, error: 1.7e-3, strain: 1.6e-3, operations:  1_500.0 },
    Goal { sheet: TOP_EDGE,    substeps: 12, sweeps: 2, error: 1.4e-4, strain: 1.8e-3, operations:  6_000.0 },
    Goal { sheet: FLAG,        substeps:  2, sweeps: 2, error: 3.9e-3, strain: 1.7e-2, operations:  1_400.0 },
    Goal { sheet: FLAG,        substeps:  8, sweeps: 2, error: 1.1e-3, strain: 2.1e-3, operations:  5_000.0 },
];

/// Asserts the goals of one sheet against one reference.
fn assert_goals(sheet: &Sheet) {
    let reference = sheet.reference();
    let mut missed = String::new();
    for goal in GOALS.iter().filter(|goal| goal.sheet == *sheet) {
        let Goal { substeps, sweeps, error, strain, operations, .. } = *goal;
        let found = sheet.run(substeps, sweeps, &reference);
        let within = found.error <= error && found.strain <= strain && found.operations <= operations;
        if !within {
            missed += &format!(
                "\n{substeps} × {sweeps}: at most {error:.1e}, {strain:.1e}, {operations:.0}, found {found:?}"
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

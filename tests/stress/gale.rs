//! The force of facet wind grows with a triangle's area and does not weaken with its velocity. In long steps it once threw a sheet further than its links brought it back, which
//! stretched the sheet and made the wind stronger, until numbers overflowed. The long version adds larger grids.

use core::cmp::Ordering;

use kerchief::{BackwardEuler, FacetWind, Lines, Node, Q13, Q24, Scalar, Solver, Verlet, Xpbd};

use crate::is_long;
use crate::stage::{CLOTH, Sheet, Stage};

const SIZE: f64 = CLOTH.size;
/// Frames of a run.
const FRAMES: u32 = 30;

/// The largest coordinate of a sheet pinned at its upper edge, m.
fn reach<S: Scalar, V: Solver<S>, const N: usize>(solver: V, speed: f64, step: f64) -> f64 {
    // 0.1 kg/m²
    let mass = 0.1 / ((N - 1) * (N - 1)) as f64;
    let sheet = Sheet { mass, frame: step, substeps: 1, drag: 0.1, ..CLOTH };
    let mut stage = Stage::<S, V, N, N>::new(&sheet, solver);
    (0..N).for_each(|column| stage.cloth.pin(Node::new(column, 0)));
    let wind = [0.2 * speed, 0.95 * speed, 0.24 * speed];
    stage.scene.forces.2 = Some(FacetWind::new(stage.units.facet_wind(wind)));
    let mut reach = 0.0_f64;
    for _ in 0..FRAMES {
        stage.step();
        reach = reach.max(stage.reach());
    }
    reach
}

fn every_solver<S: Scalar, const N: usize>(failures: &mut Vec<String>) {
    for speed in [5.0, 15.0, 30.0] {
        for step in [1e-3, 8.7e-3, 1.0 / 60.0, 0.1] {
            let reaches = [
                ("xpbd", reach::<S, _, N>(Xpbd, speed, step)),
                ("verlet", reach::<S, _, N>(Verlet { sweeps: 4 }, speed, step)),
                ("lines", reach::<S, _, N>(Lines::default(), speed, step)),
                ("backward Euler", reach::<S, _, N>(BackwardEuler { newton_steps: 2 }, speed, step)),
            ];
            // three times as far as the wind goes; an undefined reach fails too
            let most = 3.0 * (SIZE + speed * step * f64::from(FRAMES));
            for (name, reach) in reaches {
                if reach.partial_cmp(&most) != Some(Ordering::Less) {
                    failures.push(format!("{name} in {}, {N} × {N}, {speed} m/s, {step} s: {reach:.3e} m", S::NAME));
                }
            }
        }
    }
}

#[test]
fn wind_of_facets_stays_finite_in_any_step() {
    let mut failures = Vec::new();
    every_solver::<f32, 8>(&mut failures);
    every_solver::<f64, 8>(&mut failures);
    every_solver::<Q24, 8>(&mut failures);
    every_solver::<Q13, 8>(&mut failures);
    every_solver::<f32, 16>(&mut failures);
    every_solver::<f64, 24>(&mut failures);
    if is_long() {
        every_solver::<Q24, 24>(&mut failures);
        every_solver::<f32, 32>(&mut failures);
        every_solver::<Q13, 32>(&mut failures);
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

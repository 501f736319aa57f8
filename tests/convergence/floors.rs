//! Rounding errors of every solver in every number type.

use kerchief::{Q13, Q24, Scalar};

use rig::reference::State;
use rig::scenes::corners;
use rig::{Method, Pace, error, moved};

/// Every solver, its substeps of 0.1 s, and its largest distance in `f32`, `Q24` and `Q13` from itself in `f64`, sheet sizes. Substeps are as long as stability allows:
/// the longer they are, the weaker are the forces that fixed point rounds to nothing.
const FLOORS: [(Method, u32, [f64; 3]); 7] = [
    (Method::ForwardEuler, 512, [2e-5, 6e-3, 6e-3]),
    (Method::BackwardEuler, 16, [1e-5, 1e-5, 2e-3]),
    (Method::Leapfrog, 32, [2e-6, 3e-5, 3e-5]),
    (Method::Verlet(4), 16, [1e-5, 3e-5, 4e-4]),
    (Method::Xpbd, 16, [1e-5, 1e-5, 1e-4]),
    (Method::Lines(1), 16, [1e-5, 3e-5, 3e-3]),
    (Method::Lines(2), 16, [1e-5, 3e-5, 3e-3]),
];

/// The sheet after each of twenty frames.
fn frames<S: Scalar>(method: Method, substeps: u32) -> Vec<State> {
    let mut motion = moved::<S, 8, 8>(&corners(8), Pace::new(0.1, substeps), method);
    (0..20)
        .map(|_| {
            motion.run(1);
            motion.state()
        })
        .collect()
}

#[test]
fn rounding_stays_below_every_solvers_floor() {
    let model = corners(8);
    for (method, substeps, floors) in FLOORS {
        let exact = frames::<f64>(method, substeps);
        let off = |found: Vec<State>| {
            found.iter().zip(&exact).map(|(found, exact)| error(&model, found, exact)).fold(0.0, f64::max)
        };
        let found = [frames::<f32>, frames::<Q24>, frames::<Q13>].map(|frames| off(frames(method, substeps)));
        println!("{method:?} × {substeps}: {found:?}");
        for ((number, found), floor) in ["f32", "q24", "q13"].into_iter().zip(found).zip(floors) {
            assert!(found <= floor, "{method:?} in {number}: {found:e} sheet sizes from f64");
        }
    }
}

//! Super-elasticity, which the thesis could not cure: the thesis' method shows it, and the line solver does not.

use kerchief::Scalar;

use rig::reference::{BEND, Family, Model, Pose, SHEAR, STRETCH, Sheet, drag_of_verlet_damping};
use rig::scenes::GRAVITY;
use rig::{Method, Pace, moved, strain};

/// 32 × 32 particles of 1 kg on 10 m, pinned at three corners.
fn gravity() -> Model {
    let sheet = Sheet::new(Pose::Lay, [32, 32], [10.0, 10.0]).with_pins(&[(0, 0), (31, 0), (0, 31)]);
    Model {
        families: vec![Family::new(STRETCH, 94_270.0), Family::new(SHEAR, 9_427.0), Family::new(BEND, 942.7)],
        gravity: GRAVITY,
        drag: drag_of_verlet_damping(0.1, 0.1),
        ..Model::new(sheet)
    }
}

fn strain_in_motion<S: Scalar>(method: Method, substeps: u32, frames: u32) -> f64 {
    let model = gravity();
    let mut motion = moved::<S, 32, 32>(&model, Pace::new(0.1, substeps), method);
    let frames = (0..frames).map(|_| {
        motion.run(1);
        let state = motion.state();
        strain(&model, &state, (1, 0)).max(strain(&model, &state, (0, 1)))
    });
    frames.fold(0.0, f64::max)
}

#[test]
fn the_thesis_method_is_super_elastic_and_the_line_solver_is_not() {
    let model = gravity();
    let exact = model.ode().solve(&model.start(), &rig::tenths(20), 1e-4);
    let true_strain = exact
        .states
        .iter()
        .map(|state| strain(&model, state, (1, 0)).max(strain(&model, state, (0, 1))))
        .fold(0.0, f64::max);
    // three pins carry a tonne: the springs themselves stretch by a third of their length
    assert!((0.2..0.5).contains(&true_strain), "{true_strain}");
    let thesis = strain_in_motion::<f32>(Method::Verlet(15), 1, 20);
    assert!(thesis > 2.0, "15 sweeps of the thesis: {thesis}");
    let lines = strain_in_motion::<f32>(Method::Lines(2), 16, 20);
    assert!((lines - true_strain).abs() < 0.05, "line solver: {lines} instead of {true_strain}");
}

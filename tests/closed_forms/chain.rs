//! A hanging chain at rest and in small swings.

use kerchief::{Leapfrog, Lines, Q24, Scalar};

use rig::reference::closed_forms::{hanging_chain, pendulum_frequencies, pendulum_mode};
use rig::reference::{Family, Model, Pose, STRETCH, Sheet};
use rig::scenes::GRAVITY;
use rig::{Method, Pace, Rig, moved};

const LINKS: f64 = 31.0;

/// A chain of 32 particles, 1 m and 10 g each, hung up.
fn chain(stiffness: f64, drag: f64) -> Model {
    let sheet = Sheet::new(Pose::Hang, [1, 32], [0.0, 1.0]).with_mass(0.01).with_pins(&[(0, 0)]);
    Model { families: vec![Family::new(STRETCH, stiffness)], gravity: GRAVITY, drag, ..Model::new(sheet) }
}

#[test]
fn a_hanging_chain_comes_to_rest_at_its_own_weight() {
    fn check<S: Scalar>(method: Method, substeps: u32, bound: f64) {
        let model = chain(3000.0, 8.0);
        let expected = hanging_chain(&model.sheet.masses, 1.0 / LINKS, 3000.0, 9.81);
        let mut motion = moved::<S, 1, 32>(&model, Pace::new(0.05, substeps), method);
        motion.run(200);
        for (position, height) in motion.state().position.iter().zip(&expected) {
            let error = position[2] - height;
            assert!(error.abs() < bound, "{method:?} in {}: {error:e} m", S::NAME);
            assert!(position[0].abs() < bound && position[1].abs() < bound, "sideways");
        }
    }
    for method in [Method::Lines(1), Method::Lines(2)] {
        check::<f64>(method, 16, 1e-6);
        check::<f32>(method, 16, 2e-5);
        check::<Q24>(method, 16, 2e-5);
    }
    check::<f64>(Method::BackwardEuler, 4, 1e-5);
    check::<f64>(Method::Leapfrog, 64, 1e-6);
}

/// The period of the chain's first mode, s: from the passages of its lowest particle through zero, over `count` swings.
fn swings<V: kerchief::Solver<f64>>(solver: V, count: u32, stiffness: f64) -> f64 {
    let model = chain(stiffness, 0.0);
    let mut rig = Rig::<f64, _, 1, 32>::new(&model, Pace::new(0.01, 32), solver);
    let mut state = model.start();
    let heights = hanging_chain(&model.sheet.masses, 1.0 / LINKS, stiffness, 9.81);
    let mode = pendulum_mode(31, 1.0 / LINKS, 9.81, pendulum_frequencies(31, 1.0 / LINKS, 9.81)[0]);
    for (i, position) in state.position.iter_mut().enumerate() {
        position[2] = heights[i];
        position[0] = 1e-3 * mode[i];
    }
    rig.set(&state);
    let (mut passages, mut frame, mut before) = (0, 0, rig.state().position[31][0]);
    loop {
        rig.step();
        frame += 1;
        let x = rig.state().position[31][0];
        if (x < 0.0) != (before < 0.0) {
            passages += 1;
            if passages == 2 * count {
                let part = before / (before - x);
                // the first passage comes after a quarter of a swing
                return 0.01 * (f64::from(frame - 1) + part) / (f64::from(count) - 0.25);
            }
        }
        before = x;
    }
}

#[test]
fn a_chain_swings_at_the_frequency_of_laguerres_polynomial() {
    let stiffness = 60_000.0;
    let period = core::f64::consts::TAU / pendulum_frequencies(31, 1.0 / LINKS, 9.81)[0];
    for (name, found) in
        [("leapfrog", swings(Leapfrog, 3, stiffness)), ("lines", swings(Lines::default(), 3, stiffness))]
    {
        let error = found / period - 1.0;
        // the springs stretch by 0.08 % of the length, which the inextensible closed form leaves out
        assert!(error.abs() < 1e-3, "{name}: {found} s instead of {period} s");
    }
}

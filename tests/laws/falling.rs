//! Momentum, free fall, rest, energy.

use kerchief::{Leapfrog, Q13, Q24, Scalar, measure};

use rig::reference::{Model, Pose, Sheet};
use rig::scenes::{GRAVITY, corners, springs};
use rig::{ALL, Method, Pace, Rig, moved, stirred};

/// A free sheet of 8 × 8 particles, 1 m, 10 g each.
fn free(gravity: [f64; 3]) -> Model {
    let sheet = Sheet::new(Pose::Lay, [8, 8], [1.0, 1.0]).with_mass(0.01).with_origin([-0.5, -0.5, 0.0]);
    Model { families: springs(50.0, 10.0, 1.0), gravity, ..Model::new(sheet) }
}

#[test]
fn without_forces_momentum_stays() {
    fn check<S: Scalar>(bound: f64) {
        let mut model = free([0.0; 3]);
        for family in &mut model.families {
            family.damping = 0.01;
        }
        for method in ALL {
            let mut motion = moved::<S, 8, 8>(&model, Pace::new(0.02, 16), method);
            motion.set(&stirred(&model));
            let momentum = |velocities: &[[f64; 3]], axis: usize| velocities.iter().map(|v| v[axis]).sum::<f64>();
            let (before, speed) = (motion.state(), 64.0 * 0.05);
            motion.run(50);
            for axis in 0..3 {
                let change = momentum(&motion.state().velocity, axis) - momentum(&before.velocity, axis);
                assert!(change.abs() < bound * speed, "{method:?} in {}: {change:e} along {axis}", S::NAME);
            }
        }
    }
    check::<f64>(1e-13);
    check::<f32>(1e-4);
    // 800 substeps, each with rounding errors of 2⁻²⁴ cells at a few links a particle, which partly cancel
    check::<Q24>(5e-3);
}

#[test]
fn a_free_sheet_falls_as_galileo_says() {
    fn check<S: Scalar>(bound: f64) {
        let model = free(GRAVITY);
        let (frame, substeps, frames) = (0.01, 4, 30);
        let (t, h) = (frame * f64::from(frames), frame / f64::from(substeps));
        for method in ALL {
            let mut motion = moved::<S, 8, 8>(&model, Pace::new(frame, substeps), method);
            motion.run(frames);
            // Euler's methods move by the velocity at the start or the end of a step
            let late = match method {
                Method::ForwardEuler => -0.5,
                Method::Leapfrog | Method::Lines(_) => 0.0,
                _ => 0.5,
            };
            let expected = GRAVITY[2] * (0.5 * t * t + late * h * t);
            for position in motion.state().position {
                let error = position[2] - expected;
                assert!(error.abs() < bound, "{method:?} in {}: off by {error:e} m", S::NAME);
            }
        }
    }
    check::<f64>(1e-13);
    check::<f32>(3e-6);
    // measured 5e-6: the velocity gained in a substep is rounded to 3e-8 cells per tick, in 120 substeps
    check::<Q24>(6e-6);
}

/// Guards against a velocity factor that is slightly below 1 without drag: its error would grow with the number of substeps.
#[test]
fn finer_steps_fall_no_less_far() {
    fn check<S: Scalar>(bound: f64) {
        let (frame, frames) = (1.0 / 60.0, 36);
        let t = frame * f64::from(frames);
        for substeps in [8, 32, 128, 512] {
            // in the shortest substeps such soft springs would round to nothing in fixed point
            let stiffer = (f64::from(substeps) / 128.0).powi(2).max(1.0);
            let families = springs(50.0 * stiffer, 10.0 * stiffer, stiffer);
            let model = Model { families, ..free(GRAVITY) };
            for method in ALL {
                let mut motion = moved::<S, 8, 8>(&model, Pace::new(frame, substeps), method);
                motion.run(frames);
                let late = match method {
                    Method::ForwardEuler => -0.5,
                    Method::Leapfrog | Method::Lines(_) => 0.0,
                    _ => 0.5,
                };
                let expected = GRAVITY[2] * (0.5 * t * t + late * frame / f64::from(substeps) * t);
                let error = (motion.state().position[0][2] - expected).abs();
                assert!(error < bound, "{method:?} in {}, {substeps} substeps: off by {error:e} m", S::NAME);
            }
        }
    }
    check::<f64>(2e-12);
    // the shorter a substep is, the fewer digits has the velocity that gravity adds in it
    check::<f32>(2e-4);
    check::<Q24>(2e-4);
    check::<Q13>(2e-4);
}

#[test]
fn drag_slows_a_falling_sheet_as_the_closed_form_says() {
    let model = Model { drag: 2.0, ..free(GRAVITY) };
    let t = 0.5;
    for (method, bound) in
        [(Method::Leapfrog, 1e-4), (Method::Lines(1), 1e-4), (Method::Xpbd, 2e-2), (Method::BackwardEuler, 2e-2)]
    {
        let mut motion = moved::<f64, 8, 8>(&model, Pace::new(0.05, 16), method);
        motion.run(10);
        let [height, velocity] = rig::reference::closed_forms::fall_with_drag(GRAVITY[2], 2.0, 0.0, t);
        let state = motion.state();
        let errors = [state.position[0][2] - height, state.velocity[0][2] - velocity];
        assert!(errors.iter().all(|e| e.abs() < bound), "{method:?}: {errors:?}");
    }
}

#[test]
fn a_sheet_at_rest_stays_at_rest_to_the_last_bit() {
    fn check<S: Scalar>() {
        for method in ALL {
            let mut motion = moved::<S, 8, 8>(&free([0.0; 3]), Pace::new(0.02, 8), method);
            let digest = motion.digest();
            motion.run(1250);
            assert_eq!(motion.digest(), digest, "{method:?} in {} after 10 000 substeps", S::NAME);
        }
    }
    check::<f32>();
    check::<f64>();
    check::<Q24>();
}

#[test]
fn energy_does_not_grow_and_leapfrog_keeps_it() {
    let model = Model { drag: 0.0, ..corners(8) };
    // the potential energy of a fall by the sheet's size
    let scale = 64.0 * 9.81 * 10.0;
    for method in [Method::BackwardEuler, Method::Verlet(1), Method::Xpbd, Method::Lines(1), Method::Lines(2)] {
        let mut motion = moved::<f64, 8, 8>(&model, Pace::new(0.1, 32), method);
        let ode = model.ode();
        let start = ode.energy(&motion.state());
        for _ in 0..40 {
            motion.run(1);
            let gained = (ode.energy(&motion.state()) - start) / scale;
            assert!(gained < 1e-3, "{method:?} gained {gained}");
        }
    }
    let mut rig = Rig::<f64, _, 8, 8>::new(&model, Pace::new(0.1, 64), Leapfrog);
    let energy = |rig: &Rig<f64, Leapfrog, 8, 8>| {
        measure::kinetic_energy(&rig.cloth, &rig.units)
            + measure::gravitational_energy(&rig.cloth, &rig.units, GRAVITY)
            + measure::elastic_energy(&rig.cloth, &rig.units, &rig.scene.links)
    };
    let start = energy(&rig);
    for _ in 0..100 {
        rig.step();
        let drift = (energy(&rig) - start).abs() / scale;
        assert!(drift < 2e-3, "leapfrog drifted by {drift}");
        let reference = model.ode().energy(&rig.state());
        assert!((energy(&rig) - reference).abs() < 1e-9 * scale, "both measures of energy must agree");
    }
}

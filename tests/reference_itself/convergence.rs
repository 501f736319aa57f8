//! Order, stability and error estimate of the reference solution.

use super::{advanced, everything, isolated};
use rig::reference::{BEND, Family, Model, Pose, SHEAR, STRETCH, Sheet, drag_of_verlet_damping, rms_distance};

#[test]
fn halving_the_step_divides_the_error_by_sixteen() {
    let model = everything();
    let start = model.start();
    let exact = advanced(&model, &start, 0.5, 6400);
    let error = |steps| rms_distance(&advanced(&model, &start, 0.5, steps).position, &exact.position);
    let errors = [error(200), error(400), error(800)];
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((3.8..4.2).contains(&order), "order {order} from the errors {errors:?}");
    }
}

#[test]
fn the_stable_step_is_stable() {
    // |R(s·h)| ≤ 1 on the half disc on which `stable_step` relies. R is the Taylor polynomial of exp of degree 4.
    for i in 0..=180 {
        let angle = core::f64::consts::FRAC_PI_2 + core::f64::consts::PI * f64::from(i) / 180.0;
        for radius in [0.1, 0.5, 1.0, 1.5, 2.0, 2.3, 2.6] {
            let (mut re, mut im) = (1.0, 0.0);
            for k in (1..=4).rev() {
                let (c, s) = (radius / f64::from(k) * angle.cos(), radius / f64::from(k) * angle.sin());
                (re, im) = (1.0 + c * re - s * im, c * im + s * re);
            }
            assert!(re.hypot(im) <= 1.0 + 1e-12, "|R| = {} at {radius} and {angle} rad", re.hypot(im));
        }
    }
    // Small vibrations of a sheet at rest do not grow in many steps of that length, and grow in steps of twice that length.
    let mut model = isolated();
    model.sheet = Sheet::new(Pose::Lay, [8, 8], [1.0, 1.0]).with_mass(0.01);
    model.families = vec![Family::new(STRETCH, 100.0), Family::new(BEND, 10.0)];
    let ode = model.ode();
    let mut start = model.start();
    start.position.iter_mut().enumerate().for_each(|(i, x)| x[0] += 1e-6 * (i as f64 * 2.4).sin());
    let energy_after = |factor: f64| {
        let mut state = start.clone();
        ode.rk4(&mut state, factor * ode.stable_step(), 2000);
        ode.energy(&state)
    };
    assert!(energy_after(1.0) <= ode.energy(&start));
    let beyond = energy_after(2.0);
    assert!(beyond.is_nan() || beyond > 10.0 * ode.energy(&start), "twice the step is stable too: {beyond} J");
}

#[test]
fn a_solution_is_as_exact_as_it_says() {
    let model = everything();
    let times = [0.0, 0.25, 0.5, 0.5, 1.0];
    let solution = model.solve(&times, 1e-7);
    assert!(solution.difference <= 1e-7);
    assert_eq!(solution.states.len(), times.len());
    assert_eq!(solution.states[0].position, model.start().position);
    assert_eq!(solution.states[2].position, solution.states[3].position);
    let mut exact = model.start();
    let mut now = 0.0;
    for (time, state) in times.into_iter().zip(&solution.states) {
        model.ode().rk4(&mut exact, (time - now) / 10_000.0, 10_000);
        now = time;
        let error = rms_distance(&exact.position, &state.position) / model.sheet.size();
        assert!(error <= solution.difference / 8.0, "{error} at {time} s, difference {}", solution.difference);
        assert!(error <= 1.5 * solution.error(), "{error} at {time} s, estimate {}", solution.error());
    }
}

#[test]
fn the_thesis_sheet_is_solved() {
    // Its stiffest links and its damping: 10 m of cloth on two corners swing down for 2 s.
    let n = 32;
    let sheet = Sheet::new(Pose::Lay, [n, n], [10.0, 10.0]).with_pins(&[(0, 0), (n - 1, 0)]);
    let families = vec![Family::new(STRETCH, 942_700.0), Family::new(SHEAR, 9427.0), Family::new(BEND, 942.7)];
    let drag = drag_of_verlet_damping(0.1, 0.1);
    assert!((drag - 1.0536).abs() < 1e-4);
    let model = Model { families, gravity: [0.0, 0.0, -9.81], drag, ..Model::new(sheet) };
    let solution = model.solve(&[0.5, 1.0, 1.5, 2.0], 1e-7);
    assert!(solution.error() <= 1e-7);
    let lowest = solution.last().position.iter().fold(0.0, |z: f64, x| z.min(x[2]));
    assert!((-14.5..-5.0).contains(&lowest), "the far edge must swing down, not to {lowest} m");
}

#[test]
#[should_panic(expected = "did not converge")]
fn a_tolerance_below_round_off_is_refused() {
    everything().solve(&[0.05], 1e-18);
}

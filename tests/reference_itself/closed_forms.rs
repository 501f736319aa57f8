//! The reference against closed forms, and closed forms against each other.

use super::acceleration;
use rig::reference::closed_forms::*;
use rig::reference::{Family, Model, Pose, STRETCH, Sheet, State, Wind};

const G: f64 = 9.81;

/// A chain of `n` particles with links of `rest` m along y (lay) or downwards (hang).
fn chain(pose: Pose, n: usize, rest: f64, stiffness: f64) -> Model {
    let sheet = Sheet::new(pose, [1, n], [0.0, rest * (n - 1) as f64]);
    Model { families: vec![Family::new(STRETCH, stiffness)], ..Model::new(sheet) }
}

fn assert_near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not within {tolerance} of {b}");
}

fn largest_acceleration(model: &Model, state: &State) -> f64 {
    acceleration(model, state).iter().flatten().fold(0.0, |m, a| m.max(a.abs()))
}

#[test]
fn a_dropped_chain_comes_to_hang() {
    let mut model = chain(Pose::Hang, 8, 0.1, 50.0);
    model.sheet.masses = (0..8).map(|i| 0.01 * f64::from(i + 1)).collect();
    model.sheet.pins = vec![(0, 0)];
    model.gravity = [0.0, 0.0, -G];
    model.drag = 8.0;
    let heights = hanging_chain(&model.sheet.masses, 0.1, 50.0, G);
    assert_near(heights[1], -0.1 - 0.35 * G / 50.0, 1e-15);
    assert!(heights[7] < -0.9, "the load hardly stretches it: {heights:?}");
    let mut state = model.start();
    model.ode().rk4(&mut state, 2e-3, 10_000);
    for (x, z) in state.position.iter().zip(&heights) {
        assert_near(x[2], *z, 1e-12);
    }
    assert!(largest_acceleration(&model, &state) < 1e-9);
}

#[test]
fn a_chain_sags_between_its_pins() {
    let n = 9;
    let (rest, stiffness) = (0.1, 60.0);
    let mut model = chain(Pose::Lay, n, rest, stiffness);
    model.sheet.masses = (0..n).map(|i| 0.02 + 0.01 * (i % 3) as f64).collect();
    model.sheet.pins = vec![(0, 0), (0, n - 1)];
    model.gravity = [0.0, 0.0, -G];
    model.drag = 6.0;
    // Taut, slack and level, slack and uneven: the last pin is moved before the chain is let go.
    for span in [[0.8, 0.0], [0.5, 0.0], [0.45, 0.2], [0.1, -0.3]] {
        let places = chain_between_pins(&model.sheet.masses, rest, 1.0 / stiffness, G, span);
        let mut state = model.start();
        for (i, x) in state.position.iter_mut().enumerate() {
            let part = i as f64 / (n - 1) as f64;
            // Bowed downwards, so that the chain doesn't start as a folded straight line.
            *x = [0.0, part * span[0], part * span[1] - 0.3 * (part * core::f64::consts::PI).sin()];
        }
        model.ode().rk4(&mut state, 4e-3, 10_000);
        for (x, [y, z]) in state.position.iter().zip(&places) {
            assert_near(x[1], *y, 1e-10);
            assert_near(x[2], *z, 1e-10);
        }
    }
}

#[test]
fn an_inextensible_chain_between_pins() {
    // Two links of 1 m and one mass: a triangle. Three links across 2 m: the middle one level, the others at 60°.
    let places = chain_between_pins(&[1.0; 3], 1.0, 0.0, G, [1.2, 0.0]);
    assert_near(places[1][0], 0.6, 1e-12);
    assert_near(places[1][1], -0.8, 1e-12);
    let places = chain_between_pins(&[1.0; 4], 1.0, 0.0, G, [2.0, 0.0]);
    assert_near(places[1][0], 0.5, 1e-12);
    assert_near(places[2][1], -0.75_f64.sqrt(), 1e-12);

    // Many links: the catenary of a rope of 1 m across 0.6 m, whose sag is a·(cosh(0.3/a) - 1), 2a·sinh(0.3/a) = 1.
    let (mut low, mut high) = (0.05, 1.0);
    for _ in 0..100 {
        let a = f64::midpoint(low, high);
        if 2.0 * a * (0.3 / a).sinh() > 1.0 { low = a } else { high = a }
    }
    let sag = low * ((0.3 / low).cosh() - 1.0);
    let error = |links: usize| {
        let places = chain_between_pins(&vec![0.1; links + 1], 1.0 / links as f64, 0.0, G, [0.6, 0.0]);
        (places[links / 2][1] + sag).abs()
    };
    assert!(error(200) < 2e-5, "{}", error(200));
    assert_near(error(100) / error(200), 4.0, 0.1);
}

#[test]
#[should_panic(expected = "no rest")]
fn an_inextensible_chain_that_does_not_reach_has_no_rest() {
    chain_between_pins(&[1.0; 4], 1.0, 0.0, G, [3.5, 0.0]);
}

#[test]
fn pendulum_frequencies_in_their_known_cases() {
    assert_near(pendulum_frequencies(1, 0.4, G)[0], (G / 0.4).sqrt(), 1e-12);
    let two = pendulum_frequencies(2, 1.0, 1.0);
    assert_near(two[0], (2.0 - 2.0_f64.sqrt()).sqrt(), 1e-14);
    assert_near(two[1], (2.0 + 2.0_f64.sqrt()).sqrt(), 1e-14);
    // Roots of L_n: their sum is n² and their product n!.
    let squares: Vec<f64> = pendulum_frequencies(12, 1.0, 1.0).iter().map(|w| w * w).collect();
    assert_near(squares.iter().sum(), 144.0, 1e-10);
    assert_near(squares.iter().product::<f64>() / 479_001_600.0, 1.0, 1e-11);
    // The hanging rope (Bernoulli 1733): half of the first root of the Bessel function J_0.
    let rope = 2.404_825_557_695_773 / 2.0;
    let error = |n: usize| (pendulum_frequencies(n, 1.0 / n as f64, 1.0)[0] / rope - 1.0).abs();
    assert!(error(100) < 3e-3 && error(50) > 1.9 * error(100), "{} and {}", error(50), error(100));
}

#[test]
fn a_hanging_chain_swings_with_laguerres_frequencies() {
    let (n, link, mass, stiffness, amplitude) = (5, 0.2, 0.1, 1e5, 1e-4);
    let mut model = chain(Pose::Hang, n + 1, link, stiffness);
    model.sheet = model.sheet.with_mass(mass).with_pins(&[(0, 0)]);
    model.gravity = [0.0, 0.0, -G];
    let heights = hanging_chain(&model.sheet.masses, link, stiffness, G);
    for omega in pendulum_frequencies(n, link, G) {
        let shape = pendulum_mode(n, link, G, omega);
        let largest = shape.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        assert_near(shape[0], 0.0, 1e-10 * largest);
        assert_eq!(shape[n], 1.0);
        // Displaced from rest by the mode's shape, the chain is back after two periods, and mirrored after one and a half.
        let displaced = |scale: f64| {
            let mut state = model.start();
            for i in 0..=n {
                state.position[i] = [scale * amplitude * shape[i] / largest, 0.0, heights[i]];
            }
            state.position[0][0] = 0.0;
            state
        };
        let period = core::f64::consts::TAU / omega;
        let solution = model.ode().solve(&displaced(1.0), &[1.5 * period, 2.0 * period], 1e-8);
        for (state, sign) in solution.states.iter().zip([-1.0, 1.0]) {
            for (x, expected) in state.position.iter().zip(&displaced(sign).position) {
                assert_near(x[0], expected[0], 0.01 * amplitude);
            }
        }
    }
}

#[test]
fn a_free_chain_vibrates_lengthwise() {
    let (n, rest, stiffness, mass, damping) = (6, 0.5, 30.0, 0.2, 0.15);
    for j in 1..n {
        let mut model = chain(Pose::Lay, n, rest, stiffness);
        model.sheet = model.sheet.with_mass(mass);
        model.families[0].damping = damping;
        let omega_squared = lengthwise_frequency_squared(n, j, stiffness, mass);
        let mut start = model.start();
        let displacement = |i, q: f64| 0.1 * q * lengthwise_mode(n, j, i);
        for i in 0..n {
            start.position[i][1] += displacement(i, 1.0);
        }
        let times = [0.3, 1.1];
        let solution = model.ode().solve(&start, &times, 1e-10);
        for (time, state) in times.into_iter().zip(&solution.states) {
            // Dampers act on relative velocities as springs do on displacements: a mode's damping rate is damping/stiffness·ω².
            let [q, rate] = damped_oscillation(omega_squared, damping / stiffness * omega_squared, time);
            for i in 0..n {
                assert_near(state.position[i][1], rest * i as f64 + displacement(i, q), 1e-10);
                assert_near(state.velocity[i][1], displacement(i, rate), 1e-8);
            }
        }
    }
}

#[test]
fn a_free_sheet_falls_as_a_point() {
    for drag in [0.0, 1e-3, 1.5] {
        let mut model = chain(Pose::Lay, 4, 0.3, 200.0);
        model.gravity = [0.0, 0.0, -G];
        model.drag = drag;
        let mut start = model.start();
        start.velocity.fill([2.0, 0.0, 3.0]);
        let solution = model.ode().solve(&start, &[0.5, 2.0], 1e-12);
        for (time, state) in [0.5, 2.0].into_iter().zip(&solution.states) {
            let ([x, along], [z, up]) = (fall_with_drag(0.0, drag, 2.0, time), fall_with_drag(-G, drag, 3.0, time));
            for i in 0..4 {
                assert_near(state.position[i][0], x, 1e-11);
                assert_near(state.position[i][2], z, 1e-11);
                assert_near(state.velocity[i][0], along, 1e-11);
                assert_near(state.velocity[i][2], up, 1e-11);
            }
        }
    }
    assert_near(fall_with_drag(-G, 1.5, 3.0, 40.0)[1], terminal_velocity(-G, 1.5), 1e-12);
}

#[test]
fn a_flat_sheet_parachutes() {
    // Each particle weighs a third of its triangles: then the air slows all of them alike and the sheet stays flat.
    let (density, air, coefficient) = (0.15, 1.2, 1.28);
    let mut sheet = Sheet::new(Pose::Lay, [4, 3], [0.9, 0.6]);
    sheet.masses.fill(0.0);
    for [p, q, s, t] in sheet.cells() {
        for (corner, triangles) in [(p, 1.0), (q, 2.0), (s, 2.0), (t, 1.0)] {
            sheet.masses[corner] += triangles / 6.0 * density * 0.3 * 0.3;
        }
    }
    let still_air = Wind::Aerodynamic { velocity: [0.0; 3], density: air, drag_coefficient: coefficient };
    let families = vec![Family::new(STRETCH, 100.0)];
    let model = Model { families, gravity: [0.0, 0.0, -G], wind: Some(still_air), ..Model::new(sheet) };
    let terminal = parachute_velocity(G, density, air, coefficient);
    let solution = model.solve(&[0.1, 0.4, 2.0], 1e-11);
    for (time, state) in [0.1, 0.4, 2.0].into_iter().zip(&solution.states) {
        let [fallen, speed] = parachute_fall(G, terminal, time);
        for (x, v) in state.position.iter().zip(&state.velocity) {
            assert_near(x[2], -fallen, 1e-10);
            assert_near(v[2], -speed, 1e-9);
        }
    }
    assert_near(solution.last().velocity[0][2], -terminal, 1e-6 * terminal);
}

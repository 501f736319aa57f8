//! Tests of the reference against which every solver is tested: forces of single cells worked out by hand, the
//! laws of its equation, the convergence of its solution, and the closed forms.

mod closed_forms;
mod convergence;
mod forces;
mod laws;

use rig::reference::vector::{add, norm, scale, sub};
use rig::reference::{BEND, Family, Model, Pose, SHEAR, STRETCH, Sheet, State, Vector, Wind};

/// A sheet that uses every term of the equation.
fn everything() -> Model {
    let sheet = Sheet::new(Pose::Hang, [6, 5], [1.0, 0.8]).with_density(0.3).with_hem(1.5);
    Model {
        families: vec![
            Family::new(STRETCH, 80.0).damped(0.02),
            Family::new(SHEAR, 20.0).damped(0.01),
            Family::new(BEND, 4.0).damped(0.005),
        ],
        gravity: [0.3, -0.2, -9.81],
        drag: 0.4,
        wind: Some(Wind::Aerodynamic { velocity: [1.0, 3.0, 0.5], density: 1.2, drag_coefficient: 1.3 }),
        ..Model::new(sheet.with_pins(&[(0, 0), (5, 0)]))
    }
}

/// The same sheet without pins, gravity, drag, wind and damping.
fn isolated() -> Model {
    let mut model = Model { gravity: [0.0; 3], drag: 0.0, wind: None, ..everything() };
    model.sheet.pins.clear();
    for family in &mut model.families {
        family.damping = 0.0;
    }
    model
}

/// The start with every free particle displaced and moving, without any symmetry.
fn stirred(model: &Model) -> State {
    let mut state = model.start();
    let pins: Vec<usize> = model.sheet.pins.iter().map(|&pin| model.sheet.index(pin)).collect();
    for i in (0..state.position.len()).filter(|i| !pins.contains(i)) {
        let wave = |a: f64, b: f64| (a * i as f64 + b).sin();
        state.position[i] = add(state.position[i], scale(0.02, [wave(1.1, 0.2), wave(2.3, 1.0), wave(3.7, 0.5)]));
        state.velocity[i] = scale(0.5, [wave(0.7, 2.0), wave(1.9, 0.1), wave(2.9, 1.3)]);
    }
    state
}

fn advanced(model: &Model, start: &State, t: f64, steps: usize) -> State {
    let mut state = start.clone();
    model.ode().rk4(&mut state, t / steps as f64, steps);
    state
}

fn acceleration(model: &Model, state: &State) -> Vec<Vector> {
    let mut out = vec![[f64::NAN; 3]; state.position.len()];
    model.ode().acceleration(state, &mut out);
    out
}

fn assert_near(a: Vector, b: Vector, tolerance: f64) {
    assert!(norm(sub(a, b)) <= tolerance, "{a:?} is not within {tolerance} of {b:?}");
}

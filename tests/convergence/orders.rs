//! The order of every solver in time, found by halving its step.

use core::ops::Range;

use rig::reference::{Model, State};
use rig::scenes::{BREEZE, FACETS, PANELS, corners, flag, syrup};
use rig::{Method, Pace, carried, largest_error, moved, tenths};

const FIRST: Range<f64> = 0.85..1.15;
const SECOND: Range<f64> = 1.9..2.2;

/// Every solver, its order, and the fewest substeps in a frame of 0.1 s that show it, because they resolve all vibrations.
const METHODS: [(Method, Range<f64>, u32); 9] = [
    (Method::ForwardEuler, FIRST, 1024),
    (Method::BackwardEuler, FIRST, 256),
    (Method::Leapfrog, SECOND, 32),
    (Method::Verlet(1), FIRST, 128),
    (Method::Verlet(4), FIRST, 64),
    (Method::Xpbd, FIRST, 128),
    (Method::Lines(1), SECOND, 128),
    (Method::Lines(2), SECOND, 128),
    (Method::Lines(4), SECOND, 128),
];

/// Asserts every solver's order over `frames` tenths of a second, by halving its step twice.
fn assert_orders(model: &Model, start: &State, frames: u32) {
    assert_orders_of(&METHODS, model, start, frames);
}

fn assert_orders_of(methods: &[(Method, Range<f64>, u32)], model: &Model, start: &State, frames: u32) {
    let exact = model.ode().solve(start, &tenths(frames), 1e-8);
    for (method, expected, substeps) in methods.iter().cloned() {
        let errors = [substeps, 2 * substeps, 4 * substeps].map(|substeps| {
            let mut motion = moved::<f64, 8, 8>(model, Pace::new(0.1, substeps), method);
            motion.set(start);
            largest_error(model, &exact, 0.1, &mut *motion)
        });
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!(expected.contains(&order), "{method:?}: order {order:.2} from the errors {errors:?}");
        }
    }
}

#[test]
fn hanging_from_two_corners() {
    let model = corners(8);
    assert_orders(&model, &model.start(), 10);
}

#[test]
fn a_flag_in_facet_wind() {
    let model = flag(8, FACETS);
    assert_orders(&model, &model.start(), 5);
}

#[test]
fn a_flag_in_wind_on_panels() {
    let model = flag(8, PANELS);
    assert_orders_of(&[(Method::Leapfrog, SECOND, 32), (Method::Lines(2), SECOND, 128)], &model, &model.start(), 5);
}

#[test]
fn a_flag_in_aerodynamic_wind() {
    let model = flag(8, BREEZE);
    assert_orders(&model, &model.start(), 10);
}

#[test]
fn a_flag_that_its_pins_carry() {
    let model = flag(8, BREEZE);
    assert_orders(&model, &carried(&model, [1.0, -0.5, 0.4]), 10);
}

/// Dampers that are stronger than inertia within a substep. Solvers that treat dampers one by one would need many more substeps.
#[test]
fn strong_dampers() {
    let model = syrup(8);
    let exact = model.ode().solve(&model.start(), &tenths(10), 1e-8);
    // the error that passes over diagonals leave is of third order, and small only where a substep has κ < 0.01
    let second = 1.7..2.2;
    for (method, expected, substeps) in [(Method::Lines(2), &second, 256), (Method::BackwardEuler, &FIRST, 16)] {
        let errors = [1, 2, 4].map(|times| {
            let mut motion = moved::<f64, 8, 8>(&model, Pace::new(0.1, times * substeps), method);
            largest_error(&model, &exact, 0.1, &mut *motion)
        });
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!(expected.contains(&order), "{method:?}: order {order:.2} from the errors {errors:?}");
        }
    }
}

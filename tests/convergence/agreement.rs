//! Distances of solvers from the solution of the equation of motion, for every force, link family and shape of sheet.

use kerchief::{Q24, Scalar};

use rig::reference::Model;
use rig::scenes::{BREEZE, FACETS, chain, corners, curtain, flag, syrup};
use rig::{Method, Pace, largest_error, moved};

/// Asserts that a method stays within `bound` of the sheet's size over 2 s.
fn assert_near<S: Scalar, const W: usize, const H: usize>(model: &Model, method: Method, substeps: u32, bound: f64) {
    let exact = model.solve(&[0.5, 1.0, 1.5, 2.0], 1e-5);
    let mut motion = moved::<S, W, H>(model, Pace::new(0.1, substeps), method);
    let error = largest_error(model, &exact, 0.1, &mut *motion);
    assert!(error < bound, "{method:?} in {} with {substeps} substeps: {error:e}", S::NAME);
}

#[test]
fn leapfrog_of_512_substeps_is_the_solution() {
    assert_near::<f64, 8, 8>(&corners(8), Method::Leapfrog, 512, 2e-4);
    assert_near::<f64, 16, 16>(&corners(16), Method::Leapfrog, 512, 2e-4);
    assert_near::<f64, 8, 8>(&flag(8, FACETS), Method::Leapfrog, 512, 2e-4);
    assert_near::<f64, 8, 8>(&flag(8, BREEZE), Method::Leapfrog, 512, 2e-4);
    assert_near::<f64, 1, 32>(&chain(), Method::Leapfrog, 512, 2e-4);
    assert_near::<f64, 24, 16>(&curtain(None), Method::Leapfrog, 512, 2e-4);
    assert_near::<f64, 24, 16>(&curtain(Some(BREEZE)), Method::Leapfrog, 512, 2e-4);
}

#[test]
fn the_line_solver_is_near_it_in_every_number_type() {
    assert_near::<f64, 16, 16>(&corners(16), Method::Lines(2), 24, 1e-3);
    assert_near::<f32, 16, 16>(&corners(16), Method::Lines(2), 24, 1e-3);
    assert_near::<Q24, 16, 16>(&corners(16), Method::Lines(2), 24, 1e-3);
    assert_near::<f32, 8, 8>(&flag(8, BREEZE), Method::Lines(2), 24, 3e-3);
    assert_near::<Q24, 8, 8>(&flag(8, BREEZE), Method::Lines(2), 24, 3e-3);
}

#[test]
fn the_line_solver_is_near_it_with_strong_dampers() {
    for substeps in [2, 8] {
        assert_near::<f64, 16, 16>(&syrup(16), Method::Lines(2), substeps, 1e-2 / f64::from(substeps));
        assert_near::<f32, 16, 16>(&syrup(16), Method::Lines(2), substeps, 1e-2 / f64::from(substeps));
        assert_near::<Q24, 16, 16>(&syrup(16), Method::Lines(2), substeps, 1e-2 / f64::from(substeps));
    }
}

//! What lessons print is physics: closed forms, and what each page claims.

use std::f64::consts::{LN_2, TAU};

use crate::program::{numbers, run};

/// Asserts that two numbers differ by no more than a part of the second, or of `least`.
#[track_caller]
fn assert_near(found: f64, expected: f64, part: f64, least: f64) {
    assert!((found - expected).abs() <= part * expected.abs().max(least), "{found} instead of {expected}");
}

#[test]
fn a_spring_swings_at_its_frequency() {
    for (arguments, stiffness) in [(&[][..], 40.0), (&["160"], 160.0)] {
        let (text, _) = run("01-spring", arguments);
        let omega = f64::sqrt(stiffness / 0.1);
        for pull in [0.1, 0.2, 0.4] {
            let [period, drift] = numbers(&text, &format!("pulled by {pull} m"))[..] else { panic!("{text}") };
            assert_near(period, TAU / omega, 1e-3, 0.0);
            assert!(drift < 0.1, "{text}");
        }
        // through the pin
        assert_near(numbers(&text, "pulled by 0.6 m")[0], 4.0 * f64::acos(-0.5 / 0.6) / omega, 1e-3, 0.0);
        for pull in [-0.1, 0.1, 0.2] {
            let [energy, slope, solver, _] = numbers(&text, &format!("{pull:.1}"))[..] else { panic!("{text}") };
            assert_near(energy, 0.5 * stiffness * pull * pull, 1e-2, 0.0);
            assert_near(slope, -stiffness * pull, 1e-3, 0.0);
            assert_near(solver, -stiffness * pull, 1e-3, 0.0);
        }
    }
}

#[test]
fn dampers_take_what_the_equation_says() {
    let (text, _) = run("02-damping", &[]);
    for ratio in ["0.05", "0.25", "0.50", "1.00", "2.00"] {
        let [left, exactly, _] = numbers(&text, ratio)[..] else { panic!("{text}") };
        assert_near(left, exactly, 1e-3, 0.01);
    }
    // critical: (1 + wt) exp(-wt)
    assert_near(numbers(&text, "1.00")[0], 6.0 * f64::exp(-5.0), 1e-3, 0.0);
    let motion = |name| {
        let found = numbers(&text, name);
        [found[found.len() - 2], found[found.len() - 1]]
    };
    let ([falls, turns], [damped_falls, damped_turns]) = (motion("no damping"), motion("a damper"));
    assert_near(falls, 9.81, 1e-3, 0.0);
    assert_near(damped_falls, 9.81, 1e-3, 0.0);
    assert_near(turns, 0.5, 0.03, 0.0);
    // of the difference of velocities, on half the mass
    assert_near(damped_turns, 0.5 * f64::exp(-0.4), 0.03, 0.0);
    assert_near(motion("drag of")[0], 9.81 / 2.0 * (1.0 - f64::exp(-2.0)), 1e-2, 0.0);
    // the soonest below 1 % is the one whose overshoot is 1 %
    let settled = |text: &str, ratio: &str| numbers(text, ratio)[2];
    let soonest = settled(&run("02-damping", &["0.83"]).0, "0.83");
    assert!(["0.25", "0.50", "1.00", "2.00"].iter().all(|ratio| settled(&text, ratio) > soonest), "{text}");
}

#[test]
fn steps_grow_and_decay_as_theory_says() {
    let (text, _) = run("03-integrators", &[]);
    for name in ["forward Euler", "backward Euler", "Verlet, relaxed", "leapfrog"] {
        let [energy, theory, operations] = numbers(&text, name)[..] else { panic!("{text}") };
        assert_near(energy, theory, if name == "leapfrog" { 3e-3 } else { 1e-3 }, 0.0);
        assert!(operations > 0.0);
    }
    assert_near(numbers(&text, "leapfrog is stable")[0], 2.0, 2e-3, 0.0);
    assert!(text.contains("differ by less than 1e-9: true"));
    let [beyond, _, _] = numbers(&run("03-integrators", &["2.1"]).0, "leapfrog")[..] else { panic!("{text}") };
    assert!(beyond > 1e6 || beyond.is_nan(), "{beyond}");
    let _ = LN_2;
}

#[test]
fn families_resist_what_they_span() {
    let (text, _) = run("04-sheet", &[]);
    let [stretch, _, bend] = numbers(&text, "longer by 10 %")[..] else { panic!("{text}") };
    assert_near(stretch, 110.0 * 0.5 * 100.0 * 0.01_f64.powi(2), 1e-3, 0.0);
    assert_near(bend, 99.0 * 0.5 * 0.02_f64.powi(2), 1e-2, 0.0);
    let [stretch, shear, bend] = numbers(&text, "skewed by 0.2 rad")[..] else { panic!("{text}") };
    let diagonal = |sign: f64| 0.1 * f64::sqrt(2.0) * (f64::sqrt(1.0 + sign * 0.2_f64.sin()) - 1.0);
    assert_eq!([stretch, bend], [0.0; 2]);
    assert_near(shear, 100.0 * 0.5 * 5.0 * (diagonal(1.0).powi(2) + diagonal(-1.0).powi(2)), 1e-3, 0.0);
    let [stretch, shear, bend] = numbers(&text, "folded upright")[..] else { panic!("{text}") };
    assert_eq!([stretch, shear], [0.0; 2]);
    assert_near(bend, 11.0 * 0.5 * (0.2 - 0.02_f64.sqrt()).powi(2), 1e-2, 0.0);
}

#[test]
fn air_pushes_as_its_models_say() {
    let (text, _) = run("05-wind", &[]);
    for degrees in [0.0_f64, 30.0, 60.0] {
        let across = 5.0 * degrees.to_radians().cos();
        let [facet, _, aerodynamic, _] = numbers(&text, &format!("{degrees} "))[..] else { panic!("{text}") };
        assert_near(facet, 6.0 * across, 1e-2, 0.0);
        assert_near(aerodynamic, 0.72 * across * across, 1e-2, 0.0);
    }
    for name in ["in aerodynamic wind", "in facet wind", "falling in still air", "falling without air"] {
        let [early, early_exact, late, late_exact] = numbers(&text, name)[..] else { panic!("{text}") };
        assert_near(early, early_exact, 0.05, 0.0);
        assert_near(late, late_exact, 0.05, 0.0);
    }
}

#[test]
fn cloth_slides_from_the_angle_of_friction_on() {
    for (arguments, friction) in [(&[][..], 0.5_f64), (&["0.2"], 0.2)] {
        let (text, _) = run("06-ball", arguments);
        let [found, law] = numbers(&text, &format!("friction {friction}: slides"))[..] else { panic!("{text}") };
        assert_near(found, friction.atan().to_degrees(), 5e-3, 0.0);
        assert_near(law, friction.atan().to_degrees(), 1e-3, 0.0);
    }
}

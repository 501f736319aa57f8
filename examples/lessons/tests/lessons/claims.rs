//! The output of lessons agrees with closed forms and with the claims of each page.

use std::f64::consts::TAU;

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
        // the particle passes the pin, where the force jumps and leapfrog loses its order
        assert_near(numbers(&text, "pulled by 0.6 m")[0], 4.0 * f64::acos(-0.5 / 0.6) / omega, 5e-3, 0.0);
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
    // the damper acts on the difference of velocities, with the reduced mass m/2
    assert_near(damped_turns, 0.5 * f64::exp(-0.4), 0.03, 0.0);
    assert_near(motion("drag of")[0], 9.81 / 2.0 * (1.0 - f64::exp(-2.0)), 1e-2, 0.0);
    // the ratio that settles below 1 % first is the one whose overshoot is 1 %
    let settled = |text: &str, ratio: &str| numbers(text, ratio)[2];
    let soonest = settled(&run("02-damping", &["0.83"]).0, "0.83");
    assert!(["0.25", "0.50", "1.00", "2.00"].iter().all(|ratio| settled(&text, ratio) > soonest), "{text}");
}

#[test]
fn steps_grow_and_decay_as_theory_says() {
    for (arguments, step) in [(&[][..], 0.1_f64), (&["0.5"], 0.5), (&["0.0834"], 0.0834)] {
        let (text, _) = run("03-integrators", arguments);
        let growth = (1.0 + step * step).powi(100);
        for (name, expected) in
            [("forward Euler", growth), ("backward Euler", 1.0 / growth), ("Verlet, relaxed", 1.0 / growth)]
        {
            assert_near(numbers(&text, name)[0], expected, 1e-3, 0.1);
        }
        let places = numbers(&text, "step 100 by leapfrog");
        let [by_leapfrog, by_hand] = [places[0], places[places.len() - 1]];
        assert_near(by_leapfrog, by_hand, 1e-5, 0.1);
    }
    let (text, _) = run("03-integrators", &[]);
    assert_near(numbers(&text, "leapfrog ")[0], 1.0, 3e-3, 0.0);
    assert_near(numbers(&text, "leapfrog is stable")[0], 2.0, 2e-3, 0.0);
    let beyond = numbers(&run("03-integrators", &["2.1"]).0, "leapfrog ")[0];
    assert!(beyond > 1e6, "{beyond}");
}

#[test]
fn families_resist_what_they_span() {
    let (text, _) = run("04-sheet", &[]);
    let energies = |name| {
        let found = numbers(&text, name);
        [found[0], found[1], found[2]]
    };
    let [stretch, _, bend] = energies("longer by 10 % ");
    assert_near(stretch, 110.0 * 0.5 * 1000.0 * 0.01_f64.powi(2), 1e-3, 0.0);
    assert_near(bend, 99.0 * 0.5 * 200.0 * 0.02_f64.powi(2), 1e-3, 0.0);
    let [stretch, shear, bend] = energies("skewed by 0.2 rad");
    let diagonal = |sign: f64| 0.1 * f64::sqrt(2.0) * (f64::sqrt(1.0 + sign * 0.2_f64.sin()) - 1.0);
    assert_near(shear, 100.0 * 0.5 * 20.0 * (diagonal(1.0).powi(2) + diagonal(-1.0).powi(2)), 1e-3, 0.0);
    assert!(stretch.abs() + bend.abs() < 1e-4);
    let [stretch, shear, bend] = energies("folded upright");
    assert_near(bend, 11.0 * 0.5 * 200.0 * (0.2 - 0.02_f64.sqrt()).powi(2), 1e-3, 0.0);
    assert!(stretch.abs() + shear.abs() < 1e-4);
    // without shear a sheet that hangs by a corner closes like scissors, and without bend a shelf hangs straight down
    let [closed, open] = ["hung: stretch", "hung: and shear"].map(|name| numbers(&text, name)[1]);
    assert!(closed > 0.99 && open < 0.1, "{text}");
    let [limp, stiff] = ["shelf: both", "shelf: and bend"].map(|name| -numbers(&text, name)[2]);
    assert!((0.499..0.502).contains(&limp) && stiff < 0.45, "{text}");
}

#[test]
fn air_pushes_as_its_models_say() {
    for (arguments, density) in [(&[][..], 1.2), (&["0.3"], 0.3), (&["3.27"], 3.27)] {
        let (text, _) = run("05-wind", arguments);
        let half = 0.5 * density * 1.2;
        for degrees in [0.0_f64, 30.0, 60.0] {
            let across = 2.0 * degrees.to_radians().cos();
            let [facet, _, aerodynamic, _] = numbers(&text, &format!("{degrees} "))[..] else { panic!("{text}") };
            assert_near(facet, 6.0 * across, 1e-3, 0.0);
            assert_near(aerodynamic, half * across * across, 2e-3, 0.0);
        }
        // the sheet is flat at first; when the facet model has bent it, it is no more than a tenth slower
        for (name, late_error) in [
            ("in aerodynamic wind", 0.01),
            ("in facet wind", 0.1),
            ("falling in still air", 0.01),
            ("falling without air", 1e-3),
        ] {
            let [early, early_exact, late, late_exact] = numbers(&text, name)[..] else { panic!("{text}") };
            assert_near(early, early_exact, 0.01, 0.0);
            assert_near(late, late_exact, late_error, 0.0);
        }
        assert!(numbers(&text, "in aerodynamic wind")[2] < 2.0 && numbers(&text, "in facet wind")[2] > 2.0, "{text}");
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

#[test]
fn a_margin_keeps_links_out_of_a_ball() {
    let (text, _) = run("06-ball", &[]);
    let [nearest, middle] = numbers(&text, "0.000")[..] else { panic!("{text}") };
    assert!(nearest.abs() < 1e-3 && middle < -1.0, "{text}");
    let margin = 1e3 * (f64::hypot(0.15, 0.02) - 0.15);
    let [nearest, middle] = numbers(&text, &format!("{margin:.3}"))[..] else { panic!("{text}") };
    assert!((nearest - margin).abs() < 1e-3 && middle > -0.05, "{text}");
    // with enough friction the sheet rests on the ball, without friction it falls
    let height = |friction| numbers(&text, friction)[1];
    assert!(height("0.5 ") > -0.02 && height("0.1 ") < -0.05 && height("0 ") < -0.2, "{text}");
}

#[test]
fn news_travels_two_links_a_sweep() {
    let (text, _) = run("07-super-elasticity", &[]);
    // two colours of links: in each sweep each colour moves one more particle
    assert_eq!(numbers(&text, "particles that have moved")[4..], [3.0, 5.0, 9.0, 17.0]);
    let springs = 100.0 * 31.0 * 31.0 * 0.01 * 9.81 / 1e5;
    let found = |name: &str, place: usize| numbers(&text, name)[place];
    assert_near(found("lines, 1 substep ", 0), springs, 1e-2, 0.0);
    assert!(found("Verlet, 15 sweeps", 0) > 100.0 * springs, "{text}");
    assert!(found("XPBD, 15 substeps", 0) < 0.1 * found("Verlet, 15 sweeps", 0), "{text}");
    assert!(found("... limited to 10 %", 0) <= 10.0 && found("... tethered", 0) < springs, "{text}");
}

#[test]
fn orders_are_what_they_are_called() {
    for (arguments, is_stiff) in [(&[][..], false), (&["500"], true)] {
        let (text, _) = run("08-cost", arguments);
        let [leapfrog, xpbd, verlet, implicit, lines] =
            ["leapfrog", "XPBD", "Verlet, 4 sweeps", "backward Euler", "lines"].map(|name| {
                let found = numbers(&text, name);
                [found[found.len() - 3], found[found.len() - 1]]
            });
        for ([order, _], expected) in [(leapfrog, 2.0), (lines, 2.0), (xpbd, 1.0), (verlet, 1.0), (implicit, 1.0)] {
            assert_near(order, expected, 0.1, 0.0);
        }
        let cheapest = if is_stiff { lines } else { leapfrog };
        for [_, operations] in [leapfrog, xpbd, verlet, implicit, lines] {
            assert!(cheapest[1] <= operations, "{text}");
        }
    }
}

#[test]
fn fixed_point_is_the_same_everywhere() {
    let (text, _) = run("09-fixed-point", &[]);
    let [near, far] = ["at the origin", "100 cells away"].map(|place| {
        ["f32", "Q24"].map(|name| *numbers(&text, &format!("{name} {place}")).last().expect("a distance"))
    });
    assert!(text.contains("here and there: true") && near[1] == far[1], "{text}");
    assert!(near[0] < near[1] && far[0] > 10.0 * far[1], "{text}");
    assert!(numbers(&text, "f32 ")[1] > 100.0 * numbers(&text, "q24 ")[1], "{text}");
}

#[test]
fn digests_are_those_of_the_boards() {
    let (text, _) = run("10-same-bits", &[]);
    let (_, _, digests) = cases::TABLE.iter().find(|row| (row.0, row.1) == ("dragged", "Xpbd")).expect("the case");
    for (name, digest) in ["f32", "f64", "q24", "q13"].into_iter().zip(digests) {
        assert!(text.contains(&format!("{name} {digest:08x}")), "{name} {digest:08x} in\n{text}");
    }
    assert_ne!(numbers(&text, "(a + b) + c =")[0], *numbers(&text, "(a + b) + c =").last().expect("the other sum"));
    assert!(text.contains("the same bits in both layouts: true"));
    let apart = numbers(&text, "two flags a last place apart");
    assert!(apart[2] > 1e-2, "{text}");
}

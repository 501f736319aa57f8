//! Conservation laws, dissipation and symmetry of the equation of motion.

use super::{acceleration, advanced, assert_near, everything, isolated, stirred};
use rig::reference::vector::{add, norm, scale, sub};
use rig::reference::{Model, Pose, Sheet, Wind};

#[test]
fn energy_stays_without_damping() {
    let mut model = isolated();
    model.gravity = [0.3, -0.2, -9.81];
    model.sheet.pins.push((0, 0));
    let (ode, start) = (model.ode(), stirred(&model));
    let energy = ode.energy(&start);
    let drift = |steps| (ode.energy(&advanced(&model, &start, 1.0, steps)) - energy).abs() / energy.abs();
    let drifts = [drift(8000), drift(16_000)];
    assert!(drifts[1] < 1e-8, "relative changes of energy {drifts:?}");
    // The remaining drift is that of RK4, of order 5: it damps an oscillation by (ω·h)⁶/144 a step.
    assert!((25.0..40.0).contains(&(drifts[0] / drifts[1])), "{drifts:?}");
}

#[test]
fn each_kind_of_damping_takes_energy() {
    for dampen in [
        (|model| model.drag = 0.3) as fn(&mut Model),
        |model| model.families[0].damping = 0.01,
        |model| model.wind = Some(Wind::Aerodynamic { velocity: [0.0; 3], density: 1.2, drag_coefficient: 1.0 }),
    ] {
        let mut model = isolated();
        dampen(&mut model);
        let (ode, mut state) = (model.ode(), stirred(&model));
        let mut energy = ode.energy(&state);
        for _ in 0..20 {
            ode.rk4(&mut state, 1e-3, 50);
            let now = ode.energy(&state);
            assert!(now < energy, "{now} J after {energy} J");
            energy = now;
        }
    }
}

#[test]
fn momentum_stays_without_outer_forces() {
    let mut model = isolated();
    let (ode, start) = (model.ode(), stirred(&model));
    let end = advanced(&model, &start, 1.0, 4000);
    assert_near(ode.momentum(&end), ode.momentum(&start), 1e-13);
    assert_near(ode.angular_momentum(&end), ode.angular_momentum(&start), 1e-9);

    // Link damping acts between pairs, but not along their line: it conserves momentum, not angular momentum.
    model.families[0].damping = 0.02;
    let ode = model.ode();
    let end = advanced(&model, &start, 1.0, 4000);
    assert_near(ode.momentum(&end), ode.momentum(&start), 1e-13);
    assert!(norm(sub(ode.angular_momentum(&end), ode.angular_momentum(&start))) > 1e-6);
}

#[test]
fn gravity_alone_gives_the_whole_mass_its_momentum() {
    let mut model = isolated();
    model.gravity = [0.3, -0.2, -9.81];
    let start = stirred(&model);
    let ode = model.ode();
    let mass: f64 = model.sheet.masses.iter().sum();
    let gained = sub(ode.momentum(&advanced(&model, &start, 0.7, 3000)), ode.momentum(&start));
    assert_near(gained, scale(0.7 * mass, model.gravity), 1e-12);
}

#[test]
fn a_sheet_without_outer_forces_rests() {
    let model = isolated();
    for a in acceleration(&model, &model.start()) {
        assert_near(a, [0.0; 3], 1e-11);
    }
}

#[test]
fn pins_hold_or_keep_the_velocity_they_were_given() {
    let model = everything();
    let mut start = model.start();
    start.velocity[5] = [0.1, 0.2, 0.3];
    let end = advanced(&model, &start, 0.5, 1000);
    assert_eq!(end.position[0], start.position[0]);
    assert_near(end.position[5], add(start.position[5], scale(0.5, start.velocity[5])), 1e-11);
    assert!(norm(sub(end.position[14], start.position[14])) > 0.01, "free particles do not move");
}

#[test]
fn a_mirrored_scene_has_the_mirrored_solution() {
    // Left and right, without wind: its triangles cut every cell along the same diagonal, which breaks this symmetry.
    let model = Model { wind: None, gravity: [0.0, -3.0, -9.81], ..everything() };
    let end = advanced(&model, &model.start(), 0.8, 2000);
    for row in 0..5 {
        for column in 0..6 {
            let [x, y, z] = end.position[model.sheet.index((column, row))];
            let mirrored = end.position[model.sheet.index((5 - column, row))];
            assert_near(mirrored, [1.0 - x, y, z], 1e-12);
        }
    }
}

#[test]
fn wind_keeps_the_mirror_along_the_diagonal() {
    // Exchanging rows and columns exchanges the triangles' corners q and s, and nothing else.
    let velocity = [1.0, 1.0, 2.0];
    for wind in [Wind::Facet(velocity), Wind::Aerodynamic { velocity, density: 1.2, drag_coefficient: 1.3 }] {
        let sheet = Sheet::new(Pose::Lay, [5, 5], [1.0, 1.0]).with_mass(0.02).with_pins(&[(0, 0), (4, 0), (0, 4)]);
        let model = Model { wind: Some(wind), sheet, gravity: [0.0, 0.0, -9.81], ..everything() };
        let end = advanced(&model, &model.start(), 0.8, 2000);
        for row in 0..5 {
            for column in 0..5 {
                let [x, y, z] = end.position[model.sheet.index((column, row))];
                assert_near(end.position[model.sheet.index((row, column))], [y, x, z], 1e-12);
            }
        }
    }
}

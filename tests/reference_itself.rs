//! The reference that every solver is tested against, tested itself: the laws its equation obeys, the forces of
//! single cells worked out by hand, and the convergence of its solution. Closed forms: `reference_closed_forms.rs`.

mod reference;

use reference::vector::{add, dot, norm, scale, sub};
use reference::{BEND, Family, Model, Pose, SHEAR, STRETCH, Sheet, State, Vector, Wind, rms_distance};

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

/// The same without pins or anything that takes or gives energy.
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
fn energy_stays_without_damping() {
    let mut model = isolated();
    model.gravity = [0.3, -0.2, -9.81];
    model.sheet.pins.push((0, 0));
    let (ode, start) = (model.ode(), stirred(&model));
    let energy = ode.energy(&start);
    let drift = |steps| (ode.energy(&advanced(&model, &start, 1.0, steps)) - energy).abs() / energy.abs();
    let drifts = [drift(8000), drift(16_000)];
    assert!(drifts[1] < 1e-8, "energy changed by {drifts:?} of itself");
    // What remains is the method's: of order 5, since RK4 damps an oscillation by (ω·h)⁶/144 a step.
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

    // Link damping acts between pairs, but not along their line: it keeps momentum, not angular momentum.
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
fn pins_hold_or_keep_the_velocity_they_were_given() {
    let model = everything();
    let mut start = model.start();
    start.velocity[5] = [0.1, 0.2, 0.3];
    let end = advanced(&model, &start, 0.5, 1000);
    assert_eq!(end.position[0], start.position[0]);
    assert_near(end.position[5], add(start.position[5], scale(0.5, start.velocity[5])), 1e-11);
    assert!(norm(sub(end.position[14], start.position[14])) > 0.01, "the rest moves");
}

#[test]
fn a_sheet_without_outer_forces_rests() {
    let model = isolated();
    for a in acceleration(&model, &model.start()) {
        assert_near(a, [0.0; 3], 1e-11);
    }
}

#[test]
fn density_spreads_the_mass_of_the_area() {
    let sheet = Sheet::new(Pose::Lay, [4, 3], [3.0, 4.0]).with_density(0.5);
    assert_near([sheet.masses.iter().sum(), 0.0, 0.0], [6.0, 0.0, 0.0], 1e-14);
    let share = |column, row| sheet.masses[sheet.index((column, row))];
    // A cell of 2 m² weighs 1 kg: a corner has a quarter of it, an edge two, the inside four.
    assert_eq!([share(0, 0), share(1, 0), share(3, 1), share(1, 1)], [0.25, 0.5, 0.5, 1.0]);
    let hemmed = sheet.clone().with_hem(2.0);
    assert_eq!(hemmed.masses[0], 0.5);
    assert_eq!(hemmed.masses[hemmed.index((2, 1))], 1.0);
}

#[test]
fn poses_are_the_models() {
    let lay = Sheet::new(Pose::Lay, [3, 2], [2.0, 5.0]).with_origin([1.0, 2.0, 3.0]).positions();
    assert_eq!(lay[..2], [[1.0, 2.0, 3.0], [2.0, 2.0, 3.0]]);
    assert_eq!(lay[5], [3.0, 7.0, 3.0]);
    let hang = Sheet::new(Pose::Hang, [3, 2], [2.0, 5.0]).positions();
    assert_eq!(hang[5], [2.0, 0.0, -5.0]);
    let chain = Sheet::new(Pose::Hang, [1, 3], [7.0, 4.0]);
    assert_eq!(chain.positions(), [[0.0, 0.0, 0.0], [0.0, 0.0, -2.0], [0.0, 0.0, -4.0]]);
    assert_eq!(chain.size(), 4.0);
}

#[test]
fn a_stretched_link_pulls_by_hand() {
    // Two particles 3 m apart whose link of 2 m has k = 5 N/m: 5 N; they part with 4 m/s across it: 0.5·4 N.
    let mut model = Model::new(Sheet::new(Pose::Lay, [2, 1], [2.0, 0.0]));
    model.sheet.masses = vec![1.0, 4.0];
    model.families.push(Family::new(STRETCH, 5.0).damped(0.5));
    let mut state = model.start();
    state.position[1][0] = 3.0;
    state.velocity[1][1] = 4.0;
    assert_eq!(acceleration(&model, &state), [[5.0, 2.0, 0.0], [-1.25, -0.5, 0.0]]);
}

#[test]
fn every_family_has_its_links() {
    // All distances doubled, a link of rest length L pulls with k·L: the corner of a 3×3 grid of cells 1×1.
    let pull = |offsets| {
        let mut model = Model::new(Sheet::new(Pose::Lay, [3, 3], [2.0, 2.0]));
        model.families.push(Family::new(offsets, 1.0));
        let mut state = model.start();
        state.position.iter_mut().for_each(|x| *x = scale(2.0, *x));
        acceleration(&model, &state)
    };
    let close = |a: &[Vector], b: [[f64; 2]; 3]| {
        // Corner (0, 0), the middle of the first row, and the particle at its end.
        a.iter().zip(b).for_each(|(&a, [x, y])| assert_near(a, [x, y, 0.0], 1e-15));
    };
    close(&pull(STRETCH), [[1.0, 1.0], [0.0, 1.0], [-1.0, 1.0]]);
    close(&pull(SHEAR), [[1.0, 1.0], [0.0, 2.0], [-1.0, 1.0]]);
    close(&pull(BEND), [[2.0, 2.0], [0.0, 2.0], [-2.0, 2.0]]);
}

/// One cell of 2 m × 3 m in the x-y plane, in the wind.
fn cell(wind: Wind) -> Model {
    Model { wind: Some(wind), ..Model::new(Sheet::new(Pose::Lay, [2, 2], [2.0, 3.0])) }
}

#[test]
fn facet_wind_on_a_cell_by_hand() {
    // Both triangles have n = ±(0, 0, 6): n·(n/|n| · wind) = 6·wind_z ẑ on each of their corners, whichever way
    // round they are listed. p and t belong to one triangle, q and s to both.
    let model = cell(Wind::Facet([7.0, 5.0, -0.5]));
    let a = acceleration(&model, &model.start());
    assert_eq!(a, [[0.0, 0.0, -3.0], [0.0, 0.0, -6.0], [0.0, 0.0, -6.0], [0.0, 0.0, -3.0]]);

    // Upright, it catches the wind's y instead.
    let mut upright = model.clone();
    upright.sheet.pose = Pose::Hang;
    assert_eq!(acceleration(&upright, &upright.start())[1], [0.0, 60.0, 0.0]);

    // With t lifted by 2 m: (q - t)×(s - t) = (0, -3, -2)×(-2, 0, -2) = (6, 4, -6), |n|² = 88.
    let mut lifted = model.start();
    lifted.position[3][2] = 2.0;
    let n = [6.0, 4.0, -6.0];
    let across = dot(n, [7.0, 5.0, -0.5]) / 88.0_f64.sqrt();
    let a = acceleration(&model, &lifted);
    assert_near(a[3], scale(across, n), 1e-13);
    assert_near(a[0], [0.0, 0.0, -3.0], 1e-14);
    assert_near(a[1], add(a[0], a[3]), 1e-13);
}

#[test]
fn aerodynamic_wind_on_a_cell_by_hand() {
    // Relative wind 2 m/s up; a triangle of 3 m²: ½·1.2·0.5·3·2² = 3.6 N, a third of it on each corner.
    let model = cell(Wind::Aerodynamic { velocity: [9.0, 0.0, 3.0], density: 1.2, drag_coefficient: 0.5 });
    let mut state = model.start();
    state.velocity.fill([-4.0, 1.0, 1.0]);
    let a = acceleration(&model, &state);
    for (a, expected) in a.iter().zip([1.2, 2.4, 2.4, 1.2]) {
        assert_near(*a, [0.0, 0.0, expected], 1e-14);
    }
    // Faster than the wind by the same, it is held back by the same; a triangle counts its corners' mean.
    state.velocity.fill([0.0, 0.0, 5.0]);
    assert_near(acceleration(&model, &state)[1], [0.0, 0.0, -2.4], 1e-14);
    state.velocity = vec![[0.0, 0.0, 3.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 0.0]];
    assert_near(acceleration(&model, &state)[0], [0.0, 0.0, 1.2], 1e-14);
    assert_near(acceleration(&model, &state)[3], [0.0, 0.0, 2.7], 1e-14);
}

#[test]
fn a_mirrored_scene_has_the_mirrored_solution() {
    // Left and right, without wind: its triangles cut every cell the same way and tell the sides apart.
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

#[test]
fn the_stable_step_is_stable() {
    // |R(s·h)| ≤ 1 on the half disc that `stable_step` relies on, R the Taylor polynomial of degree 4 of exp.
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
    // A sheet at rest quivers for many steps of that length without growing, and not of twice that length.
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
        assert!(error <= solution.difference / 8.0, "{error} at {time} s, {} was seen", solution.difference);
        assert!(error <= 1.5 * solution.error(), "{error} at {time} s, {} was estimated", solution.error());
    }
}

#[test]
fn the_thesis_sheet_is_solved() {
    // Its stiff links and its damping, on two corners; the 32×32 sheets are tested on the release build.
    let n = 12;
    let sheet = Sheet::new(Pose::Lay, [n, n], [10.0, 10.0]).with_pins(&[(0, 0), (n - 1, 0)]);
    let families = vec![Family::new(STRETCH, 942_700.0), Family::new(SHEAR, 9427.0), Family::new(BEND, 942.7)];
    let drag = reference::drag_of_verlet_damping(0.1, 0.1);
    assert!((drag - 1.0536).abs() < 1e-4);
    let model = Model { families, gravity: [0.0, 0.0, -9.81], drag, ..Model::new(sheet) };
    let solution = model.solve(&[0.5, 1.0, 1.5, 2.0], 1e-5);
    assert!(solution.error() < 1e-5);
    let lowest = solution.last().position.iter().fold(0.0, |z: f64, x| z.min(x[2]));
    assert!((-14.5..-5.0).contains(&lowest), "the far edge swings down, to {lowest} m");
}

#[test]
#[should_panic(expected = "did not converge")]
fn a_tolerance_below_round_off_is_refused() {
    everything().solve(&[0.05], 1e-18);
}

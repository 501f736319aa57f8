//! Colliders: particles stay outside their margins, and friction is Coulomb's.

use kerchief::units::Length;
use kerchief::{
    Capsule, Cloth, Collider, Gravity, Leapfrog, Lines, Plane, Q13, Q24, Scalar, Scene, Solver, Sphere, Stretch, Units,
    Vec3, Verlet, Xpbd, measure,
};

use rig::reference::{Model, Pose, Sheet};
use rig::scenes::{GRAVITY, springs};
use rig::{Pace, Rig};

fn free(gravity: [f64; 3]) -> Model {
    let sheet = Sheet::new(Pose::Lay, [8, 8], [1.0, 1.0]).with_mass(0.01).with_origin([-0.5, -0.5, 0.0]);
    Model { families: springs(200.0, 10.0, 1.0), gravity, drag: 0.2, ..Model::new(sheet) }
}

/// Lets a sheet fall on a collider and asserts after every frame that no particle is nearer than `reach`.
fn assert_kept<S: Scalar, V: Solver<S>, C: Collider<S>>(
    solver: V,
    collider: impl FnOnce(&Units) -> C,
    reach: f64,
    distance: impl Fn([f64; 3]) -> f64,
) {
    let mut rig = Rig::<S, _, 8, 8>::new(&free(GRAVITY), Pace::new(0.02, 8), solver).with_colliders(collider);
    let mut touched = false;
    for _ in 0..60 {
        rig.step();
        for position in rig.state().position {
            let gap = distance(position) - reach;
            assert!(gap > -4e-7, "{} m too near in {}", -gap, S::NAME);
            touched |= gap < 1e-3;
        }
    }
    assert!(touched, "the sheet never came near");
}

#[test]
fn no_particle_comes_nearer_than_the_margin() {
    fn check<S: Scalar>() {
        let (centre, end) = ([0.0, 0.0, -0.5], [0.4, 0.0, -0.5]);
        let length = |x: [f64; 3], from: [f64; 3]| (0..3).map(|k| (x[k] - from[k]).powi(2)).sum::<f64>().sqrt();
        let sphere = |units: &Units| Sphere::<S>::new(units.point(centre), units.length(0.3), units.length(0.02));
        assert_kept::<S, _, _>(Lines::default(), sphere, 0.32, |x| length(x, centre));
        assert_kept::<S, _, _>(Xpbd, |units| sphere(units).with_friction(0.5), 0.32, |x| length(x, centre));
        let capsule = |units: &Units| {
            Capsule::<S>::new(units.point(centre), units.point(end), units.length(0.1), units.length(0.02))
        };
        let rod = |x: [f64; 3]| length(x, [x[0].clamp(centre[0], end[0]), centre[1], centre[2]]);
        assert_kept::<S, _, _>(Verlet { sweeps: 4 }, capsule, 0.12, rod);
        let plane = |units: &Units| {
            let up = Vec3::new(S::ZERO, S::ZERO, S::ONE);
            Plane::<S>::new(units.point([0.0, 0.0, -0.2]), up, units.length(0.01))
        };
        assert_kept::<S, _, _>(Lines::default(), plane, 0.01, |x| x[2] + 0.2);
    }
    check::<f32>();
    check::<f64>();
    check::<Q24>();
}

/// `Some(collider)` acts as the collider and `None` as no collider. A coefficient of friction does not decide the number type.
#[test]
fn a_collider_that_is_there_or_not() {
    const UNITS: Units = Units::sheet([6, 6], [0.3, 0.3], 1e-3, 0.02, 4);
    fn end<C: Collider<Q24>>(colliders: C) -> u32 {
        let mut cloth = Cloth::<Q24, 6, 6>::lay(&UNITS, UNITS.point([-0.15, -0.15, 0.0]));
        let gravity = Gravity::new(UNITS.acceleration([0.5, 0.0, -9.81]));
        let mut scene = Scene::new(&UNITS, gravity, Stretch::new(&UNITS, UNITS.stiffness(50.0)), colliders, Xpbd);
        for _ in 0..30 {
            scene.step_one(&mut cloth, &mut scene.memory());
            scene.advance::<Q24>();
        }
        measure::digest(&cloth)
    }
    let ball = Sphere::new(UNITS.point([0.0, 0.0, -0.2]), UNITS.length(0.1), UNITS.length(0.02)).with_friction(0.3);
    let ball = ball.with_velocity(UNITS.velocity([0.05, 0.0, 0.0]));
    assert_eq!(end(Some(ball)), end(ball));
    assert_eq!(end(None::<Sphere<Q24>>), end(()));
    assert_eq!(end((Some(ball), None::<Plane<Q24>>)), end(ball));
    assert_ne!(end(ball), end(()));
}

/// How far a sheet on a slope slides in 0.5 s, m. The plane is level and gravity is tilted instead.
fn slid<S: Scalar, V: Solver<S>>(solver: V, substeps: u32, slope: f64, friction: f64) -> f64 {
    let gravity = [9.81 * slope.sin(), 0.0, -9.81 * slope.cos()];
    let model = Model { drag: 0.0, ..free(gravity) };
    let plane = |units: &Units| {
        let up = Vec3::new(S::ZERO, S::ZERO, S::ONE);
        Plane::<S>::new(units.point([0.0; 3]), up, Length(0.0)).with_friction(friction)
    };
    let mut rig = Rig::<S, _, 8, 8>::new(&model, Pace::new(0.02, substeps), solver).with_colliders(plane);
    rig.run(25);
    rig.state().position[0][0] + 0.5
}

/// Asserts that sheets slide within `error` of Coulomb's law, or stick within `creep` (m).
fn assert_slides<S: Scalar, V: Solver<S> + Copy>(solver: V, substeps: u32, error: f64, creep: f64) {
    for (slope, friction) in [(0.3_f64, 0.1), (0.6, 0.5), (0.5, 0.0)] {
        let acceleration = 9.81 * (slope.sin() - friction * slope.cos());
        let expected = 0.5 * acceleration * 0.25;
        let found = slid::<S, V>(solver, substeps, slope, friction);
        let bound = error * expected.max(0.1);
        assert!((found - expected).abs() < bound, "{found} instead of {expected}, {substeps} substeps in {}", S::NAME);
    }
    for friction in [0.32, 1.0] {
        let found = slid::<S, V>(solver, substeps, 0.3, friction);
        assert!(found.abs() < creep, "{found} m where tan(slope) < friction, {substeps} substeps in {}", S::NAME);
    }
}

#[test]
fn a_sheet_slides_down_a_slope_as_coulomb_says() {
    // XPBD is of first order: its error is h·t·a/2
    assert_slides::<f64, _>(Xpbd, 32, 3e-3, 1e-12);
    for substeps in [1, 8, 32] {
        assert_slides::<f64, _>(Lines::default(), substeps, 1e-6, 1e-12);
        assert_slides::<f32, _>(Lines::default(), substeps, 1e-3, 1e-6);
        assert_slides::<Q24, _>(Lines::default(), substeps, 1e-2, 1e-6);
    }
}

#[test]
fn a_coefficient_of_friction_of_a_hundred_holds() {
    for (slope, substeps) in [(0.3, 1), (1.2, 1), (1.2, 8)] {
        for found in [
            slid::<Q24, _>(Lines::default(), substeps, slope, 100.0),
            slid::<Q13, _>(Lines::default(), substeps, slope, 100.0),
            slid::<Q24, _>(Xpbd, substeps, slope, 100.0),
        ] {
            assert!(found.abs() < 1e-6, "{found} m on a slope of {slope}, {substeps} substeps");
        }
    }
}

/// How high a sheet rebounds after a fall of half a metre, m. The ground's height varies, and with it the moment of impact within a substep.
fn thrown_back<S: Scalar, V: Solver<S> + Copy>(solver: V, substeps: u32) -> f64 {
    let mut highest = 0.0_f64;
    for step in 0..12 {
        let ground = -0.5 - 0.002 * f64::from(step);
        let plane = |units: &Units| {
            let up = Vec3::new(S::ZERO, S::ZERO, S::ONE);
            Plane::<S>::new(units.point([0.0, 0.0, ground]), up, Length(0.0))
        };
        let mut rig = Rig::<S, _, 8, 8>::new(&free(GRAVITY), Pace::new(0.02, substeps), solver).with_colliders(plane);
        rig.run(20);
        for _ in 0..30 {
            rig.step();
            highest = rig.state().position.iter().map(|x| x[2] - ground).fold(highest, f64::max);
        }
    }
    highest
}

#[test]
fn the_ground_throws_nothing_back() {
    fn check<S: Scalar>() {
        for substeps in [1, 8, 64] {
            let found = [thrown_back::<S, _>(Lines::default(), substeps), thrown_back::<S, _>(Xpbd, substeps)];
            assert!(
                found.into_iter().all(|height| height < 1e-6),
                "rebounds by {found:?} m with {substeps} substeps in {}",
                S::NAME
            );
        }
    }
    check::<f32>();
    check::<f64>();
    check::<Q24>();
    check::<Q13>();
}

/// Positions of a sheet that has fallen on a rod, after 0.6 s, m.
fn on_a_rod<V: Solver<f64>>(solver: V, substeps: u32) -> Vec<[f64; 3]> {
    let rod = |units: &Units| {
        let ends = [[-0.6, 0.1, -0.3], [0.7, 0.0, -0.25]].map(|end| units.point(end));
        Capsule::new(ends[0], ends[1], units.length(0.15), units.length(0.02)).with_friction(0.3)
    };
    let model = Model { drag: 1.0, ..free(GRAVITY) };
    let mut rig = Rig::<f64, _, 8, 8>::new(&model, Pace::new(0.02, substeps), solver).with_colliders(rod);
    rig.run(30);
    rig.state().position
}

#[test]
fn contacts_converge() {
    let exact = on_a_rod(Leapfrog, 2048);
    let errors = [16, 64, 256].map(|substeps| {
        let found = on_a_rod(Lines::default(), substeps);
        let apart = found.iter().flatten().zip(exact.iter().flatten()).map(|(a, b)| (a - b).powi(2));
        (apart.sum::<f64>() / 64.0).sqrt()
    });
    println!("{errors:?}");
    assert!(errors[0] < 3e-3 && errors[1] < 0.5 * errors[0] && errors[2] < 0.5 * errors[1], "{errors:?}");
}

fn assert_taken_along<V: Solver<f64>>(solver: V) {
    let mut rig = Rig::<f64, _, 8, 8>::new(&free([0.0; 3]), Pace::new(0.02, 8), solver).with_colliders(|units| {
        Sphere::new(units.point([0.0, 0.0, -0.4]), units.length(0.3), units.length(0.02))
            .with_velocity(units.velocity([0.0, 0.0, 1.0]))
    });
    for frame in 1..=50 {
        rig.step();
        let height = -0.4 + f64::from(frame) * 0.02;
        let centre = rig.scene.colliders.centre.to_f64()[2] * rig.units.cell;
        assert!((centre - height).abs() < 1e-12, "the ball is at {centre} instead of {height}");
        for x in rig.state().position {
            assert!((x[0] * x[0] + x[1] * x[1] + (x[2] - height).powi(2)).sqrt() > 0.32 - 1e-9);
        }
    }
    let lifted = rig.state().position.iter().map(|x| x[2]).fold(f64::MAX, f64::min);
    assert!(lifted > 0.3, "the lowest particle is at {lifted} m");
}

#[test]
fn a_ball_that_moves_takes_the_sheet_along() {
    assert_taken_along(Xpbd);
    assert_taken_along(Lines::default());
}

//! Colliders: margins are kept, friction is Coulomb's.

use kerchief::units::Length;
use kerchief::{Capsule, Collider, Lines, Plane, Q24, Scalar, Solver, Sphere, Units, Vec3, Verlet, Xpbd};

use crate::reference::{Model, Pose, Sheet};
use crate::rig::scenes::{GRAVITY, springs};
use crate::rig::{Pace, Rig};

fn free(gravity: [f64; 3]) -> Model {
    let sheet = Sheet::new(Pose::Lay, [8, 8], [1.0, 1.0]).with_mass(0.01).with_origin([-0.5, -0.5, 0.0]);
    Model { families: springs(200.0, 10.0, 1.0), gravity, drag: 0.2, ..Model::new(sheet) }
}

/// Lets a sheet fall on a collider and asserts after every frame that no particle is nearer to it than `reach`.
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
        assert_kept::<S, _, _>(Lines::new(), sphere, 0.32, |x| length(x, centre));
        assert_kept::<S, _, _>(Xpbd, |units| sphere(units).with_friction(S::HALF), 0.32, |x| length(x, centre));
        let capsule = |units: &Units| {
            Capsule::<S>::new(units.point(centre), units.point(end), units.length(0.1), units.length(0.02))
        };
        let rod = |x: [f64; 3]| length(x, [x[0].clamp(centre[0], end[0]), centre[1], centre[2]]);
        assert_kept::<S, _, _>(Verlet { sweeps: 4 }, capsule, 0.12, rod);
        let plane = |units: &Units| {
            let up = Vec3::new(S::ZERO, S::ZERO, S::ONE);
            Plane::<S>::new(units.point([0.0, 0.0, -0.2]), up, units.length(0.01))
        };
        assert_kept::<S, _, _>(Lines::new(), plane, 0.01, |x| x[2] + 0.2);
    }
    check::<f32>();
    check::<f64>();
    check::<Q24>();
}

/// How far a sheet on a slope has slid after 0.5 s, m: the plane is level and gravity tilts.
fn slid(slope: f64, friction: f64) -> f64 {
    let gravity = [9.81 * slope.sin(), 0.0, -9.81 * slope.cos()];
    let model = Model { drag: 0.0, ..free(gravity) };
    let plane = |units: &Units| {
        let up = Vec3::new(0.0, 0.0, 1.0);
        Plane::<f64>::new(units.point([0.0; 3]), up, Length(0.0)).with_friction(friction)
    };
    let mut rig = Rig::<f64, _, 8, 8>::new(&model, Pace::new(0.02, 32), Xpbd).with_colliders(plane);
    rig.run(25);
    rig.state().position[0][0] + 0.5
}

#[test]
fn a_sheet_slides_down_a_slope_as_coulomb_says() {
    for (slope, friction) in [(0.3_f64, 0.1), (0.6, 0.5), (0.5, 0.0)] {
        let acceleration = 9.81 * (slope.sin() - friction * slope.cos());
        let expected = 0.5 * acceleration * 0.25;
        let found = slid(slope, friction);
        // first order: h·t·a/2
        assert!((found - expected).abs() < 3e-3 * expected.max(0.1), "{found} instead of {expected}");
    }
    assert!(slid(0.3, 0.32).abs() < 1e-12, "held where tan(slope) < friction");
}

#[test]
fn a_ball_that_moves_takes_the_sheet_along() {
    let mut rig = Rig::<f64, _, 8, 8>::new(&free([0.0; 3]), Pace::new(0.02, 8), Xpbd).with_colliders(|units| {
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

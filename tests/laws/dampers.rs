//! Two particles and a damper of any strength.

use kerchief::{
    BackwardEuler, Cloth, Damped, Lines, Node, Q13, Q24, Scalar, Scene, Solver, Stretch, Units, Vec3, Verlet, Xpbd,
};

const UNITS: Units = Units::sheet([1, 2], [0.0, 0.1], 1e-3, 0.1, 1);

/// The relative velocity of two particles after a substep, over that before it. The spring between them is negligible.
fn left<S: Scalar, V: Solver<S>>(solver: V, kappa: f64) -> f64 {
    let mut cloth = Cloth::<S, 1, 2>::hang(&UNITS, UNITS.point([0.0; 3]));
    let speed = Vec3::from_f64([0.25, 0.0, 0.0]);
    cloth.velocity.set(Node::new(0, 0), speed);
    cloth.velocity.set(Node::new(0, 1), -speed);
    let spring = Stretch::new(&UNITS, UNITS.stiffness(1e-5));
    let scene = Scene::new(&UNITS, (), Damped::new(spring, UNITS.damping(kappa * 1e-3 / 0.1)), (), solver);
    let mut memory = scene.memory();
    scene.step(&mut cloth, &mut memory);
    (cloth.velocity.at(Node::new(0, 0)) - cloth.velocity.at(Node::new(0, 1))).to_f64()[0] / 0.5
}

/// Implicit dampers leave 1/(1 + 2·κ).
#[test]
fn a_damper_takes_what_it_must() {
    fn check<S: Scalar>(error: f64) {
        for kappa in [0.01, 0.1, 1.0, 5.0, 30.0] {
            for (name, found) in [
                ("lines", left::<S, _>(Lines::default(), kappa)),
                ("xpbd", left::<S, _>(Xpbd, kappa)),
                ("verlet", left::<S, _>(Verlet { sweeps: 2 }, kappa)),
                ("backward Euler", left::<S, _>(BackwardEuler { newton_steps: 3 }, kappa)),
            ] {
                let expected = 1.0 / (1.0 + 2.0 * kappa);
                assert!(
                    (found - expected).abs() < error * expected.max(0.1),
                    "κ = {kappa}, {name} in {}: {found} instead of {expected}",
                    S::NAME
                );
            }
        }
    }
    check::<f64>(2e-3);
    check::<f32>(2e-3);
    check::<Q24>(2e-3);
    check::<Q13>(2e-3);
}

//! Springs, gravity or drag may change while a sheet moves. That changes the forces only: no solver may jolt the sheet because its memory stems from the old forces.

use kerchief::{BackwardEuler, Leapfrog, Lines, Node, Q13, Q24, Scalar, Sheet, Solver, Verlet, Xpbd};

const N: usize = 8;

/// How springs, gravity and drag change while a sheet swings.
#[derive(Clone, Copy, Debug)]
enum Change {
    Nothing,
    Stiffer,
    Softer,
    Tilted,
    Thicker,
}

/// The largest velocity change of a particle in one frame, from the change on, over the velocity that gravity adds in a frame.
fn jump<S: Scalar, V: Solver<S>>(change: Change, solver: V) -> f64 {
    let sheet = Sheet::<S, N, N>::new([0.3, 0.3], 1e-3, 1.0 / 60.0, 16);
    let mut cloth = sheet.hang([0.0, 0.0, 0.3]);
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(N - 1, 0));
    let springs = |part: f64| (sheet.stretch(200.0 * part), sheet.shear(10.0 * part), sheet.bend(0.05 * part));
    let forces = |tilt: f64, drag: f64| (sheet.gravity([9.81 * tilt, 0.0, -9.81]), sheet.drag(drag));
    let mut scene = sheet.scene(forces(0.2, 1.0), springs(1.0), (), solver);
    let mut memory = scene.memory();
    let mut found = 0.0_f64;
    for frame in 0..24 {
        if frame == 20 {
            match change {
                Change::Nothing => {}
                Change::Stiffer => scene.links = springs(2.0),
                Change::Softer => scene.links = springs(0.5),
                Change::Tilted => scene.forces = forces(-0.2, 1.0),
                Change::Thicker => scene.forces = forces(0.2, 3.0),
            }
        }
        let before = cloth.velocity;
        scene.step(&mut cloth, &mut memory);
        if frame >= 20 {
            let changes =
                cloth.velocity.values().zip(before.values()).map(|(now, then)| (now - then).length().to_f64());
            found = changes.fold(found, f64::max);
        }
    }
    found / sheet.units.velocity([9.81 / 60.0, 0.0, 0.0]).0[0]
}

#[test]
fn what_changes_throws_nothing() {
    fn check<S: Scalar>() {
        fn by<S: Scalar, V: Solver<S>>(name: &str, solver: impl Fn() -> V) {
            for change in [Change::Nothing, Change::Stiffer, Change::Softer, Change::Tilted, Change::Thicker] {
                // leapfrog carries nothing over from one substep to the next
                let usual = jump::<f64, _>(change, Leapfrog::new());
                let found = jump::<S, V>(change, solver());
                assert!(found < 1.1 * usual, "{change:?} by {name} in {}: {found}, {usual} by leapfrog", S::NAME);
                assert!(found > 0.3 * usual, "{change:?} by {name} in {}: {found}, {usual} by leapfrog", S::NAME);
            }
        }
        by::<S, _>("leapfrog", Leapfrog::new);
        by::<S, _>("Verlet", Verlet::new);
        by::<S, _>("XPBD", Xpbd::new);
        by::<S, _>("backward Euler", BackwardEuler::new);
        by::<S, _>("lines", Lines::new);
    }
    check::<f32>();
    check::<f64>();
    check::<Q24>();
    check::<Q13>();
}

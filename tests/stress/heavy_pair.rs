//! A link between two heavy particles. Its multiplier, the displacement of a particle of mass 1, is larger than its whole elongation. Fixed point once could not represent
//! it, and the correction had the wrong direction.

use kerchief::{Cloth, Node, Q13, Q24, Scalar, Scene, Solver, Stretch, Units, Verlet, Xpbd, measure};

/// The strain that a substep leaves of a rigid link with `strain`, between particles of mass `heavy`.
fn straightened<S: Scalar, V: Solver<S>>(heavy: f64, strain: f64, solver: V) -> f64 {
    let units = Units::sheet([2, 1], [1.0, 0.0], 1.0, 0.1, 1);
    let mut cloth = Cloth::<S, 2, 1>::lay(&units, units.point([0.0; 3]));
    cloth.inverse_mass.values_mut().for_each(|w| *w = S::from_f64(1.0 / heavy));
    let end = Node::new(1, 0);
    cloth.position.set(end, units.point([1.0 + strain, 0.0, 0.0]).to_vec());
    let scene = Scene::new(&units, (), Stretch::new(&units, units.compliance(0.0)), (), solver);
    let mut memory = scene.memory();
    scene.step(&mut cloth, &mut memory);
    measure::strain(&cloth, &scene.links).largest.to_f64()
}

#[test]
fn heavy_pairs_are_pulled_the_right_way() {
    fn every<S: Scalar>() {
        for heavy in [1.0, 2.0, 3.0, 10.0, 30.0, 60.0] {
            for strain in [-0.5, -0.06, 0.05, 0.3] {
                let left = straightened::<S, _>(heavy, strain, Xpbd);
                assert!(left < 1e-3, "mass {heavy}, strain {strain} in {}: {left}", S::NAME);
                let left = straightened::<S, _>(heavy, strain, Verlet { sweeps: 3 });
                assert!(left < 0.2 * strain.abs(), "mass {heavy}, strain {strain} by Verlet in {}: {left}", S::NAME);
            }
        }
    }
    every::<f32>();
    every::<Q24>();
    every::<Q13>();
}

//! A strain limit between heavy particles far apart. The correction divided by their inverse masses once saturated in fixed point, which moved them sideways and sent an
//! overstretched chain flying.

use kerchief::{Cloth, Node, Q13, Q24, Scalar, Scene, StrainLimited, Stretch, Units, Vec3, Verlet};

/// The ends of a link between particles of these inverse masses, after the limit has shortened it. Before, it reaches from the origin to `end` (cells).
fn shortened<S: Scalar>(inverse_masses: [f64; 2], end: [f64; 3]) -> [[f64; 3]; 2] {
    let units = Units::sheet([2, 1], [0.1, 0.0], 1e-3, 0.01, 1);
    let mut cloth = Cloth::<S, 2, 1>::lay(&units, units.point([0.0; 3]));
    for (column, inverse_mass) in inverse_masses.into_iter().enumerate() {
        cloth.inverse_mass[Node::new(column, 0)] = S::from_f64(inverse_mass);
    }
    cloth.position.set(Node::new(1, 0), Vec3::from_f64(end));
    // springs without stiffness: only the limit acts
    let links = StrainLimited::new(Stretch::new(&units, units.stiffness(0.0)), 1.0);
    let scene = Scene::new(&units, (), links, (), Verlet { sweeps: 1 });
    scene.step(&mut cloth, &mut scene.memory());
    [0, 1].map(|column| cloth.position.at(Node::new(column, 0)).to_f64())
}

/// A link is shortened along itself to twice its rest length, less 1/1024. Its ends move in proportion to their inverse masses.
#[test]
fn limits_shorten_links_of_any_masses_along_themselves() {
    fn check<S: Scalar>(bound: f64) {
        for end in [[20.0, -30.0, 40.0], [-1.5, 2.5, 0.1], [0.0, 3.0, -70.0]] {
            let length = end.iter().map(|x| x * x).sum::<f64>().sqrt();
            let less = 1.0 - 2.0 * (1.0 - 1.0 / 1024.0) / length;
            for masses in [[1.0, 1.0], [1.0, 18.5], [80.0, 80.0], [0.05, 80.0], [1000.0, 2.0], [f64::INFINITY, 18.5]] {
                let [wa, wb] = masses.map(|mass| S::from_f64(1.0 / mass).to_f64());
                let found = shortened::<S>([wa, wb], end);
                for axis in 0..3 {
                    let expected = [less * wa / (wa + wb) * end[axis], (1.0 - less * wb / (wa + wb)) * end[axis]];
                    for (found, expected) in [found[0][axis], found[1][axis]].into_iter().zip(expected) {
                        let error = (found - expected).abs();
                        assert!(error < bound * length, "{masses:?}, {end:?} in {}: {found}, {expected}", S::NAME);
                    }
                }
            }
        }
    }
    check::<f64>(1e-9);
    check::<f32>(3e-7);
    check::<Q24>(3e-7);
    check::<Q13>(3e-7);
}

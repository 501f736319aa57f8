//! Overstretched chains. The multipliers that would close them at once, hundreds of cells, once wrapped in fixed point and sent the chains flying, those of heavy particles out of
//! its range.

use kerchief::{Cloth, Lines, Node, Q13, Q24, Scalar, Scene, Stretch, Units, Vec3, measure};

const PARTICLES: usize = 4;

/// A chain, pinned at its first particle, is let go with particles of this mass and links of so many cells. Returns a particle's largest distance from the origin, cells, and the
/// strain after a second.
fn let_go<S: Scalar>(mass: f64, cells: f64, bend: f64, down: bool) -> [f64; 2] {
    if down { released::<S, 1, PARTICLES>(mass, cells, bend) } else { released::<S, PARTICLES, 1>(mass, cells, bend) }
}

fn released<S: Scalar, const W: usize, const H: usize>(mass: f64, cells: f64, bend: f64) -> [f64; 2] {
    let units = Units::sheet([W, H], [0.1 * (W - 1) as f64, 0.1 * (H - 1) as f64], 1e-3, 0.01, 1);
    let mut cloth = Cloth::<S, W, H>::lay(&units, units.point([0.0; 3]));
    for k in 0..PARTICLES {
        let node = Node::new(k.min(W - 1), k.min(H - 1));
        cloth.inverse_mass[node] = S::from_f64(1.0 / mass);
        cloth.position.set(node, Vec3::from_f64([k as f64 * cells, bend * (k * k) as f64, 0.0]));
    }
    cloth.pin(Node::new(0, 0));
    let scene = Scene::new(&units, (), Stretch::new(&units, units.stiffness(1e6)), (), Lines::default());
    let mut memory = scene.memory();
    let mut furthest = 0.0_f64;
    for _ in 0..100 {
        scene.step(&mut cloth, &mut memory);
        let reach = cloth.position.values().map(|place| place.to_f64().into_iter().map(|x| x * x).sum::<f64>().sqrt());
        furthest = reach.fold(furthest, f64::max);
    }
    [furthest, measure::strain(&cloth, &scene.links).largest.to_f64()]
}

#[test]
fn torn_chains_come_together() {
    fn check<S: Scalar>() {
        for mass in [1.0, 20.0, 80.0, 400.0] {
            for cells in [2.0, 5.0, 10.0, 20.0, 30.0] {
                for (bend, down) in [(0.0, false), (0.3, false), (0.0, true), (0.3, true)] {
                    let [furthest, strain] = let_go::<S>(mass, cells, bend, down);
                    let case = format!("{cells} cells a link of mass {mass}, bend {bend}, down {down} in {}", S::NAME);
                    assert!(furthest < 3.0 * cells, "{case}: {furthest} cells away");
                    assert!(strain < 0.1, "{case}: strained by {strain} after a second");
                }
            }
        }
    }
    check::<f64>();
    check::<f32>();
    check::<Q24>();
    check::<Q13>();
}

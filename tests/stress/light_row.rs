//! Nearly rigid rows of light particles between two pins. One pivot of such a row is the compliance of its links alone. Rounding errors of large inverse masses in `f32`
//! once exceeded it: the sheet was undefined after its first frame. Dampers as strong did the same.

use kerchief::measure::{is_finite, strain};
use kerchief::{Cloth, Damped, Gravity, Lines, Node, Q13, Q24, Scalar, Scene, Stretch, Units};

const SIDE: usize = 8;
const MASS: f64 = 1e-4;
const STEP: f64 = 1.0 / 400.0;
const UNITS: Units = Units::sheet([SIDE; 2], [0.7; 2], MASS, STEP, 1);

/// The largest strain in a second of a sheet that swings from its upper corners. Its border has the inverse mass `light`; `[spring, damper]` are the κ of springs and dampers.
fn most<S: Scalar>(light: f64, [spring, damper]: [f64; 2]) -> f64 {
    let mut cloth = Cloth::<S, SIDE, SIDE>::hang(&UNITS, UNITS.point([0.0; 3]));
    for node in (0..SIDE).flat_map(|k| [(k, 0), (k, SIDE - 1), (0, k), (SIDE - 1, k)]) {
        cloth.inverse_mass[Node::new(node.0, node.1)] = S::from_f64(light);
    }
    [0, SIDE - 1].into_iter().for_each(|column| cloth.pin(Node::new(column, 0)));
    let gravity = Gravity::new(UNITS.acceleration([-3.0, 8.0, -5.0]));
    let [stiffness, damping] = [spring * MASS / STEP / STEP, damper * MASS / STEP];
    let links = Damped::new(Stretch::new(&UNITS, UNITS.stiffness(stiffness)), UNITS.damping(damping));
    let scene = Scene::new(&UNITS, gravity, links, (), Lines::default());
    let mut memory = scene.memory();
    let mut most = 0.0_f64;
    for _ in 0..400 {
        scene.step(&mut cloth, &mut memory);
        assert!(is_finite(&cloth), "{}: {light}, {spring}, {damper}", S::NAME);
        most = most.max(strain(&cloth, &scene.links).largest.to_f64());
    }
    most
}

#[test]
fn light_rows_between_pins_hold() {
    fn every<S: Scalar>(lights: &[f64]) {
        for &light in lights {
            for strengths in [[1e4, 0.0], [3e5, 0.0], [1e6, 0.0], [1e8, 0.0], [1e4, 1e3], [1e4, 1e6], [1e6, 1e6]] {
                let (found, exact) = (most::<S>(light, strengths), most::<f64>(light, strengths));
                assert!(found < 2.0 * exact + 1e-3, "{found}, {exact} in {}: {light}, {strengths:?}", S::NAME);
            }
        }
    }
    every::<f32>(&[2.0, 15.0, 60.0, 1e3, 1e5]);
    every::<Q24>(&[2.0, 15.0, 60.0]);
    every::<Q13>(&[2.0, 15.0, 60.0]);
}

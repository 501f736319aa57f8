//! expected `&mut Cloth<f32, _, _>`, found `&mut Cloth<Fixed24<Exact>, 4, 4>`

use kerchief::{Cloth, Gravity, Q24, Scene, Units, Xpbd};

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let mut cloth = Cloth::<Q24, 4, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    let gravity = Gravity::<f32>::new(UNITS.acceleration([0.0, 0.0, -9.81]));
    let scene = Scene::new(&UNITS, gravity, (), (), Xpbd);
    scene.step(&mut cloth, &mut scene.memory());
}

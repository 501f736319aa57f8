//! where links may be damped, three grids more are needed: `Lines::<7>::default()` for stretch and shear

use kerchief::{Cloth, Damped, Lines, Scene, Shear, Stretch, Units};

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let mut cloth = Cloth::<f32, 4, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    let stretch = Damped::new(Stretch::new(&UNITS, UNITS.stiffness(10.0)), UNITS.damping(0.01));
    let scene = Scene::new(&UNITS, (), (stretch, Shear::new(&UNITS, UNITS.stiffness(1.0))), (), Lines::new());
    let mut memory = scene.memory();
    scene.step(&mut cloth, &mut memory);
}

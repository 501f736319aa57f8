use kerchief::{BackwardEuler, Cloth, Gravity, Q24, Scene, Stretch, Units};

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let mut cloth = Cloth::<Q24, 4, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    let gravity = Gravity::<Q24>::new(UNITS.acceleration([0.0, 0.0, -9.81]));
    let stretch = Stretch::new(&UNITS, UNITS.stiffness(10.0));
    let scene = Scene::new(&UNITS, gravity, stretch, (), BackwardEuler { newton_steps: 1 });
    let mut memory = scene.memory();
    scene.step(&mut cloth, &mut memory);
}

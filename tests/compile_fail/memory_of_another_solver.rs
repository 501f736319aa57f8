//! expected mutable reference `&mut solver::leapfrog::LeapfrogMemory<f32, 4, 4>`

use kerchief::{BackwardEuler, Cloth, Leapfrog, Scene, Solver, Units};

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let mut cloth = Cloth::<f32, 4, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    let scene = Scene::new(&UNITS, (), (), (), Leapfrog);
    let mut memory = Solver::<f32>::memory::<(), 4, 4>(&BackwardEuler { newton_steps: 1 });
    scene.step(&mut cloth, &mut memory);
}

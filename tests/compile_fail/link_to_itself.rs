//! a link needs two particles

use kerchief::link::{Directions, Family, Links, Quotient, Undamped, Visitor};
use kerchief::scalar::Rest;
use kerchief::{Cloth, Scene, Units, Xpbd};

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);

struct Loops;

impl Links<f32> for Loops {
    type Directions = Directions<1>;
    type Damping = Undamped;

    fn springs<V: Visitor<f32>>(&self, visitor: &mut V) {
        let strength = Quotient { dividend: 1.0, divisor: 1.0 };
        visitor.family::<0, 0>(&Family { strength, rest: Rest::spanning(1.0, 0.0) });
    }
}

fn main() {
    let mut cloth = Cloth::<f32, 4, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    let scene = Scene::new(&UNITS, (), Loops, (), Xpbd);
    scene.step(&mut cloth, &mut scene.memory());
}

//! A curtain whose pins are drawn together: the strain of links between two pins must not call for more sweeps.

use kerchief::host::Counted;
use kerchief::{Cloth, Drag, Gravity, Lines, Node, Scalar, Scene, Shear, Stretch, Units};

const SIDE: usize = 8;

/// Operations of a frame of a curtain that has hung for a second from pins on a rail of this width, m.
fn operations(rail: f64) -> u64 {
    let units = Units::sheet([SIDE; 2], [1.0; 2], 2e-3, 1.0 / 60.0, 4);
    let mut cloth = Cloth::<Counted, SIDE, SIDE>::hang(&units, units.point([0.0; 3]));
    for column in 0..SIDE {
        let pin = Node::new(column, 0);
        cloth.pin(pin);
        // in small pleats
        let place = [rail * column as f64 / (SIDE - 1) as f64, 0.02 * [1.0, -1.0][column % 2], 0.0];
        cloth.position.set(pin, units.point(place).to_vec());
    }
    let forces = (Gravity::new(units.acceleration([0.0, 0.0, -9.81])), Drag::new(units.drag(5.0)));
    let links = (Stretch::new(&units, units.stiffness(1000.0)), Shear::new(&units, units.stiffness(1.0)));
    let scene = Scene::new(&units, forces, links, (), Lines::new());
    let mut memory = scene.memory();
    (0..60).for_each(|_| scene.step(&mut cloth, &mut memory));
    Counted::reset();
    scene.step(&mut cloth, &mut memory);
    assert!(cloth.position.at(Node::new(3, SIDE - 1)).z < -Counted::ONE, "the curtain does not hang down");
    Counted::operations().total()
}

#[test]
fn a_drawn_curtain_takes_no_more_sweeps() {
    let (wide, drawn) = (operations(1.0), operations(0.8));
    assert!(drawn < wide + wide / 4, "{drawn} operations drawn together, {wide} at rest");
}

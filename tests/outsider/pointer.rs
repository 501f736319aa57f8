//! An outsider's pointer: it grabs the particle under a pixel, drags it across the screen, and drops it.

use embedded_graphics::geometry::{Point, Size};
use kerchief::render::{Camera, View};
use kerchief::{Cloth, Drag, Gravity, Hand, Lines, Node, Q13, Q24, Scalar, Scene, Shear, Stretch, Units};

const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
const SCREEN: Size = Size::new(320, 240);
const VIEW: View = View::new(20.0, 15.0).fit(UNITS.point([-0.2, -0.2, 0.0]), UNITS.point([0.2, 0.2, 0.3]), SCREEN);

fn drags_across_the_screen<S: Scalar>() {
    let mut cloth = Cloth::<S, 16, 16>::hang(&UNITS, UNITS.point([-0.15, 0.0, 0.3]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(15, 0));
    // a force of up to half a newton, twice the sheet's weight
    let hand = Hand::new(&UNITS, UNITS.compliance(0.05), UNITS.damping(0.5), UNITS.length(0.025));
    let forces = (Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])), Drag::new(UNITS.drag(1.0)), hand);
    let links = (Stretch::new(&UNITS, UNITS.stiffness(200.0)), Shear::new(&UNITS, UNITS.stiffness(5.0)));
    let mut scene = Scene::new(&UNITS, forces, links, (), Lines::new());
    let mut memory = scene.memory();
    let camera = Camera::new(&VIEW, SCREEN);

    let node = Node::new(9, 12);
    let mut pointer = camera.project(cloth.position.at(node)).expect("in the picture");
    let hit = camera.ray(pointer).hit(&cloth).expect("the sheet is there");
    assert_eq!(hit.node(), node, "in {}", S::NAME);
    scene.forces.2.grab(&cloth, node);
    let mut target = hit.position;
    for frame in 0..120 {
        if frame < 30 {
            pointer += Point::new(1, -1);
        }
        target = camera.ray(pointer).foot(target);
        scene.forces.2.drag_to(target);
        scene.step(&mut cloth, &mut memory);
    }
    let seen = camera.project(cloth.position.at(node)).expect("in the picture");
    let off = seen - pointer;
    assert!(off.x.abs() <= 5 && off.y.abs() <= 12, "the particle is {off} pixels from the pointer in {}", S::NAME);
    assert_eq!(scene.forces.2.drop(), Some(node));
    (0..30).for_each(|_| scene.step(&mut cloth, &mut memory));
    let fallen = camera.project(cloth.position.at(node)).expect("in the picture");
    assert!(fallen.y > seen.y + 10, "it falls from {seen} to {fallen} in {}", S::NAME);
}

#[test]
fn a_pointer_drags_what_is_under_it() {
    drags_across_the_screen::<f32>();
    drags_across_the_screen::<Q24>();
    drags_across_the_screen::<Q13>();
}

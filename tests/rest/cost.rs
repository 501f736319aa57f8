//! The cost of a frame at rest: at most a hundredth of the cheapest frame in motion.

use kerchief::host::Counted;
use kerchief::{Cloth, Gravity, Lines, Node, Resting, Scene, Shear, Solver, Stillness, Stretch, Units, measure};

const SIDE: usize = 16;
/// One substep.
const UNITS: Units = Units::sheet([SIDE, SIDE], [0.3, 0.3], 1e-4, 1.0 / 60.0, 1);
/// One sweep in each substep, as long as every row is within the tolerance.
const CHEAPEST: Lines = Lines::with_sweeps(1);
/// Numbers of a sheet: two vectors and a mass for each particle.
const NUMBERS: u64 = 7 * (SIDE * SIDE) as u64;

type Sheet = Cloth<Counted, SIDE, SIDE>;
type Springs = (Stretch<Counted>, Shear<Counted>);
type Hanging<V> = Scene<Gravity<Counted>, Springs, (), V>;

/// A sheet on two corners.
fn hanging<V: Solver<Counted>>(solver: V) -> (Hanging<V>, Sheet, V::Memory<Springs, SIDE, SIDE>) {
    let mut cloth = Sheet::hang(&UNITS, UNITS.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(SIDE - 1, 0));
    let gravity = Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81]));
    let links = (Stretch::new(&UNITS, UNITS.stiffness(100.0)), Shear::new(&UNITS, UNITS.stiffness(1.0)));
    let scene = Scene::new(&UNITS, gravity, links, (), solver);
    let memory = scene.memory();
    (scene, cloth, memory)
}

/// The operations that `work` takes.
fn operations(work: impl FnOnce()) -> u64 {
    Counted::reset();
    work();
    Counted::operations().total()
}

/// Operations of the cheapest frame of a second.
fn in_motion() -> u64 {
    let (scene, mut cloth, mut memory) = hanging(CHEAPEST);
    let least = (0..60).map(|_| operations(|| scene.step(&mut cloth, &mut memory))).min();
    assert!(measure::kinetic_energy(&cloth, &UNITS) > 0.0, "the sheet does not move");
    least.expect("a second has frames")
}

#[test]
fn a_frame_at_rest_costs_a_hundredth_of_the_cheapest_in_motion() {
    let in_motion = in_motion();
    // at rest after the first frame
    let soon = Stillness { speed: 10.0, acceleration: 1e3, time: UNITS.frame };
    let (scene, mut cloth, mut memory) = hanging(Resting::new(&UNITS, soon, CHEAPEST));
    scene.step(&mut cloth, &mut memory);
    assert!(memory.is_at_rest());
    let digest = measure::digest(&cloth);
    let mut frame = |cloth: &mut Sheet| operations(|| scene.step(cloth, &mut memory));
    for _ in 0..3 {
        let at_rest = frame(&mut cloth);
        // gravity and springs are compared with their earlier values
        assert!(at_rest >= 3 && 100 * at_rest <= in_motion, "{at_rest} operations at rest, {in_motion} in motion");
    }
    // particles that may have been written to are compared, once
    let node = Node::new(3, 4);
    let same = cloth.position.at(node);
    cloth.position.set(node, same);
    assert!((NUMBERS..2 * NUMBERS).contains(&frame(&mut cloth)));
    assert!(100 * frame(&mut cloth) <= in_motion && memory.is_at_rest());
    assert_eq!(measure::digest(&cloth), digest);
}

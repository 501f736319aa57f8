//! Replacing a sheet at rest by another one counts as a change. Overwriting it with its own values does not.

use core::mem;

use kerchief::rest::RestingMemory;
use kerchief::solver::Stateless;
use kerchief::{Gravity, Lines, Node, Q24, Resting, Vec3, Xpbd, measure};

use crate::{DOWN, Described, SIDE, Sheet, UNITS, curtain, resting, settle};

type Curtain = Described<Q24, Resting<Xpbd>>;
type Remembered = RestingMemory<Stateless<Q24, SIDE, SIDE>, Q24, SIDE, SIDE>;

fn at_rest() -> (Curtain, Sheet<Q24>, Remembered) {
    let (scene, mut cloth) = curtain::<Q24, _>(resting(Xpbd));
    let mut memory = scene.memory::<Q24, SIDE, SIDE>();
    assert!(settle(&scene, &mut cloth, &mut memory, 3600).is_some(), "it never rests");
    (scene, cloth, memory)
}

/// The same curtain, tilted.
fn tilted((mut scene, mut cloth, mut memory): (Curtain, Sheet<Q24>, Remembered)) -> (Curtain, Sheet<Q24>, Remembered) {
    scene.forces.0 = Gravity::new(UNITS.acceleration([1.0, 0.0, DOWN[2]]));
    assert!(settle(&scene, &mut cloth, &mut memory, 3600).is_some_and(|frames| frames > 1), "it does not wake");
    (scene, cloth, memory)
}

/// Whether a frame moves the sheet as its solver alone does, instead of leaving it at rest.
fn wakes(scene: &Curtain, cloth: &mut Sheet<Q24>, memory: &mut Remembered) -> bool {
    let (mut alone, _) = curtain::<Q24, _>(Xpbd);
    alone.forces = scene.forces;
    let before = measure::digest(cloth);
    let mut twin = *cloth;
    alone.step_one(&mut twin, &mut Stateless::new());
    scene.step_one(cloth, memory);
    let after = measure::digest(cloth);
    assert!(memory.is_at_rest() || after == measure::digest(&twin), "moved in another way than by the solver alone");
    assert!(!memory.is_at_rest() || after == before, "moved at rest");
    !memory.is_at_rest()
}

#[test]
fn a_copy_of_another_rest_wakes() {
    let upright = at_rest();
    let (scene, mut cloth, mut memory) = tilted(upright);
    assert!(!wakes(&scene, &mut cloth, &mut memory));
    cloth = upright.1;
    assert!(wakes(&scene, &mut cloth, &mut memory));
}

#[test]
fn sheets_that_change_places_wake() {
    let [mut a, mut b] = [at_rest(), tilted(at_rest())];
    mem::swap(&mut a.1, &mut b.1);
    assert!(wakes(&a.0, &mut a.1, &mut a.2) && wakes(&b.0, &mut b.1, &mut b.2));
    // swap the particles alone
    let [mut a, mut b] = [at_rest(), tilted(at_rest())];
    mem::swap(&mut *a.1, &mut *b.1);
    assert!(wakes(&a.0, &mut a.1, &mut a.2) && wakes(&b.0, &mut b.1, &mut b.2));
}

#[test]
fn a_sheet_that_another_solver_moved_wakes() {
    let (scene, mut cloth, mut memory) = at_rest();
    let (mut other, _) = curtain::<Q24, _>(Lines::default());
    other.forces.0 = Gravity::new(UNITS.acceleration([1.0, 0.0, DOWN[2]]));
    other.step_one(&mut cloth, &mut other.memory::<Q24, SIDE, SIDE>());
    assert!(wakes(&scene, &mut cloth, &mut memory));
    // another solver that comes to rest itself
    let (scene, mut cloth, mut memory) = at_rest();
    let (mut other, _) = curtain::<Q24, _>(resting(Lines::default()));
    other.forces.0 = Gravity::new(UNITS.acceleration([1.0, 0.0, DOWN[2]]));
    assert!(settle(&other, &mut cloth, &mut other.memory::<Q24, SIDE, SIDE>(), 3600).is_some());
    assert!(wakes(&scene, &mut cloth, &mut memory));
}

#[test]
fn what_is_as_it_was_sleeps_on() {
    let (scene, mut cloth, mut memory) = at_rest();
    let saved = cloth;
    let (node, pin) = (Node::new(3, 4), Node::new(0, 0));
    // poked, and restored before the next step
    cloth.velocity.set(node, Vec3::from_f64([0.0, 0.1, 0.0]));
    cloth = saved;
    assert!(!wakes(&scene, &mut cloth, &mut memory));
    cloth.velocity.set(node, Vec3::from_f64([0.0, 0.1, 0.0]));
    cloth.velocity.set(node, saved.velocity.at(node));
    assert!(!wakes(&scene, &mut cloth, &mut memory));
    // every value set to itself
    cloth.pin(pin);
    let place = cloth.position.at(pin);
    scene.move_pin(&mut cloth, pin, place);
    cloth.position.set(node, saved.position.at(node));
    assert!(!wakes(&scene, &mut cloth, &mut memory));
    assert_eq!(cloth, saved);
}

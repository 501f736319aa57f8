//! After any change a sheet at rest moves in the same frame, as if it had never rested.

use kerchief::{Bend, Drag, FacetWind, Gravity, Node, Resting, Scalar, Shear, Solver, Sphere, Vec3, measure};

use crate::{DOWN, Described, SIDE, Sheet, Springs, Trial, UNITS, curtain, every_solver, resting, settle};

/// A change of the scene or the sheet, made while the sheet rests.
type Change<S, V> = (&'static str, fn(&mut Described<S, Resting<V>>, &mut Sheet<S>));

/// A particle in the middle of the sheet.
const NODE: Node = Node::new(3, 4);

fn changes<S: Scalar, V: Solver<S>>() -> [Change<S, V>; 15] {
    fn least<S: Scalar>() -> S {
        S::from_f64(1e-6)
    }
    [
        ("gravity", |scene, _| scene.forces.0 = Gravity::new(UNITS.acceleration([0.0, 0.0, -9.8]))),
        ("drag", |scene, _| scene.forces.1 = Drag::new(UNITS.drag(5.0))),
        ("a wind rises", |scene, _| scene.forces.2 = Some(FacetWind::new(UNITS.facet_wind([0.0, 1e-3, 0.0])))),
        ("shear", |scene, _| scene.links.1 = Shear::new(&UNITS, UNITS.stiffness(5.1))),
        ("bend", |scene, _| scene.links.2 = Bend::new(&UNITS, UNITS.stiffness(0.9))),
        ("the ball is pushed", |scene, _| scene.colliders.velocity_mut().y = -least::<S>()),
        ("the ball is elsewhere", |scene, _| scene.colliders.centre.y += least::<S>()),
        ("the ball is rough", |scene, _| scene.colliders.friction = S::HALF),
        ("another ball", |scene, _| {
            *scene.colliders = Sphere::new(UNITS.point([0.15, 0.4, 0.1]), UNITS.length(0.11), UNITS.length(0.01));
        }),
        ("a pin is taken out", |_, cloth| cloth.release(Node::new(2, 0), S::ONE)),
        ("a pin is put in", |_, cloth| cloth.pin(NODE)),
        ("a pin travels", |scene, cloth| {
            let target = cloth.position.at(Node::new(0, 0)) + Vec3::new(S::ZERO, least(), S::ZERO);
            scene.move_pin(cloth, Node::new(0, 0), target);
        }),
        ("a poke", |_, cloth| cloth.velocity.add(NODE, Vec3::new(S::ZERO, least(), S::ZERO))),
        ("a particle is elsewhere", |_, cloth| cloth.position.add(NODE, Vec3::new(least(), S::ZERO, S::ZERO))),
        ("a hem", |_, cloth| cloth.hem(S::from_f64(1.5))),
    ]
}

struct Wakes;

impl Trial for Wakes {
    fn with<S: Scalar, V: Solver<S> + Copy>(&self, name: &str, solver: V)
    where
        V::Memory<Springs<S>, SIDE, SIDE>: Clone,
    {
        let (scene, mut cloth) = curtain::<S, _>(resting(solver));
        let mut memory = scene.memory();
        assert!(settle(&scene, &mut cloth, &mut memory, 3600).is_some(), "{name} in {}", S::NAME);
        for (what, change) in changes::<S, V>() {
            let (mut scene, mut cloth, mut memory) = (scene, cloth, memory.clone());
            change(&mut scene, &mut cloth);
            // the same scene and sheet, moved by the solver without rest
            let (mut alone, _) = curtain::<S, _>(solver);
            (alone.forces, alone.links, alone.colliders) = (scene.forces, scene.links, scene.colliders);
            let (mut twin, mut twin_memory) = (cloth, memory.clone().solver().clone());
            scene.step_one(&mut cloth, &mut memory);
            alone.step_one(&mut twin, &mut twin_memory);
            assert!(!memory.is_at_rest(), "{what}: {name} in {} sleeps on", S::NAME);
            assert_eq!(measure::digest(&cloth), measure::digest(&twin), "{what}: {name} in {}", S::NAME);
        }
        let (mut cloth, mut memory) = (cloth, memory.clone());
        scene.step_one(&mut cloth, &mut memory);
        assert!(memory.is_at_rest(), "{name} in {}: it wakes without a change", S::NAME);
        let same = Gravity::new(UNITS.acceleration(DOWN));
        let mut scene = scene;
        scene.forces.0 = same;
        scene.step_one(&mut cloth, &mut memory);
        assert!(memory.is_at_rest(), "{name} in {}: the same gravity is no change", S::NAME);
    }
}

#[test]
fn any_change_wakes_a_sheet() {
    every_solver(&Wakes);
}

//! A saved and restored sheet, with its solver's memory, goes on with the same bits. States that could not have been saved are refused.

use std::fmt::Debug;

use serde::Serialize;
use serde::de::DeserializeOwned;

use kerchief::self_contact::Thickness;
use kerchief::{
    AerodynamicWind, BackwardEuler, Bend, Cloth, Damped, Drag, ForwardEuler, Gravity, Leapfrog, Lines, Node, Q13, Q24,
    Resting, Scalar, Scene, SelfContact, Shear, Solver, Sphere, Stillness, Stretch, Units, Vec3, Verlet, Xpbd, measure,
};

const W: usize = 7;
const H: usize = 5;

type Springs<S> = (Damped<Stretch<S>, S>, Shear<S>, Bend<S>);
type State<S, V> = (Cloth<S, W, H>, <V as Solver<S>>::Memory<Springs<S>, W, H>);

/// 50 frames. After 25 the state is saved and restored in two formats; the copies must keep the same bits.
fn goes_on<S, V>(name: &str, solver: V, substeps: u32, stiffness: f64)
where
    S: Scalar + Serialize + DeserializeOwned,
    V: Solver<S> + Copy,
    V::Memory<Springs<S>, W, H>: Serialize + DeserializeOwned + Clone + Debug,
{
    let units = Units::sheet([W, H], [0.3, 0.2], 1e-3, 1.0 / 60.0, substeps);
    let mut cloth = Cloth::<S, W, H>::lay(&units, units.point([0.0; 3]));
    cloth.hem(S::from_int(2));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(W - 1, 0));
    let wind = AerodynamicWind::new(units.aerodynamic_wind([0.5, 2.0, 0.3], 1.2, 1.2));
    let forces = (Gravity::new(units.acceleration([0.0, 0.0, -9.81])), Drag::new(units.drag(0.5)), wind);
    let links = (
        Damped::new(Stretch::new(&units, units.stiffness(stiffness)), units.damping(1e-3)),
        Shear::new(&units, units.stiffness(0.1 * stiffness)),
        Bend::new(&units, units.stiffness(0.01 * stiffness)),
    );
    let ball = Sphere::new(units.point([0.15, 0.1, -0.12]), units.length(0.08), units.length(0.01)).with_friction(0.3);
    let scene = Scene::new(&units, forces, links, ball, solver);
    let mut memory = scene.memory::<S, W, H>();
    (0..25).for_each(|_| scene.step(&mut cloth, &mut memory));
    let bytes = postcard::to_stdvec(&(&cloth, &memory)).unwrap();
    let text = serde_json::to_string(&(&cloth, &memory)).unwrap();
    let mut states: [State<S, V>; 2] = [postcard::from_bytes(&bytes).unwrap(), serde_json::from_str(&text).unwrap()];
    for frame in 25..50 {
        scene.step(&mut cloth, &mut memory);
        for (restored, remembered) in &mut states {
            scene.step(restored, remembered);
            assert_eq!(measure::digest(restored), measure::digest(&cloth), "{name} in {}, frame {frame}", S::NAME);
        }
    }
    // the memories are the same, too
    let end = postcard::to_stdvec(&(&cloth, &memory)).unwrap();
    for state in &states {
        assert_eq!(postcard::to_stdvec(state).unwrap(), end, "{name} in {}", S::NAME);
    }
    assert!(measure::is_finite(&cloth), "{name} in {}", S::NAME);
}

fn every_solver_goes_on<S: Scalar + Serialize + DeserializeOwned>() {
    goes_on::<S, _>("lines", Lines::default(), 4, 200.0);
    goes_on::<S, _>("xpbd", Xpbd, 4, 200.0);
    goes_on::<S, _>("verlet", Verlet { sweeps: 3 }, 4, 200.0);
    goes_on::<S, _>("leapfrog", Leapfrog, 16, 20.0);
    goes_on::<S, _>("forward Euler", ForwardEuler, 16, 1.0);
    goes_on::<S, _>("backward Euler", BackwardEuler { newton_steps: 2 }, 2, 200.0);
    let units = Units::sheet([W, H], [0.3, 0.2], 1e-3, 1.0 / 60.0, 4);
    goes_on::<S, _>("resting", Resting::new(&units, Stillness::DEFAULT, Lines::default()), 4, 200.0);
    let thick = Thickness::new(&units, units.cell);
    goes_on::<S, _>("meeting itself", SelfContact::new(thick, 0.3, Lines::default()), 4, 200.0);
    // at rest after a few frames, so that it is saved at rest
    let soon = Stillness { speed: 100.0, acceleration: 1e4, time: 0.2 };
    goes_on::<S, _>("at rest", Resting::new(&units, soon, Xpbd), 4, 200.0);
}

#[test]
fn every_solver_goes_on_in_f32() {
    every_solver_goes_on::<f32>();
}

#[test]
fn every_solver_goes_on_in_q24() {
    every_solver_goes_on::<Q24>();
}

#[test]
fn every_solver_goes_on_in_q13() {
    every_solver_goes_on::<Q13>();
}

const UNITS: Units = Units::sheet([4, 3], [0.3, 0.2], 1e-3, 1.0 / 60.0, 4);

fn sheet<S: Scalar>() -> Cloth<S, 4, 3> {
    Cloth::lay(&UNITS, UNITS.point([0.1, 0.2, 0.3]))
}

/// The error of reading a sheet from this text.
fn refusal<S: Scalar + DeserializeOwned, const C: usize, const R: usize>(text: &str) -> String {
    serde_json::from_str::<Cloth<S, C, R>>(text).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn sheets_of_another_size_are_refused() {
    let text = serde_json::to_string(&sheet::<Q24>()).unwrap();
    assert_eq!(serde_json::from_str::<Cloth<Q24, 4, 3>>(&text).unwrap(), sheet());
    // the same number of particles
    assert!(refusal::<Q24, 3, 4>(&text).contains("a sheet of 4 × 3 particles, not of 3 × 4"));
    assert!(refusal::<Q24, 4, 4>(&text).contains("16 values"), "{}", refusal::<Q24, 4, 4>(&text));
    assert!(!refusal::<Q24, 4, 2>(&text).is_empty());
    let bytes = postcard::to_stdvec(&sheet::<f32>()).unwrap();
    assert!(postcard::from_bytes::<Cloth<f32, 3, 4>>(&bytes).is_err());
    assert!(postcard::from_bytes::<Cloth<f32, 4, 4>>(&bytes).is_err());
    for length in 0..bytes.len() {
        assert!(postcard::from_bytes::<Cloth<f32, 4, 3>>(&bytes[..length]).is_err(), "{length} bytes");
    }
}

const NODE: Node = Node::new(2, 1);

#[test]
fn numbers_that_make_no_sense_are_refused() {
    let saved = |change: fn(&mut Cloth<f32, 4, 3>)| {
        let mut cloth = sheet::<f32>();
        change(&mut cloth);
        postcard::from_bytes::<Cloth<f32, 4, 3>>(&postcard::to_stdvec(&cloth).unwrap())
    };
    assert!(saved(|cloth| cloth.pin(NODE)).unwrap().is_pinned(NODE));
    for refused in [
        saved(|cloth| cloth.position.add(NODE, Vec3::new(0.0, f32::NAN, 0.0))),
        saved(|cloth| cloth.velocity.add(NODE, Vec3::new(0.0, 0.0, f32::INFINITY))),
        saved(|cloth| cloth.inverse_mass[NODE] = -1.0),
        saved(|cloth| cloth.inverse_mass[NODE] = f32::NAN),
    ] {
        assert!(refused.is_err());
    }
    let text = serde_json::to_string(&sheet::<Q24>()).unwrap();
    assert!(refusal::<Q24, 4, 3>(&text.replace("16777216", "-1")).contains("an inverse mass is finite, zero or above"));
    assert!(refusal::<Q24, 4, 3>(&text.replace("16777216", "1e3")).contains("invalid type"));
    assert!(refusal::<Q24, 4, 3>(&text.replace("16777216", "99999999999")).contains("invalid value"));
}

/// A memory with a damaged byte is refused, or steps with it come to an end without a panic.
#[test]
fn damaged_memories_do_no_harm() {
    fn check<V>(solver: V)
    where
        V: Solver<Q24> + Copy,
        V::Memory<Damped<Stretch<Q24>, Q24>, 4, 3>: Serialize + DeserializeOwned,
    {
        let stretch = Damped::new(Stretch::new(&UNITS, UNITS.stiffness(50.0)), UNITS.damping(0.01));
        let scene = Scene::new(&UNITS, Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])), stretch, (), solver);
        let (mut cloth, mut memory) = (sheet(), scene.memory::<Q24, 4, 3>());
        cloth.pin(Node::new(0, 0));
        (0..3).for_each(|_| scene.step(&mut cloth, &mut memory));
        let bytes = postcard::to_stdvec(&memory).unwrap();
        let ends = (0..bytes.len()).filter(|index| *index < 64 || bytes.len() - index < 64);
        for (index, bits) in ends.flat_map(|index| [1, 0x0f, 0x7f, 0xff].map(|bits| (index, bits))) {
            let mut damaged = bytes.clone();
            damaged[index] ^= bits;
            if let Ok(mut memory) = postcard::from_bytes::<V::Memory<Damped<Stretch<Q24>, Q24>, 4, 3>>(&damaged) {
                let mut cloth = cloth;
                (0..2).for_each(|_| scene.step(&mut cloth, &mut memory));
            }
        }
    }
    check(Lines::default());
    check(Leapfrog);
    check(BackwardEuler { newton_steps: 1 });
    check(Resting::new(&UNITS, Stillness::DEFAULT, Lines::default()));
}

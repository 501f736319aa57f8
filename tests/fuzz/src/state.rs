//! Steps from states of arbitrary bits: no step panics or hangs, and two runs of a state give the same digest.

use kerchief::{
    AerodynamicWind, BackwardEuler, Bend, Capsule, Cloth, Damped, Drag, FacetWind, ForwardEuler, Gravity, Leapfrog,
    Lines, Node, Plane, Q13, Q24, Resting, Scalar, Scene, Shear, Sphere, Stillness, StrainLimited, Stretch, Tether,
    Units, Vec3, Verlet, Xpbd, measure,
};

/// The number of scalars in a state and its parameters.
pub const NUMBERS: usize = 4 * 4 * 7 + 27;

const UNITS: Units = Units::sheet([4, 4], [1.0, 0.8], 0.01, 0.05, 3);

/// The first byte selects a number type and a solver. Each four bytes after it are a number; missing numbers are zero.
pub fn play(bytes: &[u8]) {
    let (&choice, bytes) = bytes.split_first().unwrap_or((&0, &[]));
    let mut bits = [0; NUMBERS];
    for (bits, bytes) in bits.iter_mut().zip(bytes.chunks(4)) {
        *bits = bytes.iter().rev().fold(0, |bits, &byte| bits << 8 | u32::from(byte));
    }
    in_type(choice % TYPES, &bits, Some(choice / TYPES % SOLVERS));
}

/// Plays a state in every number type by every solver.
pub fn play_all(bits: &[u32; NUMBERS]) {
    (0..TYPES).for_each(|number| in_type(number, bits, None));
}

const TYPES: u8 = 4;
const SOLVERS: u8 = 7;

fn in_type(number: u8, bits: &[u32; NUMBERS], solver: Option<u8>) {
    match number {
        0 => step(bits, solver, |bits| Q24::from_bits(bits as i32)),
        1 => step(bits, solver, |bits| Q13::from_bits(bits as i32)),
        2 => step(bits, solver, f32::from_bits),
        // the upper half has the sign, the exponent and a part of the fraction; the lower half repeats it
        _ => step(bits, solver, |bits| f64::from_bits(u64::from(bits) << 32 | u64::from(bits))),
    }
}

/// Plays two steps with many kinds of forces, links and colliders.
fn step<S: Scalar>(bits: &[u32; NUMBERS], chosen: Option<u8>, number: fn(u32) -> S) {
    let mut numbers = bits.iter().map(|&bits| number(bits));
    let mut next = move || numbers.next().expect("enough bits");
    let mut cloth = Cloth::<S, 4, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    cloth.position.change(|_| Vec3::new(next(), next(), next()));
    cloth.velocity.change(|_| Vec3::new(next(), next(), next()));
    cloth.inverse_mass.values_mut().for_each(|mass| *mass = next());
    cloth.pin(Node::new(0, 0));
    let mut vector = || Vec3::new(next(), next(), next());
    let mut gravity = Gravity::new(UNITS.acceleration([0.0; 3]));
    gravity.gain = vector();
    let mut facets = FacetWind::new(UNITS.facet_wind([0.0; 3]));
    facets.wind = vector();
    let mut air = AerodynamicWind::new(UNITS.aerodynamic_wind([0.0; 3], 1.2, 1.2));
    (air.wind, air.pressure) = (vector(), vector().x);
    let mut ball = Sphere::new(UNITS.point([0.0; 3]), UNITS.length(0.3), UNITS.length(0.1));
    ball.friction = vector().x;
    ball.centre = vector();
    let mut ball = ball.with_velocity(UNITS.velocity([0.0; 3]));
    *ball.velocity_mut() = vector();
    let plane = Plane::new(UNITS.point([0.0; 3]), Vec3::from_f64([0.0, 0.6, 0.8]), UNITS.length(0.1));
    let [a, b] = [[0.1, 0.0, 0.0], [0.4, 0.3, 0.0]].map(|end| UNITS.point(end));
    let rod = Capsule::new(a, b, UNITS.length(0.1), UNITS.length(0.05));
    let stretch = Damped::new(Stretch::new(&UNITS, UNITS.stiffness(1e3)), UNITS.damping(0.1));
    let Ok(tether) = Tether::<S, 1>::new(&UNITS, &[Node::new(0, 0)], 0.0) else { unreachable!("one fits") };
    let links = (
        StrainLimited::new(stretch, 0.1),
        Shear::new(&UNITS, UNITS.stiffness(1e6)),
        Bend::new(&UNITS, UNITS.compliance(0.0)),
        tether,
    );
    let forces = (gravity, Drag::new(UNITS.drag(0.5)), facets, air);
    let target = vector();

    macro_rules! each {
        ($($index:literal: $solver:expr),*) => {$(if chosen.is_none_or(|chosen| chosen == $index) {
            let [once, twice] = [(); 2].map(|()| {
                let mut scene = Scene::new(&UNITS, forces, links.clone(), (ball, plane, rod), $solver);
                let (mut sheet, mut memory) = (cloth, scene.memory::<S, 4, 4>());
                for _ in 0..2 {
                    scene.play(&mut sheet, &mut memory);
                    scene.move_pin(&mut sheet, Node::new(0, 0), target);
                }
                measure::strain(&sheet, &scene.links);
                measure::digest(&sheet)
            });
            assert_eq!(once, twice, "{} in {}", stringify!($solver), S::NAME);
        })*};
    }
    each!(
        0: Lines::with_sweeps(2),
        1: Xpbd,
        2: Verlet { sweeps: 3 },
        3: Leapfrog,
        4: ForwardEuler,
        5: BackwardEuler { newton_steps: 1 },
        6: Resting::new(&UNITS, Stillness::DEFAULT, Xpbd)
    );
}

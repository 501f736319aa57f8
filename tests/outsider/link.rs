//! An outsider's family of links: springs and dampers along the moves of a chess knight.

use kerchief::link::{Directions, Family, Links, Quotient, Undamped, Visitor, WithDampers};
use kerchief::scalar::Rest;
use kerchief::{Cloth, Grid, Leapfrog, Scalar, Scene, Units, Vec3, measure};

struct Knight<S: Scalar> {
    stiffness: Quotient<S>,
    damping: Quotient<S>,
    rest: [Rest<S>; 2],
}

impl<S: Scalar> Knight<S> {
    /// `stiffness` in N/m, `damping` in N·s/m.
    fn new(units: &Units, stiffness: f64, damping: f64) -> Self {
        let [across, down] = units.sides.map(S::from_f64);
        Self {
            stiffness: Quotient::new(units.stiffness(stiffness)),
            damping: Quotient::new(units.damping(damping)),
            rest: [Rest::spanning(across.times(2), down), Rest::spanning(across, down.times(2))],
        }
    }

    fn show(&self, strength: Quotient<S>, visitor: &mut impl Visitor<S>) {
        visitor.family::<2, 1>(&Family { strength, rest: self.rest[0] });
        visitor.family::<1, 2>(&Family { strength, rest: self.rest[1] });
    }
}

impl<S: Scalar> Links<S> for Knight<S> {
    type Directions = Directions<4>;
    type Damping = WithDampers;

    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        self.show(self.stiffness, visitor);
    }

    fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
        self.show(self.damping, visitor);
    }
}

type Sheet = Cloth<f64, 6, 5>;

fn units() -> Units {
    Units::sheet([6, 5], [0.5, 0.3], 1e-3, 0.01, 32)
}

/// A deformed sheet in motion.
fn disturbed(units: &Units) -> Sheet {
    let mut cloth = Sheet::lay(units, units.point([0.0; 3]));
    for (k, node) in Grid::<f64, 6, 5>::nodes().enumerate() {
        let k = k as f64;
        cloth.position.add(node, Vec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin()) * 0.1);
        cloth.velocity.set(node, Vec3::new((0.9 * k).cos(), (1.7 * k).sin(), (2.3 * k).cos()) * 0.05);
    }
    cloth
}

fn energy(cloth: &Sheet, units: &Units, links: &Knight<f64>) -> f64 {
    measure::kinetic_energy(cloth, units) + measure::elastic_energy(cloth, units, links)
}

fn angular_momentum(cloth: &Sheet) -> Vec3<f64> {
    let pairs = cloth.position.values().zip(cloth.velocity.values());
    pairs.fold(Vec3::ZERO, |sum, (x, v)| sum + x.cross(v))
}

/// The energies at the start and after each of a hundred frames, and the states before and after.
fn play(stiffness: f64, damping: f64) -> (Vec<f64>, Sheet, Sheet) {
    let units = units();
    let start = disturbed(&units);
    let mut cloth = start;
    let scene = Scene::new(&units, (), Knight::new(&units, stiffness, damping), (), Leapfrog);
    let mut memory = scene.memory();
    let mut energies = vec![energy(&cloth, &units, &scene.links)];
    for _ in 0..100 {
        scene.step(&mut cloth, &mut memory);
        energies.push(energy(&cloth, &units, &scene.links));
    }
    (energies, start, cloth)
}

#[test]
fn links_of_ones_own_keep_energy_and_both_momenta() {
    let (energies, start, end) = play(20.0, 0.0);
    let units = units();
    for energy in &energies {
        assert!((energy / energies[0] - 1.0).abs() < 2e-3, "energy {energy} from {}", energies[0]);
    }
    let [before, after] = [start, end].map(|cloth| measure::momentum(&cloth, &units));
    (0..3).for_each(|k| assert!((before[k] - after[k]).abs() < 1e-15, "momentum {before:?} became {after:?}"));
    let [before, after] = [start, end].map(|cloth| angular_momentum(&cloth));
    assert!((before - after).length() < 1e-11, "angular momentum {before:?} became {after:?}");
    assert!((end.position.0[0].at(0) - start.position.0[0].at(0)).length() > 0.05, "the sheet does not move");
}

#[test]
fn dampers_of_ones_own_take_energy_and_keep_momentum() {
    let (energies, start, end) = play(20.0, 0.02);
    let units = units();
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0]), "{energies:?}");
    // the remaining energy is that of the sheet's drift and spin
    assert!(energies[100] < 0.1 * energies[0], "{} of {}", energies[100], energies[0]);
    let [before, after] = [start, end].map(|cloth| measure::momentum(&cloth, &units));
    (0..3).for_each(|k| assert!((before[k] - after[k]).abs() < 1e-15, "momentum {before:?} became {after:?}"));
    let strain = measure::strain(&end, &Knight::new(&units, 20.0, 0.0));
    assert!(strain.largest < 1e-2, "{strain:?}");
}

/// Links that show more directions than their type declares.
struct Modest<S: Scalar>(Knight<S>);

impl<S: Scalar> Links<S> for Modest<S> {
    type Directions = Directions<3>;
    type Damping = Undamped;

    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        self.0.springs(visitor);
    }
}

/// Links that show dampers, although their type declares none.
struct Secret<S: Scalar>(Knight<S>);

impl<S: Scalar> Links<S> for Secret<S> {
    type Directions = Directions<4>;
    type Damping = Undamped;

    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        self.0.springs(visitor);
    }

    fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
        self.0.dampers(visitor);
    }
}

#[test]
#[should_panic = "links show more directions than `Directions` says"]
fn links_that_show_too_much_are_refused() {
    let units = units();
    Scene::new(&units, (), Modest(Knight::new(&units, 20.0, 0.0)), (), Leapfrog).memory::<f64, 6, 5>();
}

#[test]
#[should_panic = "links show dampers, and `Damping` says `Undamped`"]
fn dampers_that_are_not_declared_are_refused() {
    let units = units();
    Scene::new(&units, (), Secret(Knight::new(&units, 20.0, 0.1)), (), Leapfrog).memory::<f64, 6, 5>();
}

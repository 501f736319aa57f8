//! An outsider's solver: semi-implicit Euler, `v' = v + h·a(x)`, `x' = x + h·v'`.

use kerchief::force::{Force, Row};
use kerchief::link::{Family, Links, Visitor, each};
use kerchief::solver::{Physics, Stateless};
use kerchief::{
    Cloth, Collider, Damped, Gravity, Grid, Leapfrog, Moment, Node, Particles, Q13, Q24, Scalar, Scene, Solver, Sphere,
    Stretch, Units, Vec3, Vectors, Xpbd, measure,
};

/// The solver with all stages written by hand, or made of the crate's own stages.
#[derive(Clone, Copy)]
enum SemiImplicitEuler {
    ByHand,
    ByStages,
}

impl<S: Scalar> Solver<S> for SemiImplicitEuler {
    /// The velocities that particles gain in a substep.
    type Memory<L: Links<S>, const W: usize, const H: usize> = Vectors<S, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        Vectors::filled(Vec3::ZERO)
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        gain: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        match self {
            Self::ByHand => gains(physics, particles, moment, gain),
            Self::ByStages => physics.gains(particles, moment, gain),
        }
        for node in Grid::<S, W, H>::nodes() {
            particles.velocity.add(node, gain.at(node));
            particles.position.add(node, moment.displacement(particles.velocity.at(node)));
        }
        match self {
            Self::ByHand => confine(physics, particles, moment),
            Self::ByStages => physics.confine(particles, moment),
        }
    }
}

/// The velocities that free particles gain from forces and springs.
fn gains<S: Scalar, F: Force<S>, L: Links<S>, C, const W: usize, const H: usize>(
    physics: Physics<'_, F, L, C>,
    particles: &Particles<S, W, H>,
    moment: Moment,
    gain: &mut Vectors<S, W, H>,
) {
    *gain = Vectors::filled(Vec3::ZERO);
    for (index, gain) in gain.0.iter_mut().enumerate() {
        let (position, velocity) = (&particles.position.0[index], &particles.velocity.0[index]);
        let inverse_mass = &particles.inverse_mass.0[index];
        physics.forces.particles(Row { index, position, velocity, inverse_mass }, gain);
    }
    physics.links.springs(&mut Pull { particles, gain, moment });
    for node in Grid::<S, W, H>::nodes() {
        let own = gain.at(node) * particles.inverse_mass[node] + physics.forces.uniform();
        gain.set(node, if particles.is_pinned(node) { Vec3::ZERO } else { own });
    }
}

/// Moves free particles out of colliders.
fn confine<S: Scalar, F, L, C: Collider<S>, const W: usize, const H: usize>(
    physics: Physics<'_, F, L, C>,
    particles: &mut Particles<S, W, H>,
    moment: Moment,
) {
    for node in Grid::<S, W, H>::nodes().filter(|node| !particles.is_pinned(*node)).collect::<Vec<_>>() {
        let moved = moment.displacement(particles.velocity.at(node));
        if let Some(contact) = physics.colliders.contact(moment, particles.position.at(node), moved) {
            particles.displace(node, contact.by, moment);
        }
    }
}

struct Pull<'a, S, const W: usize, const H: usize> {
    particles: &'a Particles<S, W, H>,
    gain: &'a mut Vectors<S, W, H>,
    moment: Moment,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Pull<'_, S, W, H> {
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        each::<ACROSS, DOWN, W, H>(|a, b| {
            let d = self.particles.position.at(b) - self.particles.position.at(a);
            let pull = d * (S::elongation(d.squared(), &family.rest) * family.strength.value());
            self.gain.add(a, self.moment.velocity(pull));
            self.gain.add(b, -(self.moment.velocity(pull)));
        });
    }
}

fn units(substeps: u32) -> Units {
    Units::sheet([5, 5], [0.4, 0.4], 1e-3, 0.02, substeps)
}

fn gravity(units: &Units) -> Gravity<f64> {
    Gravity::new(units.acceleration([0.0, 0.0, -9.81]))
}

/// Semi-implicit Euler falls by `x = −g·h²·n·(n+1)/2` in n steps.
#[test]
fn a_solver_of_ones_own_falls_as_its_equation_says() {
    let units = units(4);
    let mut cloth = Cloth::<f64, 5, 5>::lay(&units, units.point([0.0; 3]));
    let stretch = Stretch::new(&units, units.stiffness(20.0));
    let scene = Scene::new(&units, gravity(&units), stretch, (), SemiImplicitEuler::ByHand);
    let mut memory = scene.memory();
    for frame in 1..=25 {
        scene.step(&mut cloth, &mut memory);
        let (n, h) = (f64::from(4 * frame), units.substep());
        let expected = -9.81 * h * h * n * (n + 1.0) / 2.0;
        for bound in measure::bounds(&cloth) {
            assert!((bound.z * units.cell - expected).abs() < 1e-13, "frame {frame}: {bound:?}");
        }
    }
}

/// The position after half a second of the corner opposite to the one from which a sheet hangs, cells.
fn swing<V: Solver<f64>>(solver: V, substeps: u32) -> Vec3<f64> {
    let units = units(substeps);
    let mut cloth = Cloth::<f64, 5, 5>::lay(&units, units.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    let stretch = Stretch::new(&units, units.stiffness(20.0));
    let scene = Scene::new(&units, gravity(&units), stretch, (), solver);
    let mut memory = scene.memory();
    (0..25).for_each(|_| scene.step(&mut cloth, &mut memory));
    cloth.position.at(Node::new(4, 4))
}

#[test]
fn a_solver_of_ones_own_converges_in_first_order() {
    let exact = swing(Leapfrog, 1024);
    let errors = [64, 128, 256].map(|substeps| (swing(SemiImplicitEuler::ByHand, substeps) - exact).length());
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((1.7..2.3).contains(&ratio), "errors {errors:?}");
    }
}

#[test]
fn a_solver_of_ones_own_meets_colliders() {
    let units = units(16);
    let mut cloth = Cloth::<f64, 5, 5>::lay(&units, units.point([-0.2, -0.2, 0.0]));
    let ball = Sphere::new(units.point([0.0, 0.0, -0.3]), units.length(0.2), units.length(0.0));
    let stretch = Stretch::new(&units, units.stiffness(20.0));
    let scene = Scene::new(&units, gravity(&units), stretch, ball, SemiImplicitEuler::ByHand);
    let mut memory = scene.memory();
    let mut touched = false;
    for _ in 0..15 {
        scene.step(&mut cloth, &mut memory);
        for position in cloth.position.values() {
            let distance = (position - ball.centre).length() * units.cell;
            assert!(distance > 0.2 - 1e-12, "{distance} m from the centre");
            touched |= distance < 0.2 + 1e-9;
        }
    }
    assert!(touched, "the sheet does not reach the ball");
}

#[test]
fn stages_are_what_an_outsider_writes_by_hand() {
    let [stages, by_hand] = [SemiImplicitEuler::ByStages, SemiImplicitEuler::ByHand].map(|solver| swing(solver, 64));
    assert!((stages - by_hand).length() < 1e-12, "{stages:?} {by_hand:?}");
}

/// XPBD made of the crate's own stages, for a sheet without drag.
struct Projected;

impl<S: Scalar> Solver<S> for Projected {
    type Memory<L: Links<S>, const W: usize, const H: usize> = Stateless<S, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Stateless<S, W, H> {
        Stateless::new()
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        _memory: &mut Stateless<S, W, H>,
        moment: Moment,
    ) {
        physics.damp(particles);
        physics.predict(particles, moment, |velocity, gain| velocity + gain);
        physics.sweep(particles, moment, 1);
        physics.confine(particles, moment);
    }
}

#[test]
fn stages_make_the_crates_own_solver() {
    fn digest<S: Scalar>(solver: impl Solver<S>) -> u32 {
        let units = units(8);
        let mut cloth = Cloth::<S, 5, 5>::lay(&units, units.point([-0.2, -0.2, 0.0]));
        cloth.pin(Node::new(0, 0));
        let forces = Gravity::new(units.acceleration([0.0, 0.0, -9.81]));
        let links = Damped::new(Stretch::new(&units, units.stiffness(20.0)), units.damping(1e-3));
        let ball = Sphere::new(units.point([0.0, 0.0, -0.3]), units.length(0.2), units.length(0.0));
        let scene = Scene::new(&units, forces, links, ball, solver);
        let mut memory = scene.memory();
        (0..25).for_each(|_| scene.step(&mut cloth, &mut memory));
        measure::digest(&cloth)
    }
    assert_eq!(digest::<f32>(Projected), digest::<f32>(Xpbd));
    assert_eq!(digest::<f64>(Projected), digest::<f64>(Xpbd));
    assert_eq!(digest::<Q24>(Projected), digest::<Q24>(Xpbd));
    assert_eq!(digest::<Q13>(Projected), digest::<Q13>(Xpbd));
}

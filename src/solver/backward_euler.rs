//! Backward Euler: `x' = x + h·v'`, `v' = v + h·a(x', v')` (thesis, equation 4.10), solved by Newton's method and conjugate gradients.
//!
//! With the prediction x̂ and a correction c, so that `x' = x̂ + c`, a step is the root of
//!
//! `R(c) = −M·c + h²·f(x̂ + c) = 0`,
//!
//! and Newton's step solves `(M + h²·K)·Δ = R` with the stiffness of a link between unit vectors n (D. Baraff, A. Witkin, *Large steps in
//! cloth simulation*, 1998; K.-J. Choi, H.-S. Ko, *Stable but responsive cloth*, 2002)
//!
//! `K = k·(n·nᵀ + max(0, 1 − L/|d|)·(I − n·nᵀ))`,
//!
//! positive definite because the sideways stiffness of a compressed link, which is negative, is left out. This changes the iterations, not the root.

mod gradients;

use crate::collider::Collider;
use crate::force::Force;
use crate::grid::{Grid, Node, each_node};
use crate::link::{Damping, Family, Links, OneByOne, Order, Visitor, fits, one_by_one};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::{Physics, Solver, one_step};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// Backward Euler, first order, stable for any stiffness and step; it damps vibrations that it can't resolve (thesis, equation 4.10).
///
/// Wind acts with its strength at the start of the substep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BackwardEuler {
    /// Newton steps in a substep, at least one. One step linearises the forces once, as Baraff and Witkin do; three reach the root for usual steps.
    pub newton_steps: u32,
}

impl BackwardEuler {
    /// One Newton step.
    pub const fn new() -> Self {
        Self { newton_steps: 1 }
    }
}

impl Default for BackwardEuler {
    fn default() -> Self {
        Self::new()
    }
}

/// The five vectors of Newton's method and conjugate gradients.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "S: Scalar + serde::Deserialize<'de>")))]
pub struct BackwardEulerMemory<S, const W: usize, const H: usize> {
    correction: Vectors<S, W, H>,
    step: Vectors<S, W, H>,
    residual: Vectors<S, W, H>,
    direction: Vectors<S, W, H>,
    product: Vectors<S, W, H>,
}

impl<S: Scalar> Solver<S> for BackwardEuler {
    type Memory<L: Links<S>, const W: usize, const H: usize> = BackwardEulerMemory<S, W, H>;

    #[track_caller]
    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        assert!(self.newton_steps > 0, "backward Euler needs one Newton step at least");
        let zero = Vectors::filled(Vec3::ZERO);
        BackwardEulerMemory { correction: zero, step: zero, residual: zero, direction: zero, product: zero }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        let shift = moment.shift;
        let inertia = S::ONE + physics.forces.drag().rate;
        let slowed = S::ONE.divide(inertia);
        one_step::predict(
            physics.forces,
            particles,
            |velocity, gain| {
                if F::DRAG { (velocity + gain) * slowed } else { velocity + gain }
            },
            |position, velocity| [position + moment.displacement(velocity), velocity],
        );
        let system = System { inertia, scale: scale::<S, W, H>(physics.links) };
        let heaviest = system.heaviest(particles);
        memory.correction = Vectors::filled(Vec3::ZERO);
        for _ in 0..self.newton_steps {
            system.residual(physics.links, particles, memory, shift);
            gradients::solve(memory, heaviest, |direction, product| {
                system.multiply(physics.links, particles, direction, product);
            });
            each_node::<W, H>(|node| {
                let step = memory.step.at(node);
                memory.correction.add(node, step);
                particles.displace(node, step, moment);
            });
        }
        physics.confine(particles, moment);
    }
}

/// The linear system, divided by the largest κ if that exceeds one, so that its numbers fit fixed point.
struct System<S> {
    /// 1 + γ·h: drag adds to inertia.
    inertia: S,
    scale: S,
}

impl<S: Scalar> System<S> {
    fn mass<const W: usize, const H: usize>(&self, particles: &Particles<S, W, H>, node: Node) -> S {
        (self.scale * self.inertia).divide(particles.inverse_mass[node])
    }

    fn heaviest<const W: usize, const H: usize>(&self, particles: &Particles<S, W, H>) -> S {
        let masses = Grid::<S, W, H>::nodes().filter(|&node| !particles.is_pinned(node));
        masses.map(|node| self.mass(particles, node)).fold(S::ZERO, S::max)
    }

    /// κ over the largest κ.
    fn stiffness(&self, family: &Family<S>) -> S {
        let quotient = family.strength;
        if quotient.divisor <= self.scale {
            quotient.dividend
        } else {
            quotient.dividend * self.scale.divide(quotient.divisor)
        }
    }

    fn residual<L: Links<S>, const W: usize, const H: usize>(
        &self,
        links: &L,
        particles: &Particles<S, W, H>,
        memory: &mut BackwardEulerMemory<S, W, H>,
        shift: u32,
    ) {
        each_node::<W, H>(|node| {
            memory.residual.set(
                node,
                if particles.is_pinned(node) {
                    Vec3::ZERO
                } else {
                    -(memory.correction.at(node) * self.mass(particles, node))
                },
            );
        });
        links.springs(&mut Pull { system: self, particles, residual: &mut memory.residual });
        if L::Damping::ANY {
            links.dampers(&mut Brake { system: self, particles, residual: &mut memory.residual, shift });
        }
        clear_pins(particles, &mut memory.residual);
    }

    fn multiply<L: Links<S>, const W: usize, const H: usize>(
        &self,
        links: &L,
        particles: &Particles<S, W, H>,
        direction: &Vectors<S, W, H>,
        product: &mut Vectors<S, W, H>,
    ) {
        each_node::<W, H>(|node| {
            product.set(
                node,
                if particles.is_pinned(node) { Vec3::ZERO } else { direction.at(node) * self.mass(particles, node) },
            );
        });
        links.springs(&mut Stiffness { system: self, particles, direction, product });
        if L::Damping::ANY {
            links.dampers(&mut Viscosity { system: self, direction, product });
        }
        clear_pins(particles, product);
    }
}

fn clear_pins<S: Scalar, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    vector: &mut Vectors<S, W, H>,
) {
    each_node::<W, H>(|node| {
        if particles.is_pinned(node) {
            vector.set(node, Vec3::ZERO);
        }
    });
}

/// min(1, 1/κ) over all families and dampers that have a link. κ counts as a million at most, which single precision still resolves, or as 65 536 in fixed point: there, a force
/// of one last place moves a particle by 0.004 cells.
fn scale<S: Scalar, const W: usize, const H: usize>(links: &impl Links<S>) -> S {
    struct Stiffest<S, const W: usize, const H: usize>(S);
    impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Stiffest<S, W, H> {
        fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
            if fits::<ACROSS, DOWN, W, H>() {
                self.0 = self.0.min(family.strength.divisor);
            }
        }
    }
    let mut stiffest = Stiffest::<S, W, H>(S::ONE);
    links.springs(&mut stiffest);
    links.dampers(&mut stiffest);
    stiffest.0.max(S::from_f64(S::LEAST_SOFTNESS))
}

/// Adds spring forces.
struct Pull<'a, S, const W: usize, const H: usize> {
    system: &'a System<S>,
    particles: &'a Particles<S, W, H>,
    residual: &'a mut Vectors<S, W, H>,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Pull<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Pull<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let stiffness = self.system.stiffness(family);
        order.each::<W, H>(|a, b| {
            let d = self.particles.position.at(b) - self.particles.position.at(a);
            let pull = d * (S::elongation(d.squared(), &family.rest) * stiffness);
            self.residual.add(a, pull);
            self.residual.add(b, -pull);
        });
    }
}

/// Adds damper forces.
struct Brake<'a, S, const W: usize, const H: usize> {
    system: &'a System<S>,
    particles: &'a Particles<S, W, H>,
    residual: &'a mut Vectors<S, W, H>,
    shift: u32,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Brake<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Brake<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let damping = self.system.stiffness(family);
        order.each::<W, H>(|a, b| {
            let pull = (self.particles.velocity.at(b) - self.particles.velocity.at(a)).halve(self.shift) * damping;
            self.residual.add(a, pull);
            self.residual.add(b, -pull);
        });
    }
}

/// Multiplies by the springs' stiffness.
struct Stiffness<'a, S, const W: usize, const H: usize> {
    system: &'a System<S>,
    particles: &'a Particles<S, W, H>,
    direction: &'a Vectors<S, W, H>,
    product: &'a mut Vectors<S, W, H>,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Stiffness<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Stiffness<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let stiffness = self.system.stiffness(family);
        let inverse_length = family.rest.inverse;
        order.each::<W, H>(|a, b| {
            let d = self.particles.position.at(b) - self.particles.position.at(a);
            let elongation = S::elongation(d.squared(), &family.rest);
            let normal = d * ((S::ONE - elongation) * inverse_length);
            let sideways = elongation.max(S::ZERO);
            let change = self.direction.at(b) - self.direction.at(a);
            let along = normal * normal.dot(change);
            let pull = (along * (S::ONE - sideways) + change * sideways) * stiffness;
            self.product.add(a, -pull);
            self.product.add(b, pull);
        });
    }
}

/// Multiplies by the dampers' strength.
struct Viscosity<'a, S, const W: usize, const H: usize> {
    system: &'a System<S>,
    direction: &'a Vectors<S, W, H>,
    product: &'a mut Vectors<S, W, H>,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Viscosity<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Viscosity<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let damping = self.system.stiffness(family);
        order.each::<W, H>(|a, b| {
            let pull = (self.direction.at(b) - self.direction.at(a)) * damping;
            self.product.add(a, -pull);
            self.product.add(b, pull);
        });
    }
}

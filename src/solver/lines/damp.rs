//! Dampers by the rule in time that the springs follow.
//!
//! A damper acts twice. Before the springs it takes the relative velocity at the substep's start, after them it adds a part of what is missing with the one
//! at the end; either act moves particles too, as every force does. For a damping κ = d·h/m that part is 1/(1 + κ·Σw)²: second order where κ is small, while
//! strong dampers leave to the springs what these have put right.

use crate::grid::Node;
use crate::link::{Family, Visitor, each};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// Which of its acts a damper is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Act {
    /// Before the springs.
    First,
    /// After the springs.
    Second,
}

/// Lets dampers act.
pub(super) struct Damp<'a, S, const W: usize, const H: usize> {
    pub(super) particles: &'a mut Particles<S, W, H>,
    /// The velocities at the substep's start.
    pub(super) start: &'a Vectors<S, W, H>,
    pub(super) moment: Moment,
    /// How a position depends on its velocity, in units of h.
    pub(super) part: S,
    /// How a velocity depends on its acceleration, in units of h.
    pub(super) response: S,
    pub(super) act: Act,
}

impl<S: Scalar, const W: usize, const H: usize> Damp<'_, S, W, H> {
    #[inline]
    fn accelerate(&mut self, node: Node, by: Vec3<S>) {
        self.particles.velocity.add(node, by);
        self.particles.position.add(node, self.moment.displacement(by * self.part));
    }
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Damp<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let act = self.act;
        let strength = family.strength.scaled(self.response);
        // the parts of the relative velocities at the start and at the end that an act takes
        let parts = |inverse_mass: S| {
            // small enough for all dampers of a particle at once: none sees what the others do
            let first = strength.against(inverse_mass.times(8));
            if act == Act::First {
                return [first, S::ZERO];
            }
            let left = strength.divisor.divide(strength.divisor + strength.dividend * inverse_mass);
            [-(first * left * left), strength.against(inverse_mass) * left]
        };
        // nearly all links join two ordinary particles
        let two = S::ONE + S::ONE;
        let ordinary = parts(two);
        each::<ACROSS, DOWN, W, H>(|a, b| {
            let (wa, wb) = (self.particles.inverse_mass[a], self.particles.inverse_mass[b]);
            let inverse_mass = wa + wb;
            if inverse_mass == S::ZERO {
                return;
            }
            let [at_start, at_end] = if inverse_mass == two { ordinary } else { parts(inverse_mass) };
            let mut by = (self.start.at(b) - self.start.at(a)) * at_start;
            if act == Act::Second {
                by += (self.particles.velocity.at(b) - self.particles.velocity.at(a)) * at_end;
            }
            self.accelerate(a, by * wa);
            self.accelerate(b, -(by * wb));
        });
    }
}

//! Dampers at the substep's end, by the rule in time that the springs follow.
//!
//! They act on the velocities that the springs leave, and what they change moves particles too. Acting on velocities before the step they would count one
//! and a half times, because the rule extrapolates these.

use crate::cloth::Cloth;
use crate::grid::Node;
use crate::link::{Family, Visitor, each};
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// Lets dampers act one after the other and implicitly, so that no strength overshoots.
pub(super) struct Damp<'a, S, const W: usize, const H: usize> {
    pub(super) cloth: &'a mut Cloth<S, W, H>,
    pub(super) moment: Moment,
    /// How a position depends on its velocity, in units of h.
    pub(super) part: S,
    /// How a velocity depends on its acceleration, in units of h.
    pub(super) response: S,
}

impl<S: Scalar, const W: usize, const H: usize> Damp<'_, S, W, H> {
    #[inline]
    fn accelerate(&mut self, node: Node, by: Vec3<S>) {
        self.cloth.velocity[node] += by;
        self.cloth.position[node] += self.moment.displacement(by * self.part);
    }
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Damp<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let strength = family.strength.scaled(self.response);
        each::<ACROSS, DOWN, W, H>(|a, b| {
            let (wa, wb) = (self.cloth.inverse_mass[a], self.cloth.inverse_mass[b]);
            let by = (self.cloth.velocity[b] - self.cloth.velocity[a]) * strength.against(wa + wb);
            self.accelerate(a, by * wa);
            self.accelerate(b, -(by * wb));
        });
    }
}

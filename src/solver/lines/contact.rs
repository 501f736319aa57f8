//! Contacts in the two-step rule.
//!
//! The rule adds (v − v₋)/3 to a velocity, so it would throw back a particle that a surface has just stopped. A contact therefore changes the previous velocity by the same
//! amount, as if the particle had been that slow all the time. In equilibrium, the contact then balances the other forces exactly, as a force would.
//!
//! A particle is moved out by its depth d, and its approach velocity is reduced by at most 2·d/h: an acceleration that moves a particle by d within a substep makes it no
//! faster. A particle that comes in faster needs a substep or two to stop, and none is thrown back. Friction is Coulomb's, on displacements and on velocities.

use crate::collider::{Collider, Contact, Meeting, friction_limited, shared, touch};
use crate::grid::Node;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::aside::{give_back, set_aside};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// Colliders, and the state of a substep that a contact reads and changes.
pub(super) struct Contacts<'a, S, C, const W: usize, const H: usize> {
    pub(super) colliders: &'a C,
    /// The positions at the start of the substep; `None` without colliders.
    pub(super) start: Option<&'a Vectors<S, W, H>>,
    /// The velocities at the start of the substep.
    pub(super) earlier: &'a mut Vectors<S, W, H>,
    pub(super) moment: Moment,
}

impl<S: Scalar, C: Collider<S>, const W: usize, const H: usize> Contacts<'_, S, C, W, H> {
    /// Moves every free particle out of the colliders. In fixed point, velocities may be set `aside`, as between the sweeps.
    #[inline(always)]
    pub(super) fn resolve(&mut self, particles: &mut Particles<S, W, H>, aside: bool) {
        if let Some(start) = self.start {
            if self.colliders.meets() {
                let earlier = &mut *self.earlier;
                self.colliders.meet(particles, &mut TwoStep { start, earlier, moment: self.moment, aside });
            }
            resolve(self.colliders, particles, start, self.earlier, self.moment, aside);
        }
    }
}

/// Moves every free particle out of `colliders`. The substep started at the positions `start` and velocities `earlier`. In fixed point, velocities may be set
/// `aside`, as between the sweeps.
#[inline]
fn resolve<S: Scalar, C: Collider<S>, const W: usize, const H: usize>(
    colliders: &C,
    particles: &mut Particles<S, W, H>,
    start: &Vectors<S, W, H>,
    earlier: &mut Vectors<S, W, H>,
    moment: Moment,
    aside: bool,
) {
    touch(
        colliders,
        particles,
        moment,
        |particles, node| particles.position.at(node) - start.at(node),
        |particles, node, contact| {
            let velocity = velocity(particles, node, moment, aside);
            let by = impulse(&contact, velocity, moment);
            let position = particles.position.at(node) + contact.by;
            place(particles, node, position, velocity + by, moment, aside);
            earlier.add(node, by);
        },
    );
}

/// A particle's velocity, given back if it is set `aside`.
#[inline(always)]
fn velocity<S: Scalar, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    node: Node,
    moment: Moment,
    aside: bool,
) -> Vec3<S> {
    let velocity = particles.velocity.at(node);
    if aside { give_back(velocity, particles.position.at(node), moment) } else { velocity }
}

/// Gives a particle a position and a velocity, which is set `aside` if asked for.
#[inline(always)]
fn place<S: Scalar, const W: usize, const H: usize>(
    particles: &mut Particles<S, W, H>,
    node: Node,
    position: Vec3<S>,
    velocity: Vec3<S>,
    moment: Moment,
    aside: bool,
) {
    particles.position.set(node, position);
    particles.velocity.set(node, if aside { set_aside(velocity, position, moment) } else { velocity });
}

/// Two particles hit each other if they approach by more than this in a substep, cells. Slower ones lie on each other.
const IMPACT: f64 = 1.0 / 16.0;

/// Contacts between particles. Two that lie on each other are moved as by a link, which in equilibrium balances the other forces. Two that hit each other are stopped as by a
/// surface, and their previous velocities change, too: otherwise the rule would throw them back faster than they came. Backward Euler uses no previous velocity.
struct TwoStep<'a, S, const W: usize, const H: usize> {
    start: &'a Vectors<S, W, H>,
    earlier: &'a mut Vectors<S, W, H>,
    moment: Moment,
    aside: bool,
}

impl<S: Scalar, const W: usize, const H: usize> Meeting<S, W, H> for TwoStep<'_, S, W, H> {
    fn moment(&self) -> Moment {
        self.moment
    }

    #[inline(always)]
    fn moved(&self, particles: &Particles<S, W, H>, node: Node) -> Vec3<S> {
        particles.position.at(node) - self.start.at(node)
    }

    #[inline(always)]
    fn separate(&mut self, particles: &mut Particles<S, W, H>, [i, j]: [Node; 2], contact: &Contact<S>) {
        let Self { moment, aside, .. } = *self;
        let masses = [i, j].map(|node| particles.inverse_mass[node]);
        let [velocity, surface] = [i, j].map(|node| self::velocity(particles, node, moment, aside));
        let [to_i, to_j] = shared(contact.by, masses);
        let approach = (surface - velocity).dot(contact.normal);
        let fast = self.moment.halves != 2 && approach.halve(self.moment.shift) > S::from_f64(IMPACT);
        let gain = if fast {
            impulse(&Contact { velocity: surface, ..*contact }, velocity, self.moment)
        } else {
            self.moment.velocity(contact.by)
        };
        let [gain_i, gain_j] = shared(gain, masses);
        for (node, velocity, to, gain) in [(i, velocity, to_i, gain_i), (j, surface, -to_j, -gain_j)] {
            let position = particles.position.at(node) + to;
            place(particles, node, position, velocity + gain, moment, aside);
            if fast {
                self.earlier.add(node, gain);
            }
        }
    }
}

/// The velocity change by a contact.
fn impulse<S: Scalar>(contact: &Contact<S>, velocity: Vec3<S>, moment: Moment) -> Vec3<S> {
    let Contact { normal, depth, friction, velocity: surface, .. } = *contact;
    let against = velocity - surface;
    let approach = -against.dot(normal);
    if approach <= S::ZERO {
        return Vec3::ZERO;
    }
    // halved, so that it fits every number type
    let shift = moment.shift + 1;
    let stop = if approach.halve(shift) <= depth { approach } else { depth.double(shift) };
    if friction == S::ZERO {
        return normal * stop;
    }
    normal * stop - friction_limited(against, normal, S::narrow(friction.product(stop)))
}

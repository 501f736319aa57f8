//! Contacts in a rule of two steps.
//!
//! A particle that a surface has stopped must not go on as its history says: the rule takes (v − v₋)/3 of it along and would throw the particle back. So what a
//! contact does to a velocity it does to the one before, too, as if the particle had been as slow all the time. In balance the contact then takes
//! just what the other forces give, and stands for a force as all of them do.
//!
//! A particle is moved out by its depth d and stopped, as far as an acceleration that moved it by d within a substep can have made it fast: by 2·d/h. What
//! comes in faster needs a substep or two, and none is thrown back. Friction is Coulomb's, of displacements and of velocities.

use crate::collider::{Collider, Contact, Meeting, friction_limited, shared, touch};
use crate::grid::Node;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::aside::{give_back, set_aside};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// Colliders, and what a contact with them needs to know and to change.
pub(super) struct Contacts<'a, S, C, const W: usize, const H: usize> {
    pub(super) colliders: &'a C,
    /// Where the substep started; nothing where nothing is in the way.
    pub(super) start: Option<&'a Vectors<S, W, H>>,
    /// The velocities before it.
    pub(super) earlier: &'a mut Vectors<S, W, H>,
    pub(super) moment: Moment,
}

impl<S: Scalar, C: Collider<S>, const W: usize, const H: usize> Contacts<'_, S, C, W, H> {
    /// Moves every free particle out of the colliders. In fixed point velocities may be set `aside`, as between the sweeps.
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

/// Moves every free particle out of `colliders`. The substep started at the positions `start` and velocities `earlier`; in fixed point velocities may be set
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

/// A particle's velocity, which may be set `aside`.
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

/// Gives a particle a position and a velocity, to be set `aside` or not.
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

/// How far particles come together in a substep that hit each other, cells. Slower ones lie on each other.
const IMPACT: f64 = 1.0 / 16.0;

/// Particles that meet each other. Those that lie on each other are moved as a link moves them, which in balance is just what other forces ask for. Those that hit each
/// other are stopped as by a surface, and their history with them: else the rule would throw them back faster than they came. Backward Euler looks back to no history.
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

/// By how much a contact changes a velocity.
fn impulse<S: Scalar>(contact: &Contact<S>, velocity: Vec3<S>, moment: Moment) -> Vec3<S> {
    let Contact { normal, depth, friction, velocity: surface, .. } = *contact;
    let against = velocity - surface;
    let approach = -against.dot(normal);
    if approach <= S::ZERO {
        return Vec3::ZERO;
    }
    // what is halved fits any number type
    let shift = moment.shift + 1;
    let stop = if approach.halve(shift) <= depth { approach } else { depth.double(shift) };
    if friction == S::ZERO {
        return normal * stop;
    }
    normal * stop - friction_limited(against, normal, S::narrow(friction.product(stop)))
}

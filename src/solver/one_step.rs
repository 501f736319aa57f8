//! The prediction of a substep without links by one-step rules, the first half of the constraint solvers.

use crate::force::{Force, Row};
use crate::grid::{Grid, Node};
use crate::link::{Damping, Family, Links, OneByOne, Order, Visitor, one_by_one};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// Gives every particle the velocity `next(velocity, gain)`, and then the position and velocity `go(position, velocity)`.
///
/// Row by row: the wind on a row is complete once the cells below it are done, and no later row reads it. So the wind needs two rows of memory, and acts on positions and
/// velocities of the same time.
#[inline]
pub(super) fn predict<S: Scalar, F: Force<S>, const W: usize, const H: usize>(
    forces: &F,
    particles: &mut Particles<S, W, H>,
    next: impl Fn(Vec3<S>, Vec3<S>) -> Vec3<S>,
    go: impl Fn(Vec3<S>, Vec3<S>) -> [Vec3<S>; 2],
) {
    let (is_field, uniform) = (forces.is_field(), forces.uniform());
    // used in turn, so that no row is copied
    let mut gains = [Vec3::row(Vec3::ZERO); 2];
    for row in 0..H {
        let [even, odd] = &mut gains;
        let [gain, below] = if row % 2 == 0 { [even, odd] } else { [odd, even] };
        field(forces, particles, row, [gain, below]);
        for column in 0..W {
            let node = Node { column, row };
            let inverse_mass = particles.inverse_mass[node];
            let mut velocity = particles.velocity.at(node);
            if inverse_mass != S::ZERO {
                let own = |gain: Vec3<S>| {
                    if S::LOOKING_PAYS && inverse_mass == S::ONE { gain } else { gain * inverse_mass }
                };
                let gain = if is_field { own(gain.at(column)) + uniform } else { uniform };
                velocity = next(velocity, gain);
            }
            let [position, velocity] = go(particles.position.at(node), velocity);
            particles.position.set(node, position);
            particles.velocity.set(node, velocity);
        }
    }
}

/// Completes the velocity changes `gain` of a row by fields, for particles of mass 1, and sets `below` to those of the next row by the cells between the two.
#[inline]
pub(super) fn field<S: Scalar, F: Force<S>, const W: usize, const H: usize>(
    forces: &F,
    particles: &Particles<S, W, H>,
    row: usize,
    [gain, below]: [&mut Vec3<[S; W]>; 2],
) {
    if forces.is_field() {
        let at = |row: usize| Row {
            index: row,
            position: &particles.position.0[row],
            velocity: &particles.velocity.0[row],
            inverse_mass: &particles.inverse_mass.0[row],
        };
        *below = Vec3::row(Vec3::ZERO);
        forces.particles(at(row), gain);
        if row + 1 < H {
            forces.cells([at(row), at(row + 1)], [gain, below]);
        }
    }
}

/// Moves every particle with its velocity for `1/2^shift` of a tick.
#[inline]
pub(super) fn drift<S: Scalar, const W: usize, const H: usize>(particles: &mut Particles<S, W, H>, shift: u32) {
    for node in Grid::<S, W, H>::nodes() {
        particles.position.add(node, particles.velocity.at(node).halve(shift));
    }
}

/// Lets dampers act on velocities, one after the other and implicitly, so that no strength overshoots.
#[inline]
pub(super) fn damp<S: Scalar, L: Links<S>, const W: usize, const H: usize>(
    links: &L,
    particles: &mut Particles<S, W, H>,
) {
    if L::Damping::ANY {
        links.dampers(&mut Damp { particles });
    }
}

struct Damp<'a, S, const W: usize, const H: usize> {
    particles: &'a mut Particles<S, W, H>,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Damp<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Damp<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        order.each::<W, H>(|a, b| {
            let (wa, wb) = (self.particles.inverse_mass[a], self.particles.inverse_mass[b]);
            let by = (self.particles.velocity.at(b) - self.particles.velocity.at(a)) * family.strength.against(wa + wb);
            self.particles.velocity.add(a, by * wa);
            self.particles.velocity.add(b, -(by * wb));
        });
    }
}

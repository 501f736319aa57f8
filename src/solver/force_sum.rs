//! The sum of all forces at the sheet's present positions and velocities, for the explicit solvers.

use crate::force::Force;
use crate::grid::{Grid, Node};
use crate::link::{Damping, Family, Links, OneByOne, Order, Visitor, one_by_one};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::one_step::field;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// The velocity changes of particles in a substep (cells per tick), with gravity, without drag.
pub(super) fn gains<S: Scalar, F: Force<S>, L: Links<S>, const W: usize, const H: usize>(
    forces: &F,
    links: &L,
    particles: &Particles<S, W, H>,
    shift: u32,
    gain: &mut Vectors<S, W, H>,
) {
    *gain = Vectors::filled(Vec3::ZERO);
    if forces.is_field() {
        let mut row_gain = Vec3::row(Vec3::ZERO);
        for row in 0..H {
            let mut below = Vec3::row(Vec3::ZERO);
            field(forces, particles, row, [&mut row_gain, &mut below]);
            gain.0[row] = row_gain;
            row_gain = below;
        }
    }
    links.springs(&mut Springs { particles, gain, shift });
    if L::Damping::ANY {
        links.dampers(&mut Dampers { particles, gain });
    }
    let uniform = forces.uniform();
    for node in Grid::<S, W, H>::nodes() {
        let inverse_mass = particles.inverse_mass[node];
        gain.set(node, if inverse_mass == S::ZERO { Vec3::ZERO } else { gain.at(node) * inverse_mass + uniform });
    }
}

struct Springs<'a, S, const W: usize, const H: usize> {
    particles: &'a Particles<S, W, H>,
    gain: &'a mut Vectors<S, W, H>,
    shift: u32,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Springs<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Springs<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let stiffness = family.strength.value();
        order.each::<W, H>(|a, b| {
            let d = self.particles.position.at(b) - self.particles.position.at(a);
            let pull = d * (S::elongation(d.squared(), &family.rest) * stiffness);
            exchange(self.gain, a, b, pull.double(self.shift));
        });
    }
}

struct Dampers<'a, S, const W: usize, const H: usize> {
    particles: &'a Particles<S, W, H>,
    gain: &'a mut Vectors<S, W, H>,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Dampers<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Dampers<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let damping = family.strength.value();
        order.each::<W, H>(|a, b| {
            exchange(self.gain, a, b, (self.particles.velocity.at(b) - self.particles.velocity.at(a)) * damping);
        });
    }
}

#[inline]
fn exchange<S: Scalar, const W: usize, const H: usize>(gain: &mut Vectors<S, W, H>, a: Node, b: Node, by: Vec3<S>) {
    gain.add(a, by);
    gain.add(b, -by);
}

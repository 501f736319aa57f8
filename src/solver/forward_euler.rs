//! Forward Euler: `x' = x + h·v`, `v' = v + h·a(x, v)` (thesis, chapter 4).

use crate::collider::Collider;
use crate::force::Force;
use crate::grid::Grid;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::{Physics, Solver, one_step};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// Forward Euler, first order (thesis, among equations 4.7–4.13).
///
/// Its amplification of an oscillation ω is √(1 + ω²h²) > 1: without damping every motion grows, and a stiff sheet explodes. It is here for comparison with the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ForwardEuler;

impl ForwardEuler {
    /// Forward Euler.
    pub const fn new() -> Self {
        Self
    }
}

impl<S: Scalar> Solver<S> for ForwardEuler {
    /// The velocity change of every particle by forces.
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
        physics.gains(particles, moment, gain);
        one_step::drift(particles, moment.shift);
        let rate = physics.forces.drag().rate;
        for node in Grid::<S, W, H>::nodes() {
            if !particles.is_pinned(node) {
                let velocity = particles.velocity.at(node);
                particles
                    .velocity
                    .set(node, if F::DRAG { velocity - velocity * rate } else { velocity } + gain.at(node));
            }
        }
        physics.confine(particles, moment);
    }
}

//! XPBD with one sweep in each of many substeps (M. Macklin and others, *Small steps in physics simulation*, 2019).

use crate::collider::Collider;
use crate::force::Force;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::{Physics, Solver, Stateless};
use crate::vec3::Vec3;

/// Extended position-based dynamics, first order, stable for any stiffness and step.
///
/// A substep predicts, then projects every spring once with its compliance. More substeps always help more than more sweeps would.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Xpbd;

impl Xpbd {
    /// One sweep in a substep.
    pub const fn new() -> Self {
        Self
    }
}

impl<S: Scalar> Solver<S> for Xpbd {
    /// Empty.
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
        let drag = physics.forces.drag();
        physics.damp(particles);
        let next = |velocity: Vec3<S>, gain: Vec3<S>| {
            if F::DRAG { velocity * drag.decay + gain * drag.gain } else { velocity + gain }
        };
        physics.predict(particles, moment, next);
        physics.sweep(particles, moment, 1);
        physics.confine(particles, moment);
    }
}

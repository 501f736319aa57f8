//! Position Verlet with repeated relaxation (thesis, chapter 5; T. Jakobsen, *Advanced character physics*, 2001).

use crate::collider::Collider;
use crate::force::Force;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::{Physics, Solver, Stateless};
use crate::vec3::Vec3;

/// Position Verlet `x' = x + (1 − D)·(x − x_old) + h²·a` (thesis, among equations 4.7–4.13, and listing 5.5), then `sweeps` relaxations of all springs.
///
/// Position and last displacement are kept instead of two positions, which is equivalent and loses no digits. Each of the K sweeps relaxes a
/// spring with a K-th of its stiffness, so that the method approximates springs of finite stiffness for any K, in first order. Too few
/// sweeps leave a stiff sheet *super-elastic* (thesis, section 6.2): corrections propagate by one link a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verlet {
    /// Relaxations of all springs in a substep, at least one.
    pub sweeps: u32,
}

impl Verlet {
    /// Fifteen sweeps, as in the thesis.
    pub const fn new() -> Self {
        Self { sweeps: 15 }
    }
}

impl Default for Verlet {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar> Solver<S> for Verlet {
    /// Empty.
    type Memory<L: Links<S>, const W: usize, const H: usize> = Stateless<S, W, H>;

    #[track_caller]
    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Stateless<S, W, H> {
        assert!(self.sweeps > 0, "Verlet needs one sweep at least");
        Stateless::new()
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        _memory: &mut Stateless<S, W, H>,
        moment: Moment,
    ) {
        let decay = physics.forces.drag().decay;
        physics.damp(particles);
        let next = |velocity: Vec3<S>, gain: Vec3<S>| {
            if F::DRAG { velocity * decay + gain } else { velocity + gain }
        };
        physics.predict(particles, moment, next);
        physics.sweep(particles, moment, self.sweeps);
        physics.confine(particles, moment);
    }
}

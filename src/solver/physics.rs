//! The forces, links and colliders of a scene, and stages of a substep for solvers.

use crate::collider::{Collider, resolve};
use crate::force::Force;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

use super::{force_sum, one_step, sweep};

/// The forces, links and colliders that act on a sheet.
///
/// Its methods are stages of a substep, for the crate's solvers and your own. Position-based dynamics with three sweeps, without drag:
///
/// ```
/// use kerchief::link::Links;
/// use kerchief::solver::{Physics, Stateless};
/// use kerchief::*;
///
/// struct ThreeSweeps;
///
/// impl<S: Scalar> Solver<S> for ThreeSweeps {
///     type Memory<L: Links<S>, const W: usize, const H: usize> = Stateless<S, W, H>;
///
///     fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Stateless<S, W, H> {
///         Stateless::new()
///     }
///
///     fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
///         &self,
///         physics: Physics<'_, F, L, C>,
///         particles: &mut Particles<S, W, H>,
///         _memory: &mut Stateless<S, W, H>,
///         moment: Moment,
///     ) {
///         physics.damp(particles);
///         physics.predict(particles, moment, |velocity, gain| velocity + gain);
///         physics.sweep(particles, moment, 3);
///         physics.confine(particles, moment);
///     }
/// }
///
/// const SHEET: Sheet<Q24, 8, 8> = Sheet::of(&material::DENIM, [0.3, 0.3], 1.0 / 60.0, 8);
/// let mut cloth = SHEET.hang([0.0, 0.0, 0.3]);
/// let scene = SHEET.scene(SHEET.gravity([0.0, 0.0, -9.81]), SHEET.springs(&material::DENIM, 0.5), (), ThreeSweeps);
/// scene.step(&mut cloth, &mut scene.memory());
/// ```
#[derive(Debug)]
pub struct Physics<'a, F, L, C> {
    /// The external forces.
    pub forces: &'a F,
    /// The links between particles.
    pub links: &'a L,
    /// The obstacles.
    pub colliders: &'a C,
}

// not derived: a derive would ask for `Copy` of F, L and C
impl<F, L, C> Copy for Physics<'_, F, L, C> {}

impl<F, L, C> Clone for Physics<'_, F, L, C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F, L, C> Physics<'_, F, L, C> {
    /// Lets dampers act on velocities, one after the other and implicitly, so that no strength overshoots.
    #[inline]
    pub fn damp<S: Scalar, const W: usize, const H: usize>(self, particles: &mut Particles<S, W, H>)
    where
        L: Links<S>,
    {
        one_step::damp(self.links, particles);
    }

    /// Moves particles without links, to the start of a [`sweep`](Self::sweep). Each free particle gets the velocity `next(velocity, gain)`, where `gain` is its velocity change
    /// by forces in a substep (cells per tick), and moves with it. Wind acts on the positions and velocities before.
    #[inline]
    pub fn predict<S: Scalar, const W: usize, const H: usize>(
        self,
        particles: &mut Particles<S, W, H>,
        moment: Moment,
        next: impl Fn(Vec3<S>, Vec3<S>) -> Vec3<S>,
    ) where
        F: Force<S>,
        L: Links<S>,
    {
        one_step::predict(self.forces, particles, next, sweep::go::<S, L>(moment));
    }

    /// Projects every spring `parts` times, each time with one part in `parts` of its stiffness. Particles must have been [predicted](Self::predict) and not moved since: in fixed
    /// point, a prediction leaves velocities incomplete, and sweeps complete them.
    #[inline]
    pub fn sweep<S: Scalar, const W: usize, const H: usize>(
        self,
        particles: &mut Particles<S, W, H>,
        moment: Moment,
        parts: u32,
    ) where
        L: Links<S>,
    {
        sweep::sweeps(self.links, particles, moment, parts);
    }

    /// The velocity changes of free particles in a substep by forces, springs and dampers at the present positions (cells per tick), for explicit rules.
    #[inline]
    pub fn gains<S: Scalar, const W: usize, const H: usize>(
        self,
        particles: &Particles<S, W, H>,
        moment: Moment,
        gain: &mut Vectors<S, W, H>,
    ) where
        F: Force<S>,
        L: Links<S>,
    {
        force_sum::gains(self.forces, self.links, particles, moment.shift, gain);
    }

    /// Ends a substep: applies the limits of links, and moves particles out of colliders.
    #[inline]
    pub fn confine<S: Scalar, const W: usize, const H: usize>(self, particles: &mut Particles<S, W, H>, moment: Moment)
    where
        L: Links<S>,
        C: Collider<S>,
    {
        self.links.confine(particles, moment);
        resolve(self.colliders, particles, moment);
    }
}

//! The solver that a scene asks for while the program runs.

use std::boxed::Box;

use super::choice::SolverKind;
use super::description::Description;
use super::error::SceneError;
use super::fit::Fit;
use crate::cloth::Cloth;
use crate::collider::Collider;
use crate::force::Force;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::rest::{self, Threshold};
use crate::scalar::Scalar;
use crate::solver::{BackwardEuler, ForwardEuler, Leapfrog, Lines, Physics, Solver, Stateless, Verlet, Xpbd};
use crate::units::Units;

/// One of the core's solvers.
#[derive(Clone, Copy, Debug)]
pub(super) enum AnySolver {
    Verlet(Verlet),
    ForwardEuler(ForwardEuler),
    BackwardEuler(BackwardEuler),
    Leapfrog(Leapfrog),
    Xpbd(Xpbd),
    Lines(Lines),
}

type MemoryOf<V, S, L, const W: usize, const H: usize> = <V as Solver<S>>::Memory<L, W, H>;

/// The memory of [`AnySolver`], on the heap: a large grid's does not fit the stack of every thread.
pub(super) enum Memory<S: Scalar, L: Links<S>, const W: usize, const H: usize> {
    None,
    ForwardEuler(Box<MemoryOf<ForwardEuler, S, L, W, H>>),
    BackwardEuler(Box<MemoryOf<BackwardEuler, S, L, W, H>>),
    Leapfrog(Box<MemoryOf<Leapfrog, S, L, W, H>>),
    Lines(Box<MemoryOf<Lines, S, L, W, H>>),
}

impl AnySolver {
    pub(super) fn new<S: Scalar>(scene: &Description) -> Result<Self, SceneError> {
        let sweeps = scene.solver.iterations;
        Ok(match scene.solver.kind {
            SolverKind::Verlet => {
                // A sweep divides stiffness by their number.
                Fit::<S>::constant("solver.iterations", [1.0 / f64::from(sweeps)])?;
                Self::Verlet(Verlet { sweeps })
            }
            SolverKind::ForwardEuler => Self::ForwardEuler(ForwardEuler),
            SolverKind::BackwardEuler => Self::BackwardEuler(BackwardEuler { newton_steps: sweeps }),
            SolverKind::Leapfrog => Self::Leapfrog(Leapfrog),
            SolverKind::Xpbd => Self::Xpbd(Xpbd),
            SolverKind::Lines => {
                Fit::<S>::number("solver.tolerance", scene.solver.tolerance)?;
                let sweeps = scene.solver.sweeps.unwrap_or(2 * sweeps);
                Self::Lines(Lines::with_sweeps(sweeps).within(scene.solver.tolerance))
            }
        })
    }
}

impl<S: Scalar> Solver<S> for AnySolver {
    type Memory<L: Links<S>, const W: usize, const H: usize> = Memory<S, L, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Memory<S, L, W, H> {
        match self {
            Self::Verlet(_) | Self::Xpbd(_) => Memory::None,
            Self::ForwardEuler(solver) => Memory::ForwardEuler(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
            Self::BackwardEuler(solver) => Memory::BackwardEuler(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
            Self::Leapfrog(solver) => Memory::Leapfrog(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
            Self::Lines(solver) => Memory::Lines(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
        }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Memory<S, L, W, H>,
        moment: Moment,
    ) {
        match (self, memory) {
            (Self::Verlet(solver), _) => solver.substep(physics, particles, &mut Stateless::new(), moment),
            (Self::Xpbd(solver), _) => solver.substep(physics, particles, &mut Stateless::new(), moment),
            (Self::ForwardEuler(solver), Memory::ForwardEuler(memory)) => {
                solver.substep(physics, particles, memory, moment);
            }
            (Self::BackwardEuler(solver), Memory::BackwardEuler(memory)) => {
                solver.substep(physics, particles, memory, moment);
            }
            (Self::Leapfrog(solver), Memory::Leapfrog(memory)) => solver.substep(physics, particles, memory, moment),
            (Self::Lines(solver), Memory::Lines(memory)) => solver.substep(physics, particles, memory, moment),
            _ => unreachable!("a solver meets the memory it made"),
        }
    }
}

/// One of the core's solvers, which may rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct SceneSolver {
    solver: AnySolver,
    rest: Option<Threshold>,
}

impl SceneSolver {
    pub(super) fn new<S: Scalar>(scene: &Description, units: &Units) -> Result<Self, SceneError> {
        let rest = scene.rest.map(|stillness| Threshold::new(units, stillness));
        if let Some(Threshold { speed, change, .. }) = rest {
            Fit::<S>::number("rest.speed", speed)?;
            Fit::<S>::number("rest.acceleration", change)?;
        }
        Ok(Self { solver: AnySolver::new::<S>(scene)?, rest })
    }
}

impl<S: Scalar> Solver<S> for SceneSolver {
    type Memory<L: Links<S>, const W: usize, const H: usize> = rest::Memory<Memory<S, L, W, H>, S, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        rest::Memory::new(self.solver.memory())
    }

    fn frame<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        cloth: &mut Cloth<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        end: Moment,
    ) {
        match &self.rest {
            Some(threshold) => threshold.frame(&self.solver, physics, cloth, memory, end),
            None => self.solver.frame(physics, cloth, memory.solver(), end),
        }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        self.solver.substep(physics, particles, memory.solver(), moment);
    }
}

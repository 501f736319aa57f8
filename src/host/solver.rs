//! The solver of a scene, chosen at run time.

use std::boxed::Box;
use std::format;

use super::choice::SolverKind;
use super::description::{Description, SelfContact};
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
use crate::self_contact::{self, Law, Near, THINNEST, Thickness};
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

/// The memory of [`AnySolver`], on the heap: for a large grid it does not fit the stack of every thread.
pub(super) enum AnyMemory<S: Scalar, L: Links<S>, const W: usize, const H: usize> {
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
                // A sweep divides stiffness by the number of sweeps.
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
    type Memory<L: Links<S>, const W: usize, const H: usize> = AnyMemory<S, L, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> AnyMemory<S, L, W, H> {
        match self {
            Self::Verlet(_) | Self::Xpbd(_) => AnyMemory::None,
            Self::ForwardEuler(solver) => AnyMemory::ForwardEuler(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
            Self::BackwardEuler(solver) => AnyMemory::BackwardEuler(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
            Self::Leapfrog(solver) => AnyMemory::Leapfrog(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
            Self::Lines(solver) => AnyMemory::Lines(Box::new(Solver::<S>::memory::<L, W, H>(solver))),
        }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut AnyMemory<S, L, W, H>,
        moment: Moment,
    ) {
        match (self, memory) {
            (Self::Verlet(solver), _) => solver.substep(physics, particles, &mut Stateless::new(), moment),
            (Self::Xpbd(solver), _) => solver.substep(physics, particles, &mut Stateless::new(), moment),
            (Self::ForwardEuler(solver), AnyMemory::ForwardEuler(memory)) => {
                solver.substep(physics, particles, memory, moment);
            }
            (Self::BackwardEuler(solver), AnyMemory::BackwardEuler(memory)) => {
                solver.substep(physics, particles, memory, moment);
            }
            (Self::Leapfrog(solver), AnyMemory::Leapfrog(memory)) => solver.substep(physics, particles, memory, moment),
            (Self::Lines(solver), AnyMemory::Lines(memory)) => solver.substep(physics, particles, memory, moment),
            _ => unreachable!("a solver meets the memory it made"),
        }
    }
}

/// One of the core's solvers, with self-contact if the scene has it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layered<S: Scalar> {
    solver: AnySolver,
    own: Option<Law<S>>,
}

/// The memory of [`Layered`]. With self-contact, the list of parts of the sheet that are near each other is on the heap.
pub(super) struct LayeredMemory<S: Scalar, L: Links<S>, const W: usize, const H: usize> {
    solver: AnyMemory<S, L, W, H>,
    near: Option<Box<Near<W, H>>>,
}

impl<S: Scalar, L: Links<S>, const W: usize, const H: usize> LayeredMemory<S, L, W, H> {
    /// The largest number of pairs of particles in contact at once in the last frame.
    pub(super) fn contacts(&self) -> Option<u32> {
        self.near.as_ref().map(|near| near.contacts)
    }
}

impl<S: Scalar> Layered<S> {
    fn new(scene: &Description, units: &Units) -> Result<Self, SceneError> {
        let own = scene.self_contact.map(|own| law(own, units)).transpose()?;
        Ok(Self { solver: AnySolver::new::<S>(scene)?, own })
    }
}

fn law<S: Scalar>(SelfContact { thickness, friction }: SelfContact, units: &Units) -> Result<Law<S>, SceneError> {
    let thickness = thickness.unwrap_or(units.cell);
    let [least, most] = [THINNEST * units.cell, units.cell];
    if thickness < (1.0 - 1e-9) * least || thickness > (1.0 + 1e-9) * most {
        // to six digits, without the digits of a rounding error
        let [least, most] = [least, most].map(|bound| format!("{bound:.5e}").parse::<f64>().unwrap_or(bound));
        let bounds = format!("must be {least} to {most}, 0.75 to 1 of a cell's longer side, is {thickness}");
        return Err(SceneError::new("self.thickness", bounds));
    }
    Fit::<S>::constant("self.friction", [friction])?;
    Ok(Law::new(Thickness::new(units, thickness.clamp(least, most)), friction))
}

impl<S: Scalar> Solver<S> for Layered<S> {
    type Memory<L: Links<S>, const W: usize, const H: usize> = LayeredMemory<S, L, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        LayeredMemory { solver: self.solver.memory(), near: self.own.map(|_| Box::new(Near::NONE)) }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        let LayeredMemory { solver, near } = memory;
        let own = self.own.as_ref().zip(near.as_deref_mut());
        self_contact::substep(own, &self.solver, physics, particles, solver, moment);
    }
}

/// One of the core's solvers, which stops at rest if the scene has `[rest]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct SceneSolver<S: Scalar> {
    solver: Layered<S>,
    rest: Option<Threshold>,
}

impl<S: Scalar> SceneSolver<S> {
    pub(super) fn new(scene: &Description, units: &Units) -> Result<Self, SceneError> {
        let rest = scene.rest.map(|stillness| Threshold::new(units, stillness));
        if let Some(Threshold { speed, change, .. }) = rest {
            Fit::<S>::number("rest.speed", speed)?;
            Fit::<S>::number("rest.acceleration", change)?;
        }
        Ok(Self { solver: Layered::new(scene, units)?, rest })
    }
}

impl<S: Scalar> Solver<S> for SceneSolver<S> {
    type Memory<L: Links<S>, const W: usize, const H: usize> = rest::RestingMemory<LayeredMemory<S, L, W, H>, S, W, H>;

    const WHOLE_FRAMES: bool = true;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        rest::RestingMemory::new(self.solver.memory())
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

//! All solvers behind one type.

use kerchief::{BackwardEuler, ForwardEuler, Leapfrog, Lines, Scalar, Solver, Verlet, Xpbd, measure};

use super::{Pace, Rig, Springs};
use crate::reference::{Model, State};

/// A solver with its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    ForwardEuler,
    BackwardEuler,
    Leapfrog,
    /// With this number of sweeps.
    Verlet(u32),
    Xpbd,
    /// With this number of sweeps.
    Lines(u32),
}

/// All solvers with usual settings.
pub const ALL: [Method; 6] =
    [Method::ForwardEuler, Method::BackwardEuler, Method::Leapfrog, Method::Verlet(4), Method::Xpbd, Method::Lines(1)];

/// A [`Rig`] with a solver of any type.
pub trait Motion {
    /// Moves the sheet by a number of frames.
    fn run(&mut self, frames: u32);
    fn state(&self) -> State;
    fn set(&mut self, state: &State);
    /// A digest of the sheet: equal states have equal digests.
    fn digest(&self) -> u32;
}

impl<S: Scalar, V: Solver<S>, const W: usize, const H: usize> Motion for Rig<S, V, W, H> {
    fn run(&mut self, frames: u32) {
        Rig::run(self, frames);
    }

    fn state(&self) -> State {
        Rig::state(self)
    }

    fn set(&mut self, state: &State) {
        Rig::set(self, state);
    }

    fn digest(&self) -> u32 {
        measure::digest(&self.cloth)
    }
}

/// `model`, moved by a solver of the core.
pub fn moved<S: Scalar, const W: usize, const H: usize>(model: &Model, pace: Pace, method: Method) -> Box<dyn Motion> {
    match method {
        Method::ForwardEuler => rig::<S, _, W, H>(model, pace, ForwardEuler),
        Method::BackwardEuler => rig::<S, _, W, H>(model, pace, BackwardEuler { newton_steps: 3 }),
        Method::Leapfrog => rig::<S, _, W, H>(model, pace, Leapfrog),
        Method::Verlet(sweeps) => rig::<S, _, W, H>(model, pace, Verlet { sweeps }),
        Method::Xpbd => rig::<S, _, W, H>(model, pace, Xpbd),
        Method::Lines(sweeps) => rig::<S, _, W, H>(model, pace, Lines::with_sweeps(sweeps)),
    }
}

fn rig<S: Scalar, V: Solver<S> + 'static, const W: usize, const H: usize>(
    model: &Model,
    pace: Pace,
    solver: V,
) -> Box<dyn Motion>
where
    V::Memory<Springs<S>, W, H>: 'static,
{
    Box::new(Rig::<S, V, W, H>::new(model, pace, solver))
}

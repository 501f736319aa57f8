//! Ways to move a sheet, a module each. Every one approximates the same differential equation
//!
//! `m·a = m·g − m·γ·v + wind + Σ −k·(|d| − L)·d/|d| − k_d·(v_i − v_j)`
//!
//! and differs in order, cost and in how stiff a sheet may be.
//!
//! | solver | order | stable for | cost per substep | use it for |
//! |---|---|---|---|---|
//! | [`ForwardEuler`] | 1 | never without damping | one force sum | seeing why not |
//! | [`Leapfrog`] | 2 | h < 2/ω | one force sum | soft sheets, references |
//! | [`Verlet`] | 1 | any h | K sweeps | the thesis' method |
//! | [`Xpbd`] | 1 | any h | one sweep | stiff sheets, small code |
//! | [`BackwardEuler`] | 1 | any h | conjugate gradients | few large steps |
//! | [`Lines`] | 2 | any h | two sweeps, more and shorter steps where the sheet snaps taut | sheets that hardly stretch |

mod aside;
mod backward_euler;
mod force_sum;
mod forward_euler;
mod leapfrog;
mod lines;
mod one_step;
mod physics;
mod sweep;
mod unit_mass;
mod verlet;
mod xpbd;

use core::marker::PhantomData;

use crate::cloth::Cloth;
use crate::collider::Collider;
use crate::force::Force;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;

pub use backward_euler::BackwardEuler;
pub use forward_euler::ForwardEuler;
pub use leapfrog::Leapfrog;
pub use lines::{Lines, LinesMemory};
pub use physics::Physics;
pub use verlet::Verlet;
pub use xpbd::Xpbd;

/// A way to move a sheet.
pub trait Solver<S: Scalar> {
    /// What the solver remembers of a sheet with such links from substep to substep, or needs within one.
    type Memory<L: Links<S>, const W: usize, const H: usize>;

    /// Whether it decides on whole frames, in a [`frame`](Self::frame) of its own, as [`Resting`](crate::Resting) does. What works substep by substep does not stand around it.
    const WHOLE_FRAMES: bool = false;

    /// Memory for a sheet at the start of its motion.
    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H>;

    /// Moves `cloth` by the substeps of a frame up to its `end`. Cannot fail.
    #[inline]
    fn frame<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        cloth: &mut Cloth<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        end: Moment,
    ) {
        let particles: &mut Particles<S, W, H> = cloth;
        for substep in 1..=end.substep {
            self.substep(physics, particles, memory, Moment { substep, ..end });
        }
    }

    /// Moves `particles` by one substep. Cannot fail.
    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    );
}

/// The memory of a solver that needs none. It says whose it is, so that a program need not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Stateless<S, const W: usize, const H: usize>(PhantomData<S>);

impl<S, const W: usize, const H: usize> Stateless<S, W, H> {
    /// Nothing.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

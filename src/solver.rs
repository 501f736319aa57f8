//! The solvers, one module each. All approximate the same differential equation
//!
//! `m·a = m·g − m·γ·v + wind + Σ −k·(|d| − L)·d/|d| − k_d·(v_i − v_j)`
//!
//! and differ in order, cost and in the stiffness that they can take.
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

/// A method that moves a sheet.
pub trait Solver<S: Scalar> {
    /// The solver's state between substeps, and its working memory within one, for a sheet with links of type `L`.
    type Memory<L: Links<S>, const W: usize, const H: usize>;

    /// Whether the solver overrides [`frame`](Self::frame) to decide on whole frames, as [`Resting`](crate::Resting) does. A solver that works substep by substep can't wrap it.
    const WHOLE_FRAMES: bool = false;

    /// The memory for a sheet at the start of its motion.
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

/// The memory of a solver that needs none. Its type names the sheet's number type and size, so that a program need not name them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Stateless<S, const W: usize, const H: usize>(PhantomData<S>);

impl<S, const W: usize, const H: usize> Stateless<S, W, H> {
    /// An empty memory.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

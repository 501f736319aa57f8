//! The description of a simulation, and its step.

use core::marker::PhantomData;

use crate::cloth::Cloth;
use crate::collider::{Collider, Stationary};
use crate::force::Force;
use crate::grid::Node;
use crate::link::{self, Links};
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::solver::{Physics, Solver};
use crate::units::Units;
use crate::vec3::Vec3;

/// Forces, links, colliders and the solver that moves sheets among them.
///
/// A scene is configuration, and one scene moves many sheets. The state of each sheet is in its [`Cloth`] and in the solver's memory. Slots that a scene
/// doesn't need are `()` and cost nothing.
///
/// `G` says which sheets the scene accepts: [sheets of one size and number type](Only) if a [`Sheet`](crate::Sheet) made it.
#[derive(Clone, Copy, Debug)]
pub struct Scene<F, L, C, V, G = Any> {
    /// External forces.
    pub forces: F,
    /// Links between particles.
    pub links: L,
    /// Obstacles.
    pub colliders: C,
    /// The method that moves the sheet.
    pub solver: V,
    substeps: u32,
    shift: u32,
    sheets: PhantomData<G>,
}

/// The sheets that a scene accepts.
pub trait Kind<S, const W: usize, const H: usize> {}

/// Sheets of any size, in the number type of the scene's parts.
#[derive(Clone, Copy, Debug)]
pub enum Any {}

/// Sheets of `W` × `H` particles in numbers of type `S`.
#[derive(Clone, Copy, Debug)]
pub struct Only<S, const W: usize, const H: usize>(PhantomData<fn() -> S>);

impl<S, const W: usize, const H: usize> Kind<S, W, H> for Any {}
impl<S, const W: usize, const H: usize> Kind<S, W, H> for Only<S, W, H> {}

impl<F, L, C, V> Scene<F, L, C, V> {
    /// A scene in these units.
    ///
    /// # Panics
    /// At compile time in a constant: for units put together by hand that have no substeps, or more than 2²⁴.
    #[track_caller]
    pub const fn new(units: &Units, forces: F, links: L, colliders: C, solver: V) -> Self {
        Self::of(units, forces, links, colliders, solver)
    }
}

impl<F, L, C, V, G> Scene<F, L, C, V, G> {
    #[track_caller]
    pub(crate) const fn of(units: &Units, forces: F, links: L, colliders: C, solver: V) -> Self {
        units.check_substeps();
        let (substeps, shift) = (units.substeps, units.shift());
        Self { forces, links, colliders, solver, substeps, shift, sheets: PhantomData }
    }

    /// The solver's memory for a sheet at the start of its motion.
    ///
    /// # Panics
    /// If the solver's parameters are invalid (such as zero sweeps), or if links of your own show more directions or dampers than their types declare.
    #[track_caller]
    pub fn memory<S: Scalar, const W: usize, const H: usize>(&self) -> V::Memory<L, W, H>
    where
        L: Links<S>,
        V: Solver<S>,
        G: Kind<S, W, H>,
    {
        link::check(&self.links);
        self.solver.memory()
    }

    /// Moves `cloth` by one frame among colliders that stay in place. Cannot fail.
    pub fn step<S, const W: usize, const H: usize>(&self, cloth: &mut Cloth<S, W, H>, memory: &mut V::Memory<L, W, H>)
    where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S> + Stationary,
        V: Solver<S>,
        G: Kind<S, W, H>,
    {
        self.step_one(cloth, memory);
    }

    /// Moves `cloth` by one frame, then moves the colliders to the end of that frame. Cannot fail.
    pub fn play<S, const W: usize, const H: usize>(
        &mut self,
        cloth: &mut Cloth<S, W, H>,
        memory: &mut V::Memory<L, W, H>,
    ) where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>,
        G: Kind<S, W, H>,
    {
        self.step_one(cloth, memory);
        self.advance();
    }

    /// Moves one of several sheets by one frame. Call [`advance`](Self::advance) after the last of them.
    pub fn step_one<S, const W: usize, const H: usize>(
        &self,
        cloth: &mut Cloth<S, W, H>,
        memory: &mut V::Memory<L, W, H>,
    ) where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>,
        G: Kind<S, W, H>,
    {
        let Self { forces, links, colliders, solver, .. } = self;
        solver.frame(Physics { forces, links, colliders }, cloth, memory, self.end());
    }

    /// Moves the colliders to the end of a frame. Call it once all sheets have made their [step](Self::step_one).
    pub fn advance<S: Scalar>(&mut self)
    where
        C: Collider<S>,
    {
        self.colliders.advance(self.end());
    }

    /// Moves a pin to `target` during the next frame. The pin keeps this velocity afterwards: call this for every frame in which the pin moves, and once more
    /// with the same target to stop it.
    pub fn move_pin<S: Scalar, const W: usize, const H: usize>(
        &self,
        cloth: &mut Cloth<S, W, H>,
        node: Node,
        target: Vec3<S>,
    ) {
        // a frame is substeps/2^shift ticks, between a half and one
        let way = target - cloth.position.at(node);
        let ticks: S = self.end().ticks();
        cloth.velocity.set(node, way.map(|component| component.divide(ticks)));
    }

    fn end(&self) -> Moment {
        Moment { substep: self.substeps, substeps: self.substeps, shift: self.shift, halves: 2 }
    }
}

//! The description of what happens to a sheet, and the step.

use crate::cloth::Cloth;
use crate::collider::Collider;
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
/// A scene is configuration, and one scene moves many sheets; what changes with a sheet is in its [`Cloth`] and in the solver's memory. Slots
/// that a scene doesn't need are `()` and cost nothing.
#[derive(Clone, Copy, Debug)]
pub struct Scene<F, L, C, V> {
    /// What pulls from outside.
    pub forces: F,
    /// What holds particles together.
    pub links: L,
    /// What is in the way.
    pub colliders: C,
    /// How the sheet is moved.
    pub solver: V,
    substeps: u32,
    shift: u32,
}

impl<F, L, C, V> Scene<F, L, C, V> {
    /// A scene in these units.
    ///
    /// # Panics
    /// At compile time in a constant: for units that were put together by hand, of no substeps or more than 2²⁴.
    #[track_caller]
    pub const fn new(units: &Units, forces: F, links: L, colliders: C, solver: V) -> Self {
        units.check_substeps();
        Self { forces, links, colliders, solver, substeps: units.substeps, shift: units.shift() }
    }

    /// The solver's memory for a sheet at the start of its motion.
    ///
    /// # Panics
    /// For a solver that makes no sense, as one of no sweeps, and for links of one's own that show more than their type says.
    #[track_caller]
    pub fn memory<S: Scalar, const W: usize, const H: usize>(&self) -> V::Memory<L, W, H>
    where
        L: Links<S>,
        V: Solver<S>,
    {
        link::check(&self.links);
        self.solver.memory()
    }

    /// Moves `cloth` by one frame. Cannot fail.
    pub fn step<S, const W: usize, const H: usize>(&self, cloth: &mut Cloth<S, W, H>, memory: &mut V::Memory<L, W, H>)
    where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>,
    {
        let Self { forces, links, colliders, solver, .. } = self;
        solver.frame(Physics { forces, links, colliders }, cloth, memory, self.end());
    }

    /// Moves the colliders on to the end of a frame: call it after all sheets have made their step.
    pub fn advance<S: Scalar>(&mut self)
    where
        C: Collider<S>,
    {
        self.colliders.advance(self.end());
    }

    /// Lets a pin travel to `target` in the next frame. It goes on at the same speed until it is told otherwise: call this for every frame in
    /// which the pin moves, and once more with the same target to stop it there.
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

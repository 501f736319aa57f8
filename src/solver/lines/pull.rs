//! Coupling of dampers and springs. Both act at the substep's end, on `v' = (1 + W·L)⁻¹·(v̂ + Δ)`, where Δ is the velocity change by springs and contacts.
//!
//! Springs are solved after dampers. So dampers first assume the Δ of the last substep, as incremental projection methods do (J. van Kan, 1986). In the end they act on the
//! difference between the actual Δ and the assumed one. This is of second order, and leaves a sheet in equilibrium unchanged.

use crate::grid::{Grid, Node};
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

use super::History;
use super::rule::TimeRule;
use super::viscosity::{Axes, PASSES, diffuse};

/// The number of grids that a [`Pull`] takes.
const GRIDS: usize = 3;

/// Δ, the velocity change by springs and contacts in the last substep: x, y and z.
struct Pull<'a, S, const W: usize, const H: usize>(&'a mut [Grid<S, W, H>; GRIDS]);

/// The dampers' state between the two stages in which they act in a part of a substep.
pub(super) struct Viscous<'a, S, const W: usize, const H: usize> {
    pull: Pull<'a, S, W, H>,
    axes: Axes<S>,
    /// The velocities from which springs start.
    started: Vectors<S, W, H>,
}

impl<'a, S: Scalar, const W: usize, const H: usize> Viscous<'a, S, W, H> {
    /// Lets dampers act, if there are any, with the Δ of the last substep, or zero if it is unknown.
    #[inline(always)]
    pub(super) fn damp<L: Links<S>>(
        grids: &'a mut [Grid<S, W, H>],
        history: History,
        links: &L,
        particles: &mut Particles<S, W, H>,
        rule: &TimeRule<S>,
    ) -> Option<Self> {
        let mut pull = Pull(grids.first_chunk_mut()?);
        let axes = Axes::of(links, &particles.inverse_mass, rule.response)?;
        if history != History::Velocity {
            pull.forget();
        }
        let started = pull.damp(links, particles, rule.moment, rule.part, &axes);
        Some(Self { pull, axes, started })
    }

    /// Lets dampers act on the velocity changes by springs and contacts since.
    #[inline(always)]
    pub(super) fn complete<L: Links<S>>(mut self, links: &L, particles: &mut Particles<S, W, H>, rule: &TimeRule<S>) {
        self.pull.complete(links, particles, self.started, &self.axes, rule.share());
    }
}

impl<S: Scalar, const W: usize, const H: usize> Pull<'_, S, W, H> {
    /// Lets dampers act. Returns the velocities from which springs start.
    ///
    /// A position depends on its velocity by `part`·h.
    fn damp<L: Links<S>>(
        &self,
        links: &L,
        particles: &mut Particles<S, W, H>,
        moment: Moment,
        part: S,
        axes: &Axes<S>,
    ) -> Vectors<S, W, H> {
        let mut damped = particles.velocity;
        for node in Grid::<S, W, H>::nodes() {
            damped.add(node, self.at(node));
        }
        diffuse(links, &particles.inverse_mass, &mut damped, axes, PASSES);
        for node in Grid::<S, W, H>::nodes() {
            let velocity = damped.at(node) - self.at(node);
            particles.position.add(node, moment.displacement((velocity - particles.velocity.at(node)) * part));
            damped.set(node, velocity);
        }
        particles.velocity = damped;
        damped
    }

    /// Lets dampers act on the difference between the new Δ, the velocity change since `started`, and the assumed one. The next substep will assume `share` of the new Δ.
    fn complete<L: Links<S>>(
        &mut self,
        links: &L,
        particles: &mut Particles<S, W, H>,
        mut started: Vectors<S, W, H>,
        axes: &Axes<S>,
        share: S,
    ) {
        let velocity = &mut particles.velocity;
        for node in Grid::<S, W, H>::nodes() {
            let [last, pull] = [self.at(node), velocity.at(node) - started.at(node)];
            self.set(node, pull * share);
            started.add(node, last);
            velocity.set(node, pull - last);
        }
        diffuse(links, &particles.inverse_mass, velocity, axes, 1);
        for node in Grid::<S, W, H>::nodes() {
            velocity.add(node, started.at(node));
        }
    }

    /// Sets Δ to zero.
    fn forget(&mut self) {
        *self.0 = [Grid::filled(S::ZERO); GRIDS];
    }

    fn at(&self, node: Node) -> Vec3<S> {
        let [x, y, z] = &*self.0;
        Vec3::new(x[node], y[node], z[node])
    }

    fn set(&mut self, node: Node, pull: Vec3<S>) {
        let [x, y, z] = &mut *self.0;
        (x[node], y[node], z[node]) = (pull.x, pull.y, pull.z);
    }
}

//! Leapfrog in its drift–kick–drift form: `x½ = x + h/2·v`, `v' = v + h·a(x½)`, `x' = x½ + h/2·v'`.

use crate::collider::Collider;
use crate::force::Force;
use crate::grid::Grid;
use crate::link::{Damping, Family, Links, Visitor};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::{Physics, Solver, one_step};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// Leapfrog, second order, symplectic: energy oscillates but does not drift (thesis, among equations 4.7–4.13).
///
/// Stable for h < 2/ω with `ω² = 4·(k + k_shear)/m` for a sheet of stretch and shear springs. Drag is integrated exactly. Where forces depend on
/// velocities (aerodynamic wind, damped links), a substep takes a second force sum at the velocities predicted for its middle, so that the order stays 2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Leapfrog;

impl Leapfrog {
    /// Leapfrog.
    pub const fn new() -> Self {
        Self
    }
}

/// The velocity change of every particle by forces, and its velocity at the start of a substep.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "S: Scalar + serde::Deserialize<'de>")))]
pub struct LeapfrogMemory<S, const W: usize, const H: usize> {
    gain: Vectors<S, W, H>,
    start: Vectors<S, W, H>,
}

impl<S: Scalar> Solver<S> for Leapfrog {
    type Memory<L: Links<S>, const W: usize, const H: usize> = LeapfrogMemory<S, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        LeapfrogMemory { gain: Vectors::filled(Vec3::ZERO), start: Vectors::filled(Vec3::ZERO) }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        let LeapfrogMemory { gain, start } = memory;
        let shift = moment.shift;
        one_step::drift(particles, shift + 1);
        physics.gains(particles, moment, gain);
        let drag = physics.forces.drag();
        if physics.forces.follows_velocity() || is_damped(physics.links) {
            *start = particles.velocity;
            for node in Grid::<S, W, H>::nodes() {
                if !particles.is_pinned(node) {
                    let change = if F::DRAG { gain.at(node) - start.at(node) * drag.rate } else { gain.at(node) };
                    particles.velocity.add(node, change.halve(1));
                }
            }
            physics.gains(particles, moment, gain);
            particles.velocity = *start;
        }
        for node in Grid::<S, W, H>::nodes() {
            if !particles.is_pinned(node) {
                let velocity = particles.velocity.at(node);
                particles.velocity.set(
                    node,
                    if F::DRAG { velocity * drag.decay + gain.at(node) * drag.gain } else { velocity + gain.at(node) },
                );
            }
        }
        one_step::drift(particles, shift + 1);
        physics.confine(particles, moment);
    }
}

/// Whether there is a damper; known at compile time if the links are.
#[inline]
fn is_damped<S: Scalar, L: Links<S>>(links: &L) -> bool {
    let mut seen = Seen(false);
    if L::Damping::ANY {
        links.dampers(&mut seen);
    }
    seen.0
}

/// Whether any family was shown.
struct Seen(bool);

impl<S: Scalar> Visitor<S> for Seen {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, _family: &Family<S>) {
        self.0 = true;
    }
}

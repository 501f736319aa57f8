//! The prediction of a substep: the positions and velocities at its end without links.

use crate::force::{Force, Row};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::one_step;
use crate::vec3::Vec3;

use super::{History, LinesMemory};

/// Moves particles to where they would be at the end of a part of a substep without links.
#[inline(always)]
pub(super) fn predict<S: Scalar, F: Force<S>, T, P, const W: usize, const H: usize>(
    forces: &F,
    particles: &mut Particles<S, W, H>,
    memory: &mut LinesMemory<S, T, P, W, H>,
    moment: Moment,
    split: u32,
) {
    match memory.history {
        History::Rough => first_order(forces, particles, memory, moment, split),
        History::None | History::Velocity => second_order(forces, particles, memory, moment, split),
    }
}

/// Backward Euler without links: `v̂ = (v + gain)/(1 + γ·h)`, `x̂ = x + h·v̂`.
fn first_order<S: Scalar, F: Force<S>, T, P, const W: usize, const H: usize>(
    forces: &F,
    particles: &mut Particles<S, W, H>,
    memory: &mut LinesMemory<S, T, P, W, H>,
    moment: Moment,
    split: u32,
) {
    memory.earlier = particles.velocity;
    let slowed = S::ONE.divide(S::ONE + forces.drag().rate.halve(split));
    one_step::predict(
        forces,
        particles,
        |velocity, gain| {
            let gain = gain.halve(split);
            if F::DRAG { (velocity + gain) * slowed } else { velocity + gain }
        },
        |position, velocity| [position, velocity],
    );
    // in a loop of its own: a common one, which the compiler unrolls, took 2 % more flash
    one_step::drift(particles, moment.shift);
}

/// The second-order rule without links, `v̂ = (v + (v − v₋)/3 + (2/3)·gain)/(1 + (2/3)·γ·h)`, `x̂ = x + h·(4·v̂ + v + v₋)/6`.
fn second_order<S: Scalar, F: Force<S>, T, P, const W: usize, const H: usize>(
    forces: &F,
    particles: &mut Particles<S, W, H>,
    memory: &mut LinesMemory<S, T, P, W, H>,
    moment: Moment,
    split: u32,
) {
    let third = S::ONE.divide(S::from_int(3));
    let two_thirds = third + third;
    let rule = Rule { third, two_thirds, sixth: third.halve(1), moment };
    let drag = forces.drag().rate.halve(split);
    let slowed = S::ONE.divide(S::ONE + two_thirds * drag);
    let (is_field, uniform) = (forces.is_field(), forces.uniform());
    let start = memory.history == History::None;
    let mut gain = Vec3::row(Vec3::ZERO);
    let mut here = if is_field { Some(ahead(particles, memory, 0, start, moment)) } else { None };
    for row in 0..H {
        let mut below_gain = Vec3::row(Vec3::ZERO);
        if let Some([position, velocity]) = &here {
            let upper = Row { index: row, position, velocity, inverse_mass: &particles.inverse_mass.0[row] };
            forces.particles(upper, &mut gain);
            let below = (row + 1 < H).then(|| ahead(particles, memory, row + 1, start, moment));
            if let Some([position, velocity]) = &below {
                let inverse_mass = &particles.inverse_mass.0[row + 1];
                let lower = Row { index: row + 1, position, velocity, inverse_mass };
                forces.cells([upper, lower], [&mut gain, &mut below_gain]);
            }
            here = below;
        }
        let velocity = particles.velocity.0[row];
        let mut earlier = core::mem::replace(&mut memory.earlier.0[row], velocity);
        for column in 0..W {
            let by = if is_field { gain.at(column) * particles.inverse_mass.0[row][column] + uniform } else { uniform };
            let by = by.halve(split);
            gain.set(column, by * two_thirds);
            if start {
                let v = velocity.at(column);
                earlier.set(column, v - if F::DRAG { by - v * drag } else { by });
            }
        }
        if F::DRAG {
            rule.row(particles, row, &earlier, &gain, |v| v * slowed);
        } else {
            rule.row(particles, row, &earlier, &gain, |v| v);
        }
        gain = below_gain;
    }
}

/// The rule's coefficients.
struct Rule<S> {
    third: S,
    two_thirds: S,
    sixth: S,
    moment: Moment,
}

impl<S: Scalar> Rule<S> {
    /// Moves a row, given its velocities at the start of the last substep and two thirds of its gain.
    #[inline(never)] // so that the compiler knows that rows don't alias
    fn row<const W: usize, const H: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        row: usize,
        earlier: &Vec3<[S; W]>,
        gain: &Vec3<[S; W]>,
        slow: impl Fn(Vec3<S>) -> Vec3<S>,
    ) {
        let inverse_mass = &particles.inverse_mass.0[row];
        let (position, velocity) = (&mut particles.position.0[row], &mut particles.velocity.0[row]);
        for column in 0..W {
            let (v, earlier) = (velocity.at(column), earlier.at(column));
            let next = slow(v + (v - earlier) * self.third + gain.at(column));
            // a pin keeps its velocity; no branch, so that four particles can move at once
            let pinned = inverse_mass[column] == S::ZERO;
            velocity.set(column, v.or(next, pinned));
            let drift = next * self.two_thirds + (v + earlier) * self.sixth;
            position.add(column, self.moment.displacement(v.or(drift, pinned)));
        }
    }
}

/// A row's positions and velocities at the substep's end, extrapolated from the last two substeps. Wind at the start of the substep would be of first order.
#[inline]
fn ahead<S: Scalar, T, P, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    memory: &LinesMemory<S, T, P, W, H>,
    row: usize,
    start: bool,
    moment: Moment,
) -> [Vec3<[S; W]>; 2] {
    let [mut position, mut velocity] = [particles.position.0[row], particles.velocity.0[row]];
    let earlier = if start { velocity } else { memory.earlier.0[row] };
    for column in 0..W {
        let v = velocity.at(column);
        // a pin keeps its velocity
        let pinned = particles.inverse_mass.0[row][column] == S::ZERO;
        let change = Vec3::ZERO.or(v - earlier.at(column), pinned);
        velocity.set(column, v + change);
        position.add(column, moment.displacement(v + change.halve(1)));
    }
    [position, velocity]
}

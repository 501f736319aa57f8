//! Velocities during sweeps.
//!
//! A correction of a position changes the velocity, too. Floats add both at once: a velocity from the difference of two positions would lose digits. Fixed point, whose sums are
//! exact, adds all velocity changes at the end. Before the sweeps, a velocity is set aside: the velocity that belongs to its position as a displacement is subtracted. Sweeps
//! move positions alone; then the velocity that belongs to the new position is added. (Rounding the velocity change of each correction would push a sheet to one side.)

use crate::grid::Node;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// The velocity, set aside: without its position's share.
#[inline(always)]
pub(super) fn set_aside<S: Scalar>(velocity: Vec3<S>, position: Vec3<S>, moment: Moment) -> Vec3<S> {
    if S::EXACT_SUMS { velocity - position.map(|x| moment.share(x)) } else { velocity }
}

/// The velocity with its position's share again.
#[inline(always)]
pub(super) fn give_back<S: Scalar>(velocity: Vec3<S>, position: Vec3<S>, moment: Moment) -> Vec3<S> {
    if S::EXACT_SUMS { velocity + position.map(|x| moment.share(x)) } else { velocity }
}

/// Sets all velocities aside.
#[inline(always)]
pub(super) fn set_all_aside<S: Scalar, const W: usize, const H: usize>(
    particles: &mut Particles<S, W, H>,
    moment: Moment,
) {
    change_all(particles, |velocity, position| velocity - moment.share(position));
}

/// Adds to all velocities the changes by the sweeps.
#[inline(always)]
pub(super) fn give_all_back<S: Scalar, const W: usize, const H: usize>(
    particles: &mut Particles<S, W, H>,
    moment: Moment,
) {
    change_all(particles, |velocity, position| velocity + moment.share(position));
}

#[inline(always)]
fn change_all<S: Scalar, const W: usize, const H: usize>(
    particles: &mut Particles<S, W, H>,
    change: impl Fn(S, S) -> S + Copy,
) {
    if S::EXACT_SUMS {
        for (position, velocity) in particles.position.0.iter().zip(&mut particles.velocity.0) {
            change_each(&mut velocity.x, &position.x, change);
            change_each(&mut velocity.y, &position.y, change);
            change_each(&mut velocity.z, &position.z, change);
        }
    }
}

/// Sets each velocity to `change(velocity, position)`.
#[inline(never)] // for any length: a loop, which would be unrolled for a known length
fn change_each<S: Scalar>(velocities: &mut [S], positions: &[S], change: impl Fn(S, S) -> S) {
    for (velocity, position) in velocities.iter_mut().zip(positions) {
        *velocity = change(*velocity, *position);
    }
}

/// Moves a particle of a row within a sweep, while velocities are set aside.
#[inline(always)]
pub(super) fn displace<S: Scalar, const W: usize>(
    position: &mut Vec3<[S; W]>,
    velocity: &mut Vec3<[S; W]>,
    column: usize,
    by: Vec3<S>,
    moment: Moment,
) {
    position.add(column, by);
    if !S::EXACT_SUMS {
        velocity.add(column, moment.velocity(by));
    }
}

/// The same for a particle of the sheet.
#[inline(always)]
pub(super) fn displace_node<S: Scalar, const W: usize, const H: usize>(
    particles: &mut Particles<S, W, H>,
    node: Node,
    by: Vec3<S>,
    moment: Moment,
) {
    if S::EXACT_SUMS {
        particles.position.add(node, by);
    } else {
        particles.displace(node, by, moment);
    }
}

/// The same for all particles of a row.
#[inline(always)]
pub(super) fn displace_row<S: Scalar, const W: usize, const H: usize>(
    particles: &mut Particles<S, W, H>,
    row: usize,
    by: impl Fn(usize) -> Vec3<S>,
    moment: Moment,
) {
    let (position, velocity) = (&mut particles.position.0[row], &mut particles.velocity.0[row]);
    for column in 0..W {
        displace(position, velocity, column, by(column), moment);
    }
}

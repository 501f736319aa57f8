//! Split sheets that hardly move are smoothed.
//!
//! A part of a substep has few sweeps, and what they leave of a strain moves particles within a very short time: a residual of half a percent in parts of half a millisecond is a velocity
//! of a metre a second. It excites what the next part has to solve, and a nearly rigid sheet that should come to rest goes on shaking. Neighbours shake against each
//! other; so while nothing moves far in a substep, each velocity is drawn towards its neighbours' in every part: `v' = v + min(w, 1)/8·Σ(v_j − v)`. It takes energy, moves nothing
//! that is at rest, and leaves whole sheets their motion.

use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// How far particles of a sheet that is smoothed move at most in a substep, cells.
pub(super) const SLOW: f64 = 0.3;

/// The part of a neighbour's difference, as a power of two: less than a half for all four.
const PART: u32 = 3;

/// Draws velocities towards those of their neighbours.
#[inline(never)] // one for all scenes
pub(super) fn smooth<S: Scalar, const W: usize, const H: usize>(particles: &mut Particles<S, W, H>) {
    let mut above = particles.velocity.0[0];
    for row in 0..H {
        let here = particles.velocity.0[row];
        let below = if row + 1 < H { particles.velocity.0[row + 1] } else { here };
        let w = &particles.inverse_mass.0[row];
        let velocity = &mut particles.velocity.0[row];
        for column in 0..W {
            let v = here.at(column);
            let missing = |neighbour: Vec3<S>| (neighbour - v).map(|x| x.halve_evenly(PART));
            let beside = |column: usize| if column < W { missing(here.at(column)) } else { Vec3::ZERO };
            // in this order a mirrored row is smoothed as the mirror image
            let across = beside(column.wrapping_sub(1)) + beside(column + 1);
            let down = missing(above.at(column)) + missing(below.at(column));
            velocity.add(column, (across + down) * w[column].min(S::ONE));
        }
        above = here;
    }
}

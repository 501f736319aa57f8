//! Conjugate gradients (M. Hestenes, E. Stiefel, 1952), with all the digits that fixed point has.
//!
//! Beside a stiff spring a particle's inertia is a small number. Of a small direction its part of the product would round to nothing: nothing would keep the sheet
//! from moving as a whole, and it flew away. So in fixed point residual and direction are counted in a unit in which the largest component lies between 1 and 2,
//! and products in one of their own.

use super::BackwardEulerMemory;
use crate::grid::each_node;
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// The most steps. About the number of particles a side times the square root of κ suffice.
const MOST_STEPS: u32 = 200;

/// The residual, relative to that of the start, at which they end.
const TOLERANCE: f64 = 1e-3;

/// The steps for which they go on in fixed point although the residual shrinks no more: round-off is all that is left of it, and in it they turn in circles,
/// further out with each turn.
const PATIENCE: u32 = 24;

/// The largest component of what fixed point multiplies: a sum of products over the 12 links of a particle then stays in range.
const LARGE: i32 = 2;

/// The largest product of a component with a particle's mass, likewise.
const HEAVY: i32 = 64;

/// The longest step and the sharpest turn in fixed point, likewise.
const LONG: i32 = 16;

/// The logarithm to base 2 of by how much more than [`LARGE`] a particle moves at most, cells.
const FAR: i32 = 5;

/// Solves for `memory.step` what `multiply` makes `memory.residual` of it, with masses up to `heaviest`; the residual is used up.
pub(super) fn solve<S: Scalar, const W: usize, const H: usize>(
    memory: &mut BackwardEulerMemory<S, W, H>,
    heaviest: S,
    multiply: impl Fn(&Vectors<S, W, H>, &mut Vectors<S, W, H>),
) {
    let BackwardEulerMemory { step, residual, direction, product, .. } = memory;
    *step = Vectors::filled(Vec3::ZERO);
    *direction = *residual;
    let tolerance = S::from_f64(TOLERANCE * TOLERANCE);
    let long = S::from_int(LONG);
    let large = S::from_int(LARGE).min(S::from_int(HEAVY).divide(heaviest));
    let mut squared = dot(residual, residual);
    // of the square at the start, now and at best
    let (mut part, mut best, mut age) = (S::ONE, S::ONE, 0);
    // residual and direction count 2^-unit
    let mut unit = 0;
    for _ in 0..MOST_STEPS {
        let lift = residual.largest().max(direction.largest()).headroom(large);
        if lift != 0 {
            unit += lift;
            raise(residual, lift);
            raise(direction, lift);
            squared = dot(residual, residual);
        }
        multiply(direction, product);
        let lift = product.largest().headroom(S::from_int(LARGE));
        raise(product, lift);
        let curvature = dot(direction, product);
        if curvature <= S::EMPTY {
            break;
        }
        let length = S::quotient(squared, curvature);
        let length = length.bounded(long);
        if lift - unit > FAR + (direction.largest() * length).headroom(S::from_int(LARGE)) {
            break;
        }
        each_node::<W, H>(|node| {
            step.add(node, raised(direction.at(node) * length, lift - unit));
            residual.add(node, -(product.at(node) * length));
        });
        let next = dot(residual, residual);
        let turn = S::quotient(next, squared);
        part = S::narrow(part.product(turn));
        if is_round_off(residual, unit) || (S::EXACT_SUMS && age > PATIENCE) || next <= S::EMPTY || part < tolerance {
            break;
        }
        age += 1;
        if part < best {
            (best, age) = (part, 0);
        }
        squared = next;
        // or all over again
        let turn = if turn.is_within(long) { turn } else { S::ZERO };
        each_node::<W, H>(|node| {
            direction.set(node, residual.at(node) + direction.at(node) * turn);
        });
    }
}

fn dot<S: Scalar, const W: usize, const H: usize>(a: &Vectors<S, W, H>, b: &Vectors<S, W, H>) -> S::Sum {
    a.values().zip(b.values()).fold(S::EMPTY, |sum, (a, b)| S::accumulate(sum, a.dot_wide(b)))
}

/// Whether a residual that counts 2^-unit is round-off alone: in fixed point no more than three units of the last place.
fn is_round_off<S: Scalar, const W: usize, const H: usize>(residual: &Vectors<S, W, H>, unit: i32) -> bool {
    S::EXACT_SUMS && residual.largest() <= S::from_f64(3.0 * S::RESOLUTION).double(unit.max(0) as u32)
}

/// `v · 2^shift`
fn raised<S: Scalar>(v: Vec3<S>, shift: i32) -> Vec3<S> {
    if shift > 0 { v.double(shift as u32) } else { v.map(|v| v.halve_evenly(shift.unsigned_abs())) }
}

fn raise<S: Scalar, const W: usize, const H: usize>(vectors: &mut Vectors<S, W, H>, shift: i32) {
    if shift != 0 {
        vectors.change(|v| raised(v, shift));
    }
}

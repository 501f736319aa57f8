//! Conjugate gradients (M. Hestenes, E. Stiefel, 1952), scaled to use all digits of fixed point.
//!
//! Compared to a stiff spring, a particle's inertia is a small number. Its part of the product with a small direction would round to zero. Then nothing would keep the sheet from
//! moving as a whole, and it flew away. So in fixed point, residual and direction are in a unit in which the largest component lies between 1 and 2, and products in a unit of
//! their own.

use super::BackwardEulerMemory;
use crate::grid::each_node;
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// The most steps. About the number of particles a side times the square root of κ is enough.
const MOST_STEPS: u32 = 200;

/// The residual, relative to that at the start, at which the steps end.
const TOLERANCE: f64 = 1e-3;

/// The most steps in fixed point after the smallest residual so far. From then on the residual is round-off, and further steps go in growing circles.
const PATIENCE: u32 = 24;

/// The largest component of a direction or a product in fixed point: the sum of products over the 12 links of a particle then stays in range.
const LARGE: i32 = 2;

/// The largest product of a component with a particle's mass, likewise.
const HEAVY: i32 = 64;

/// The largest step length and the largest factor of the last direction in the next one in fixed point, likewise.
const LONG: i32 = 16;

/// The logarithm to base 2 of the factor by which a displacement may exceed [`LARGE`] cells.
const FAR: i32 = 5;

/// Solves `multiply(memory.step) = memory.residual` for masses up to `heaviest`; the residual is overwritten.
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
    // the squared residual relative to the start, now and at best
    let (mut part, mut best, mut age) = (S::ONE, S::ONE, 0);
    // residual and direction are in units of 2^-unit
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
        // else start again from the residual
        let turn = if turn.is_within(long) { turn } else { S::ZERO };
        each_node::<W, H>(|node| {
            direction.set(node, residual.at(node) + direction.at(node) * turn);
        });
    }
}

fn dot<S: Scalar, const W: usize, const H: usize>(a: &Vectors<S, W, H>, b: &Vectors<S, W, H>) -> S::Sum {
    a.values().zip(b.values()).fold(S::EMPTY, |sum, (a, b)| S::accumulate(sum, a.dot_wide(b)))
}

/// Whether a residual in units of 2^-unit is round-off alone: in fixed point, at most three units of the last place.
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

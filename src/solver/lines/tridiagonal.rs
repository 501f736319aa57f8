//! Tridiagonal systems, for rows, columns, diagonals, dampers and [taut chains](super::geometric_stiffness).
//!
//! A link shares a particle with the one before it and the one after it, so the equations of a chain of links are
//!
//! `d_k·x_k − c_{k−1}·x_{k−1} − c_k·x_{k+1} = r_k`,
//!
//! with a diagonal d, a coupling `c_k` of link k with the next one, and right sides r. Elimination down the chain expresses each unknown by the next one (L. Thomas, 1949):
//!
//! `x_k = R_k + (c_k/p_k)·x_{k+1}`,  pivots `p_k = d_k − c_{k−1}²/p_{k−1}`,  `R_k = (r_k + c_{k−1}·R_{k−1})/p_k`,
//!
//! and substitution up the chain finds them. Links of strength a/b between inverse masses w have `d_k = a·(w_k + w_{k+1}) + b` and `|c_k| ≤ a·w_{k+1}`, so
//! `p_k ≥ a·w_{k+1} + b`, and no factor `c_k/p_k` is larger than 1: no term grows along the chain.
//!
//! [`twisted`] eliminates from both ends to the middle: a mirrored chain of an odd number of links is solved as the mirror image, to the last bit in floats.

use core::ops::{Add, AddAssign, Mul};

use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// An unknown of a system: a number, or a vector whose components have the same coefficients.
pub(super) trait Unknown<S>: Copy + Add<Output = Self> + AddAssign + Mul<S, Output = Self> {
    /// Zero.
    const NONE: Self;

    /// `self · ratio` for `|ratio| ≤ 1`.
    fn scaled_by(self, ratio: S) -> Self;
}

impl<S: Scalar> Unknown<S> for S {
    const NONE: Self = S::ZERO;

    #[inline(always)]
    fn scaled_by(self, ratio: S) -> Self {
        self.scaled(ratio)
    }
}

impl<S: Scalar> Unknown<S> for Vec3<S> {
    const NONE: Self = Vec3::ZERO;

    #[inline(always)]
    fn scaled_by(self, ratio: S) -> Self {
        self.scaled(ratio)
    }
}

/// A product with 1/pivot, a coupling or a factor. Where all masses are 1, none of these is larger than 1: pivots are at least `a + b`, and the larger of a and b is 1.
#[inline(always)]
pub(super) fn times<const UNIT_MASS: bool, S: Scalar, R: Unknown<S>>(x: R, ratio: S) -> R {
    if UNIT_MASS { x.scaled_by(ratio) } else { x * ratio }
}

/// An equation after elimination: `x = right + factor·(the next x)`.
#[derive(Clone, Copy)]
pub(super) struct Eliminated<S, R = S> {
    pub(super) per_pivot: S,
    pub(super) right: R,
}

impl<S: Scalar, R: Unknown<S>> Eliminated<S, R> {
    /// No equation: the start of an elimination.
    pub(super) const NONE: Self = Self { per_pivot: S::ZERO, right: R::NONE };

    /// The first equation, without the products that would be zero.
    #[inline(always)]
    fn first<const UNIT_MASS: bool>(diagonal: S, right: R) -> Self {
        let per_pivot = diagonal.recip();
        Self { per_pivot, right: times::<UNIT_MASS, S, R>(right, per_pivot) }
    }

    /// The next equation, and the factor of its unknown in this one.
    #[inline(always)]
    pub(super) fn next<const UNIT_MASS: bool>(self, diagonal: S, coupling: S, right: R) -> (Self, S) {
        let factor = times::<UNIT_MASS, S, S>(coupling, self.per_pivot);
        let pivot = diagonal - times::<UNIT_MASS, S, S>(factor, coupling);
        (self.then::<UNIT_MASS>(pivot, coupling, right), factor)
    }

    /// The next equation, with this pivot. The matrix need not be symmetric: `coupling` is that of the next equation with this one.
    #[inline(always)]
    pub(super) fn then<const UNIT_MASS: bool>(self, pivot: S, coupling: S, right: R) -> Self {
        Self::first::<UNIT_MASS>(pivot, right + times::<UNIT_MASS, S, R>(self.right, coupling))
    }

    /// The unknown of an equation between two eliminated ones, and its factors in these.
    #[inline(always)]
    fn between(self, other: Self, diagonal: S, couplings: [S; 2], right: R) -> (R, [S; 2]) {
        let factors = [couplings[0] * self.per_pivot, couplings[1] * other.per_pivot];
        let pivot = diagonal - (couplings[0] * factors[0] + couplings[1] * factors[1]);
        ((right + (self.right * couplings[0] + other.right * couplings[1])) * pivot.recip(), factors)
    }
}

/// Solves a chain of `N` particles, whose `N − 1` links have these diagonals, couplings with the next link, and right sides. The last element of the result is zero.
#[inline(always)]
pub(super) fn twisted<const UNIT_MASS: bool, S: Scalar, R: Unknown<S>, const N: usize>(
    diagonal: impl Fn(usize) -> S,
    coupling: impl Fn(usize) -> S,
    right: impl Fn(usize) -> R,
) -> [R; N] {
    let mut x = [R::NONE; N];
    if N < 2 {
        return x;
    }
    let (links, middle) = (N - 1, (N - 1) / 2);
    let mut factor = [S::ZERO; N];
    let [mut before, mut after] = [Eliminated::NONE; 2];
    for k in 0..middle {
        if k == 0 {
            before = Eliminated::first::<UNIT_MASS>(diagonal(k), right(k));
        } else {
            (before, factor[k - 1]) = before.next::<UNIT_MASS>(diagonal(k), coupling(k - 1), right(k));
        }
        x[k] = before.right;
    }
    // counted this way, so that the compiler sees that no index is out of bounds
    for turn in 0..links - 1 - middle {
        let k = links - 1 - turn;
        if turn == 0 {
            after = Eliminated::first::<UNIT_MASS>(diagonal(k), right(k));
        } else {
            (after, factor[k + 1]) = after.next::<UNIT_MASS>(diagonal(k), coupling(k), right(k));
        }
        x[k] = after.right;
    }
    let to_previous = if middle > 0 { coupling(middle - 1) } else { S::ZERO };
    let to_next = if middle + 1 < links { coupling(middle) } else { S::ZERO };
    let factors;
    (x[middle], factors) = before.between(after, diagonal(middle), [to_previous, to_next], right(middle));
    if middle > 0 {
        factor[middle - 1] = factors[0];
    }
    if middle + 1 < links {
        factor[middle + 1] = factors[1];
    }
    for k in (0..middle).rev() {
        x[k] += times::<UNIT_MASS, S, R>(x[k + 1], factor[k]);
    }
    for k in middle + 1..links {
        x[k] += times::<UNIT_MASS, S, R>(x[k - 1], factor[k]);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q13, Q24};

    const N: usize = 12;

    /// Inverse masses of particles, the first of which is a pin.
    const MASSES: [f64; N] = [0.0, 1.0, 0.5, 1.0, 1.0, 2.0, 1.0, 0.25, 1.0, 1.0, 0.5, 1.0];

    fn diagonal(k: usize) -> f64 {
        MASSES[k] + MASSES[k + 1] + 0.125
    }

    fn coupling(k: usize) -> f64 {
        MASSES[k + 1] * if k % 3 == 0 { -0.5 } else { 0.75 }
    }

    fn right(k: usize) -> f64 {
        0.1 * libm::sin(k as f64 + 0.5)
    }

    /// The largest residual.
    fn left_over(x: &[f64; N]) -> f64 {
        let neighbours = |k: usize| {
            let before = if k > 0 { coupling(k - 1) * x[k - 1] } else { 0.0 };
            before + if k + 2 < N { coupling(k) * x[k + 1] } else { 0.0 }
        };
        (0..N - 1).map(|k| (diagonal(k) * x[k] - neighbours(k) - right(k)).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn a_chain_is_solved_to_rounding() {
        fn check<S: Scalar>(bound: f64) {
            let of = |f: fn(usize) -> f64| move |k| S::from_f64(f(k));
            let x: [S; N] = twisted::<false, S, S, N>(of(diagonal), of(coupling), of(right));
            let left = left_over(&x.map(S::to_f64));
            assert!(left < bound && x[0] != S::ZERO, "{}: {left:e}", S::NAME);
            assert!(x[N - 1] == S::ZERO);
        }
        check::<f64>(1e-15);
        check::<f32>(1e-7);
        check::<Q24>(1e-6);
        check::<Q13>(1e-3);
    }

    #[test]
    fn a_vector_is_solved_as_its_components() {
        let x: [f64; N] = twisted::<false, f64, f64, N>(diagonal, coupling, right);
        let vector = |k| Vec3::new(right(k), 2.0 * right(k), -right(k));
        let vectors: [Vec3<f64>; N] = twisted::<false, f64, Vec3<f64>, N>(diagonal, coupling, vector);
        assert!((0..N).all(|k| vectors[k] == Vec3::new(x[k], 2.0 * x[k], -x[k])));
    }

    #[test]
    fn a_mirrored_chain_is_solved_as_the_mirror_image() {
        let plain: [f32; N] =
            twisted::<false, f32, f32, N>(|k| diagonal(k) as f32, |k| coupling(k) as f32, |k| right(k) as f32);
        let mirrored: [f32; N] = twisted::<false, f32, f32, N>(
            |k| diagonal(N - 2 - k) as f32,
            |k| if k + 2 < N { coupling(N - 3 - k) as f32 } else { 0.0 },
            |k| right(N - 2 - k) as f32,
        );
        assert!((0..N - 1).all(|k| plain[k].to_bits() == mirrored[N - 2 - k].to_bits()));
    }

    #[test]
    fn a_chain_of_one_link_or_none_is_solved_too() {
        assert_eq!(twisted::<false, f64, f64, 2>(|_| 4.0, |_| unreachable!(), |_| 2.0), [0.5, 0.0]);
        assert_eq!(twisted::<false, f64, f64, 1>(|_| unreachable!(), |_| unreachable!(), |_| 2.0), [0.0]);
    }
}

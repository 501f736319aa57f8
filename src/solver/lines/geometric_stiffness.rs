//! Geometric stiffness correction, so that taut chains don't shake.
//!
//! A tension straightens a bent chain, along the directions that its links had when it was solved. In a zigzag of amplitude y this moves a particle by up to −4·λ·y/L, where λ
//! is the displacement that the tension gives a particle. Beyond λ = L/2 the particle ends further out on the other side. The rule in time amplifies any overshoot beyond
//! −0.23·y, and the chains that carry a sheet then shake for good. So where tensions are that large, their effect across the chain is computed implicitly: the displacement y'
//! across solves
//!
//! `(1 + w_i·(a_{i−1} + a_i))·y'_i − w_i·a_{i−1}·y'_{i−1} − w_i·a_i·y'_{i+1} = y_i`,  a = max(λ, 0)/L,
//!
//! the geometric stiffness of the links (M. Tournier and others, *Stable constrained dynamics*, 2015). Displacements along the chain stay as they are.

use crate::scalar::{Rounding, Scalar};
use crate::vec3::Vec3;

use super::exponent::Exponent;
use super::tridiagonal::Eliminated;

/// The tension above which a chain is corrected, rest lengths. A zigzag of a single chain needs 0.31; below the corners of a sheet, the tensions of rows, columns and diagonals
/// act on a particle together.
pub(super) const TAUT: f64 = 0.1;

/// The largest tension in the matrix, rest lengths. Larger ones have no further effect, and this one fits fixed point.
const MOST: i32 = 16;

/// The correction to the displacements of a chain of `count` particles, whose links have these directions and tensions (displacements of a particle of inverse mass 1,
/// cells). Tensions and inverse masses are in the unit of multipliers. Zero if the chain is bent by a right angle or more: no tension has straightened it yet.
#[inline(never)] // few chains are that taut
pub(super) fn geometric_stiffness<S: Scalar, const M: usize>(
    normal: &Vec3<[S; M]>,
    tension: &[S; M],
    inverse_mass: &[S; M],
    count: usize,
    inverse_length: S,
    exponent: Exponent,
) -> Vec3<[S; M]> {
    let count = count.min(M);
    let mut across: Vec3<[S; M]> = Vec3::row(Vec3::ZERO);
    let mut by = across;
    let mut factor = [S::ZERO; M];
    let most = exponent.bound(S::from_int(MOST));
    let mut above = Eliminated::NONE;
    let (mut pull, mut direction, mut a, mut f) = (Vec3::ZERO, Vec3::ZERO, S::ZERO, S::ZERO);
    for k in 0..count {
        let w = inverse_mass[k];
        let last = k + 1 == count;
        let (after, force) = if last { (Vec3::ZERO, S::ZERO) } else { (normal.at(k), tension[k]) };
        let next = after.of_length(force, Rounding::NEAREST);
        let moved = (next - pull) * w;
        let along = (after + direction).halve(1);
        let squared = along.dot(along);
        let end = k == 0 || last;
        if !end && squared < S::HALF {
            return Vec3::row(Vec3::ZERO);
        }
        // an end has one link only, and moves along it
        across.set(k, if end { Vec3::ZERO } else { moved - along * moved.dot(along).divide(squared) });
        let b = (force * inverse_length).max(S::ZERO).min(most);
        // 1 + w·(a + b) − w·a·f, without the difference of two large numbers
        above = above.then::<false>(S::ONE + w * (a + b - a * f), w * a, across.at(k));
        by.set(k, above.right);
        f = w * b * above.per_pivot;
        factor[k] = f;
        (pull, direction, a) = (next, after, b);
    }
    // counted to M, so that the compiler sees that no index is out of bounds
    for k in (0..M.saturating_sub(1)).rev() {
        if k + 1 < count {
            let next = by.at(k + 1);
            by.add(k, next * factor[k]);
        }
    }
    for k in 0..count {
        by.set(k, by.at(k) - across.at(k));
    }
    by
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q13, Q24};

    const M: usize = 8;

    /// The rest of a zigzag of this amplitude between two pins, rest lengths, after a solve in which all its links have this tension.
    fn left_of_a_zigzag<S: Scalar>(amplitude: f64, tension: f64) -> [f64; M] {
        let free = |k: usize| k > 0 && k + 1 < M;
        let side = |k: usize| if free(k) { amplitude * [1.0, -1.0][k % 2] } else { 0.0 };
        let mut normal: Vec3<[S; M]> = Vec3::row(Vec3::ZERO);
        for k in 0..M - 1 {
            let (y, length) = (side(k + 1) - side(k), 1.0_f64.hypot(side(k + 1) - side(k)));
            normal.set(k, Vec3::from_f64([1.0 / length, y / length, 0.0]));
        }
        let tensions = core::array::from_fn(|k| if k + 1 < M { S::from_f64(tension) } else { S::ZERO });
        let w = core::array::from_fn(|k| if free(k) { S::ONE } else { S::ZERO });
        let by = geometric_stiffness(&normal, &tensions, &w, M, S::ONE, Exponent::NONE);
        core::array::from_fn(|k| {
            let pull = |k: usize| tension * normal.at(k).to_f64()[1];
            let pulled = if free(k) { pull(k) - pull(k - 1) } else { 0.0 };
            side(k) + pulled + by.at(k).to_f64()[1]
        })
    }

    fn no_zigzag_overshoots<S: Scalar>() {
        for tension in [0.5, 1.0, 4.0, 15.0] {
            let amplitude = 0.05;
            for (k, left) in left_of_a_zigzag::<S>(amplitude, tension).into_iter().enumerate() {
                // an endless zigzag keeps 1/(1 + 4·λ/L) of its amplitude; beside a pin, which has none, up to 1/(1 + 2·λ/L)
                let end = k == 0 || k == M - 1;
                let slack = 2e-3 * amplitude + 200.0 * S::RESOLUTION + if S::NAME == Q13::NAME { 1e-3 } else { 0.0 };
                let left = if k % 2 == 0 { left } else { -left };
                assert!(
                    left > -slack && left < slack + amplitude / (1.0 + 2.0 * tension),
                    "{tension} in {}: {left}",
                    S::NAME
                );
                assert!(!end || left == 0.0, "a pin is moved");
            }
        }
    }

    #[test]
    fn no_tension_turns_a_zigzag_around() {
        no_zigzag_overshoots::<f32>();
        no_zigzag_overshoots::<f64>();
        no_zigzag_overshoots::<Q24>();
        no_zigzag_overshoots::<Q13>();
    }

    #[test]
    fn a_straight_chain_and_a_folded_one_are_left_alone() {
        let mut normal: Vec3<[f64; 3]> = Vec3::row(Vec3::from_f64([1.0, 0.0, 0.0]));
        assert!(
            (0..3).all(|k| geometric_stiffness(&normal, &[2.0, 3.0, 0.0], &[1.0; 3], 3, 1.0, Exponent::NONE).at(k)
                == Vec3::ZERO)
        );
        normal.set(1, Vec3::from_f64([-0.1, -0.99, 0.0]));
        assert!(
            (0..3).all(|k| geometric_stiffness(&normal, &[2.0, 3.0, 0.0], &[1.0; 3], 3, 1.0, Exponent::NONE).at(k)
                == Vec3::ZERO)
        );
    }
}

//! Overflow guard for overstretched chains in fixed point.
//!
//! An exact solve may need multipliers above 127, which wrap and send the chain flying. The multipliers of a chain with a free end are bounded by Σ |residual| × mass beyond
//! the link, and a straight chain reaches the bound. If it is too large, a small ε is added to the diagonal (K. Levenberg, 1944), which bounds every multiplier by
//! max|residual|/ε (J. Varah, 1975). Later sweeps remove the remaining residual.

use crate::scalar::Scalar;

/// The largest number of fixed point.
const RANGE: f64 = 127.0;

/// The binary logarithm of the unit of masses, 16, in which their sums fit.
const SIXTEEN: u32 = 4;

/// The residual up to which no chain of `M` particles needs a check. `span` is the least positive inverse mass, divided by the largest if that is more than 1.
#[inline(always)]
pub(super) fn harmless<S: Scalar, const M: usize>(span: S) -> S {
    span * S::from_f64(const { 2.0 * RANGE / (M * M) as f64 })
}

/// The ε to add to the diagonal of a chain of `count` particles with these residuals and inverse masses, in the unit of multipliers. A chain has a residual less than it has
/// particles; the others are zero.
#[cold]
#[inline(never)]
pub(super) fn regularisation<S: Scalar, const M: usize>(residual: &[S; M], inverse_mass: &[S; M], count: usize) -> S {
    let saturating = |a: S, b: S| a.difference(-b);
    // no mass beyond the chain's end
    let mass: [S; M] = core::array::from_fn(|k| {
        let w = inverse_mass[k];
        if k >= count {
            S::ZERO
        } else if w < S::ONE.halve(2 + SIXTEEN) {
            S::from_f64(S::LARGEST)
        } else {
            w.recip().halve(SIXTEEN)
        }
    });
    let mut before = mass;
    for k in 1..M {
        before[k] = saturating(before[k - 1], mass[k]);
    }
    let [mut after, mut multiplier, mut worst] = [S::ZERO; 3];
    let mut most = S::ONE;
    for k in (1..M).rev() {
        let [here, next] = [inverse_mass[k - 1], inverse_mass[k]];
        after = saturating(after, mass[k]);
        most = most.max(here).max(next);
        // a link between two pins moves nothing
        if here > S::ZERO || next > S::ZERO {
            let residual = residual[k - 1].abs();
            worst = worst.max(residual);
            multiplier = saturating(multiplier, S::narrow(residual.product(after.min(before[k - 1]))));
        }
    }
    // the product of a multiplier and an inverse mass has to fit, too
    let fits = S::narrow(multiplier.product(most)) < S::from_f64(RANGE).halve(SIXTEEN);
    if fits { S::ZERO } else { worst * S::from_f64(2.0 / RANGE) * most }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Q24;

    /// The ε for a chain of four links that are all too long by `residual`.
    fn added(residual: f64, inverse_masses: [f64; 5]) -> f64 {
        regularisation(&[residual; 5].map(Q24::from_f64), &inverse_masses.map(Q24::from_f64), 5).to_f64()
    }

    #[test]
    fn multipliers_are_regularised_where_they_would_wrap() {
        // 4 + 3 + 2 + 1 masses
        let hung = [0.0, 1.0, 1.0, 1.0, 1.0];
        assert_eq!(added(12.6, hung), 0.0);
        assert!((added(12.8, hung) - 12.8 * 2.0 / 127.0).abs() < 1e-6);
        let mut other_end = hung;
        other_end.reverse();
        assert_eq!(
            [12.6, 12.8].map(|residual| added(residual, other_end)),
            [12.6, 12.8].map(|residual| added(residual, hung))
        );
        // eight times the mass
        let exponent = hung.map(|w| w / 8.0);
        assert_eq!(added(12.6 / 8.0, exponent), 0.0);
        assert!(added(12.8 / 8.0, exponent) > 0.0);
        // 1 + 2 + 2 + 1 masses
        assert_eq!(added(21.0, [1.0; 5]), 0.0);
        assert!(added(21.3, [1.0; 5]) > 0.0);
        // no bound between two pins; no need for one if nothing moves
        assert!(added(0.1, [0.0, 1.0, 1.0, 1.0, 0.0]) > 0.0);
        assert_eq!(added(100.0, [0.0; 5]), 0.0);
    }

    #[test]
    fn few_chains_need_a_look() {
        for residual in [0.1, 1.0, 8.0, 100.0] {
            for w in [1.0, 0.5, 0.125, 4.0] {
                let span = Q24::from_f64(if w > 1.0 { 1.0 } else { w });
                if Q24::from_f64(residual) <= harmless::<Q24, 5>(span) {
                    assert_eq!(added(residual, [0.0, w, w, w, w]), 0.0, "{residual} {w}");
                }
            }
        }
    }
}

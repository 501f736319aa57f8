//! A chain of links, solved exactly: a row, a column or a diagonal.
//!
//! With unit normals n, inverse masses w and a strength κ = a/b, the linearised constraints `|d| − L = λ/κ` of a chain form a tridiagonal system. In
//! multipliers μ = λ/a, which fit any number type,
//!
//! `(a·(w_i + w_{i+1}) + b)·μ_i − a·w_i·(n_{i−1}·n_i)·μ_{i−1} − a·w_{i+1}·(n_i·n_{i+1})·μ_{i+1} = |d_i| − L`.
//!
//! Elimination and substitution solve it in one pass each ([`tridiagonal`](super::tridiagonal)); Gauss–Seidel would propagate a correction by one link a sweep. With equal
//! masses and one end free, the pivots stay between a·w and 2·a·w + b. Every chain goes through the same stages: gather the links' directions and residuals, eliminate,
//! substitute, move the particles, and add the [geometric stiffness correction](super::geometric_stiffness) if the chain is taut.

use crate::link::Quotient;
use crate::moment::Moment;
use crate::scalar::{Rest, Rounding, Scalar};
use crate::solver::unit_mass::UnitMass;
use crate::vectors::SIDE_BY_SIDE;

use super::exponent::Exponent;
use super::geometric_stiffness::TAUT;
use super::regularise::harmless;

/// The links of one family, and the data that all their chains share.
pub(super) struct Chain<'a, S: Scalar, const W: usize, const H: usize> {
    pub(super) rest: &'a Rest<S>,
    pub(super) strength: Quotient<S>,
    pub(super) moment: Moment,
    pub(super) rounding: Rounding,
    pub(super) unit_mass: &'a UnitMass<W, H>,
    pub(super) exponent: Exponent,
    /// The least positive inverse mass, divided by the largest if that is more than 1.
    pub(super) span: S,
}

/// Whether products with inverse masses are skipped where all masses are 1: only where a check costs less than the products.
pub(super) const fn skips_masses<S: Scalar>() -> bool {
    S::LOOKING_PAYS || !SIDE_BY_SIDE
}

impl<S: Scalar, const W: usize, const H: usize> Chain<'_, S, W, H> {
    /// The dividend a in the diagonal of the matrix. The last pivot of a taut chain between two pins is nearly the divisor b alone, and the rounding error of light particles'
    /// inverse masses in floats may exceed it. So in floats a is enlarged by a few such errors. Fixed point has no masses that light.
    #[inline(always)]
    pub(super) fn own(&self) -> S {
        let dividend = self.strength.dividend;
        if S::EXACT_SUMS { dividend } else { dividend + S::from_f64(4.0 * S::RESOLUTION) }
    }

    /// The exponent of the multipliers: none where all masses are 1.
    #[inline(always)]
    pub(super) fn exponent<const UNIT_MASS: bool>(&self) -> Exponent {
        if UNIT_MASS { Exponent::NONE } else { self.exponent }
    }

    /// The divisor in the diagonal of a chain of `M` particles whose largest residual is `worst`, in the unit of multipliers. It is larger if the chain is regularised.
    #[inline(always)]
    pub(super) fn divisor<const UNIT_MASS: bool, const M: usize>(
        &self,
        worst: S,
        regularisation: impl FnOnce() -> S,
    ) -> S {
        let span = if UNIT_MASS { S::ONE } else { self.span };
        let divisor = self.exponent::<UNIT_MASS>().scaled(self.strength.divisor);
        if worst.is_within(harmless::<S, M>(span)) { divisor } else { divisor.max(regularisation()) }
    }

    /// Whether a chain has a tension that would make it shake; `most` is the largest change of its multipliers.
    #[inline(always)]
    pub(super) fn is_taut(&self, most: S, exponent: Exponent) -> bool {
        most.scaled(self.strength.dividend) > exponent.bound(self.rest.length * S::from_f64(TAUT))
    }
}

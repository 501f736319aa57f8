//! Multipliers beside heavy particles.
//!
//! A multiplier is the displacement of a particle of mass 1 (over the dividend of the link's strength), and what holds a heavy particle is more of that than fixed
//! point holds. Where not all masses are 1, multipliers are therefore counted in units of 2^shift, and inverse masses and the divisor of the strength
//! are 2^shift times as large: the same equations. Floats need no shift.

use crate::cloth::Cloth;
use crate::scalar::Scalar;

/// The largest shift: 2·2⁵, the sum of two inverse masses, is still held, and so is what moves the largest masses that a scene may have.
const MOST: u32 = 5;

/// How much larger the unit of multipliers is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Heavy {
    shift: u32,
}

impl Heavy {
    /// For the heaviest particle of a sheet whose rows of nothing but particles of mass 1 are `ordinary`: none up to 8 masses, since it costs digits.
    #[inline]
    pub(super) fn new<S: Scalar, const W: usize, const H: usize>(cloth: &Cloth<S, W, H>, ordinary: &[bool; H]) -> Self {
        let mut heavy = Self { shift: 0 };
        if !S::FLOATS {
            let mut least = S::ONE;
            for (row, _) in cloth.inverse_mass.0.iter().zip(ordinary).filter(|(_, ordinary)| !**ordinary) {
                for w in row {
                    if *w > S::ZERO && *w < least {
                        least = *w;
                    }
                }
            }
            while heavy.shift < MOST && heavy.scaled(least) < S::ONE.halve(3) {
                heavy.shift += 1;
            }
        }
        heavy
    }

    /// No shift.
    pub(super) const NONE: Self = Self { shift: 0 };

    /// An inverse mass, a divisor or its product with a multiplier, made larger.
    #[inline(always)]
    pub(super) fn scaled<S: Scalar>(self, number: S) -> S {
        if S::FLOATS { number } else { number.double(self.shift) }
    }

    /// A bound of multipliers, in their unit.
    #[inline(always)]
    pub(super) fn bound<S: Scalar>(self, bound: S) -> S {
        if S::FLOATS { bound } else { bound.halve(self.shift) }
    }
}

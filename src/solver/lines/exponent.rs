//! The power of two by which multipliers are scaled, so that the multiplier of the heaviest free particle fits.
//!
//! A multiplier is the displacement of a particle of mass 1, over the dividend of the link's strength. In units of 2^shift it is a smaller number. Inverse masses and the
//! divisor of the strength are then 2^shift times as large, so the equations stay the same. Masses up to 8 need no scaling, and get none: it costs precision. Floats need none.

use crate::particles::Particles;
use crate::scalar::Scalar;

/// The largest inverse mass after scaling: the sum of two still fits.
const LIGHTEST: i32 = 32;

/// The exponent `shift` of the unit 2^shift of multipliers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Exponent {
    shift: u32,
}

impl Exponent {
    /// The exponent for the heaviest particle of a sheet, zero up to a mass of 8. Rows marked in `unit_mass` have no particle of another mass than 1.
    ///
    /// Also returns, in that unit, the least positive inverse mass divided by the largest if that is more than 1; and whether no particle is lighter than an eighth of a mass.
    #[inline]
    pub(super) fn new<S: Scalar, const W: usize, const H: usize>(
        particles: &Particles<S, W, H>,
        unit_mass: &[bool; H],
    ) -> (Self, S, bool) {
        let mut exponent = Self { shift: 0 };
        let [mut least, mut most] = [S::ONE; 2];
        for (row, _) in particles.inverse_mass.0.iter().zip(unit_mass).filter(|(_, unit_mass)| !**unit_mass) {
            for w in row {
                if *w > S::ZERO {
                    (least, most) = (least.min(*w), most.max(*w));
                }
            }
        }
        let none_is_light = most <= S::from_int(8);
        while !S::ONE.halve(3).is_within(exponent.scaled(least)) && exponent.scaled(most) < S::from_int(LIGHTEST) {
            exponent.shift += 1;
        }
        let [least, most] = [least, most].map(|w| exponent.scaled(w));
        (exponent, if most > S::ONE { least.divide(most) } else { least }, none_is_light)
    }

    /// No scaling.
    pub(super) const NONE: Self = Self { shift: 0 };

    /// An inverse mass, a divisor, or the product of a divisor and a multiplier, times 2^shift.
    #[inline(always)]
    pub(super) fn scaled<S: Scalar>(self, number: S) -> S {
        number.in_smaller_unit(self.shift)
    }

    /// A bound on multipliers, in their unit.
    #[inline(always)]
    pub(super) fn bound<S: Scalar>(self, bound: S) -> S {
        bound.in_larger_unit(self.shift)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloth::Cloth;
    use crate::scalar::Q24;

    fn shift<S: Scalar>(masses: [f64; 2]) -> u32 {
        let mut cloth = Cloth::<S, 2, 1>::BLANK;
        cloth.inverse_mass.0[0] = masses.map(|mass| S::from_f64(1.0 / mass));
        Exponent::new(&cloth, &[false]).0.shift
    }

    #[test]
    fn units_grow_with_the_heaviest_particle_as_far_as_the_lightest_lets_them() {
        assert_eq!([1.0, 2.0, 8.0].map(|mass| shift::<Q24>([1.0, mass])), [0; 3]);
        assert_eq!([9.0, 80.0, 1e6].map(|mass| shift::<Q24>([1.0, mass])), [1, 4, 5]);
        assert_eq!([0.5, 0.05, 0.01].map(|mass| shift::<Q24>([mass, 80.0])), [4, 1, 0]);
        assert_eq!(shift::<f32>([1.0, 80.0]), 0);
    }
}

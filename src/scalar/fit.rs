//! Checks whether a number type represents the constants of a scene.
//!
//! They use integer arithmetic on the bits of an `f64` only, so that firmware which checks a number links no float routine. They are inlined, so that the check
//! of a constant leaves no code.

use super::Scalar;

/// Rounding may change a constant by at most one part in `MOST` of its largest component, 6 %. So a number of eight last places, which has four bits, always
/// fits. A smaller number fits only if its rounding error happens to be small: the digests' shortest steps need some of those.
const MOST: u64 = 16;
/// The number of bits below a type's last place that are checked.
const BELOW: u64 = 20;

const SIGN: u64 = 1 << 63;
const MANTISSA: u64 = (1 << 52) - 1;

/// The quality with which a number type represents a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fit {
    /// To within a sixteenth.
    Well,
    /// Not at all: it exceeds the largest number, or is infinite or undefined.
    TooLarge,
    /// By a number that differs from it by more than a sixteenth.
    Coarsely,
    /// As zero.
    AsZero,
}

/// Whether a number is neither infinite nor undefined.
#[inline(always)]
pub(crate) const fn is_finite(value: f64) -> bool {
    magnitude(value) < 0x7ff << 52
}

/// Whether a number is zero or above, infinity included.
#[inline(always)]
pub(crate) const fn is_not_negative(value: f64) -> bool {
    magnitude(value) <= 0x7ff << 52 && (value.to_bits() & SIGN == 0 || magnitude(value) == 0)
}

/// Whether a number is above zero and finite.
#[inline(always)]
pub(crate) const fn is_positive(value: f64) -> bool {
    is_finite(value) && is_not_negative(value) && magnitude(value) != 0
}

/// Whether the magnitude is within the range of `S`.
#[inline(always)]
pub(crate) const fn is_in_range<S: Scalar>(value: f64) -> bool {
    magnitude(value) <= S::LARGEST.to_bits()
}

/// The quality with which `S` represents a constant of these components. Zero is represented well, and so is a component that is small beside the others.
#[inline(always)]
pub(crate) const fn fit<S: Scalar, const N: usize>(values: [f64; N]) -> Fit {
    let (mut largest, mut error, mut is_zero) = (0, 0, true);
    let mut k = 0;
    while k < N {
        if !is_in_range::<S>(values[k]) {
            return Fit::TooLarge;
        }
        let [places, rounded] =
            if S::EXACT_SUMS { in_places::<S>(values[k]) } else { in_normal_numbers::<S>(values[k]) };
        largest = if places > largest { places } else { largest };
        error = if rounded > error { rounded } else { error };
        is_zero &= magnitude(values[k]) == 0;
        k += 1;
    }
    if is_zero {
        Fit::Well
    } else if largest < 1 << (BELOW - 1) {
        Fit::AsZero
    } else if MOST * error > largest {
        Fit::Coarsely
    } else {
        Fit::Well
    }
}

/// A number's bits without its sign; their order is that of magnitudes.
#[inline(always)]
const fn magnitude(value: f64) -> u64 {
    value.to_bits() & !SIGN
}

/// The magnitude of a fixed-point number in units of its last place, and its distance from a whole number of them, both times 2^[`BELOW`].
#[inline(always)]
const fn in_places<S: Scalar>(value: f64) -> [u64; 2] {
    let fraction = 1023 - (S::RESOLUTION.to_bits() >> 52);
    let exponent = magnitude(value) >> 52;
    // positive, because the number is in range
    let shift = 1075 - fraction - BELOW - exponent;
    let places = if shift < 64 { (magnitude(value) & MANTISSA | 1 << 52) >> shift } else { 0 };
    let beyond = places & ((1 << BELOW) - 1);
    let short = (1 << BELOW) - beyond;
    [places, if beyond < short { beyond } else { short }]
}

/// Floats round all numbers with the same relative error down to the least normal one, 2^(1 − E) for a largest number below 2^(E + 1).
#[inline(always)]
const fn in_normal_numbers<S: Scalar>(value: f64) -> [u64; 2] {
    let exponent = (S::LARGEST.to_bits() >> 52) - 1023;
    [if magnitude(value) < (1024 - exponent) << 52 { 0 } else { 1 << BELOW }, 0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q13, Q24};

    #[test]
    fn rounding_changes_a_constant_by_a_sixteenth_at_most() {
        fn check<S: Scalar>() {
            let last = S::RESOLUTION;
            for k in 1..4000 {
                let value = f64::from(k) * 0.03 * last;
                let rounded = S::from_f64(value).to_f64();
                let expected = if rounded == 0.0 {
                    Fit::AsZero
                } else if (rounded - value).abs() > value / 16.0 {
                    Fit::Coarsely
                } else {
                    Fit::Well
                };
                for value in [value, -value] {
                    assert_eq!(fit::<S, 1>([value]), expected, "{value} in {}", S::NAME);
                    assert_eq!(fit::<S, 2>([0.0, value]), expected, "{value} in {}", S::NAME);
                    assert_eq!(fit::<S, 2>([value, 1.0]), Fit::Well, "{value} in {}", S::NAME);
                }
            }
        }
        check::<Q24>();
        check::<Q13>();
    }

    #[test]
    fn the_ends_of_the_range() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 128.0, -128.0, 1e300] {
            assert_eq!(fit::<Q24, 3>([0.0, value, 1.0]), Fit::TooLarge, "{value}");
        }
        for value in [0.0, -0.0, 1.0, -127.999] {
            assert_eq!(fit::<Q24, 1>([value]), Fit::Well, "{value}");
        }
        for value in [1e-300, -5e-324, 1e-9] {
            assert_eq!(fit::<Q24, 1>([value]), Fit::AsZero, "{value}");
        }
        assert_eq!(
            [1e39, 1e38, 1e-37, 1e-60].map(|value| fit::<f32, 1>([value])),
            [Fit::TooLarge, Fit::Well, Fit::Well, Fit::AsZero]
        );
        assert_eq!([f64::MAX, 1e-307, 1e-310].map(|value| fit::<f64, 1>([value])), [Fit::Well, Fit::Well, Fit::AsZero]);
    }

    #[test]
    fn signs() {
        assert_eq!([1.0, 0.0, -0.0, f64::INFINITY].map(is_not_negative), [true; 4]);
        assert_eq!([-1.0, -5e-324, f64::NAN, f64::NEG_INFINITY].map(is_not_negative), [false; 4]);
        assert_eq!([1.0, 5e-324].map(is_positive), [true; 2]);
        assert_eq!([0.0, -0.0, -1.0, f64::NAN, f64::INFINITY].map(is_positive), [false; 5]);
    }
}

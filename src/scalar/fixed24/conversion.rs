//! Conversion to and from the types of the crate `fixed`, and text.
//!
//! ```
//! use fixed::types::{I8F24, I16F16};
//! use kerchief::Q24;
//!
//! let half: Q24 = I16F16::from_num(0.5).to_num();
//! assert_eq!(I16F16::from_num(half), 0.5);
//! assert_eq!(I8F24::from(half), 0.5);
//! assert_eq!("0.5".parse(), Ok(half));
//! assert_eq!(half.to_string(), "0.5");
//! ```

use core::fmt;
use core::str::FromStr;

use fixed::ParseFixedError;
use fixed::traits::{Fixed, FromFixed, ToFixed};
use fixed::types::I8F24;

use super::{Fixed24, Q13, Q24};

/// Exact.
impl<K> From<I8F24> for Fixed24<K> {
    #[inline]
    fn from(number: I8F24) -> Self {
        Self::from_bits(number.to_bits())
    }
}

/// Exact.
impl<K> From<Fixed24<K>> for I8F24 {
    #[inline]
    fn from(number: Fixed24<K>) -> Self {
        number.0
    }
}

/// Exact: both types have the same numbers.
impl From<Q24> for Q13 {
    #[inline]
    fn from(number: Q24) -> Self {
        number.0.into()
    }
}

/// Exact: both types have the same numbers.
impl From<Q13> for Q24 {
    #[inline]
    fn from(number: Q13) -> Self {
        number.0.into()
    }
}

/// Decimal, with as few digits as distinguish it from its neighbours, unless a precision is given.
impl<K> fmt::Display for Fixed24<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

/// The number nearest to a decimal one; in a tie, the even one: `"-1.5"`, `"2e-3"`.
impl<K> FromStr for Fixed24<K> {
    /// For text that is no number, and for a number that rounds to below −128 or above 128 − 2⁻²⁴.
    type Err = ParseFixedError;

    fn from_str(text: &str) -> Result<Self, ParseFixedError> {
        text.parse::<I8F24>().map(Self::from)
    }
}

/// Like [`I8F24`]: rounds down to a type with fewer fraction bits.
impl<K> ToFixed for Fixed24<K> {
    fn to_fixed<F: Fixed>(self) -> F {
        ToFixed::to_fixed(self.0)
    }

    fn checked_to_fixed<F: Fixed>(self) -> Option<F> {
        self.0.checked_to_fixed()
    }

    fn saturating_to_fixed<F: Fixed>(self) -> F {
        self.0.saturating_to_fixed()
    }

    fn wrapping_to_fixed<F: Fixed>(self) -> F {
        self.0.wrapping_to_fixed()
    }

    fn overflowing_to_fixed<F: Fixed>(self) -> (F, bool) {
        self.0.overflowing_to_fixed()
    }

    fn unwrapped_to_fixed<F: Fixed>(self) -> F {
        self.0.unwrapped_to_fixed()
    }
}

/// Like [`I8F24`]: rounds down from a type with more fraction bits.
impl<K> FromFixed for Fixed24<K> {
    fn from_fixed<F: Fixed>(number: F) -> Self {
        I8F24::from_fixed(number).into()
    }

    fn checked_from_fixed<F: Fixed>(number: F) -> Option<Self> {
        I8F24::checked_from_fixed(number).map(Self::from)
    }

    fn saturating_from_fixed<F: Fixed>(number: F) -> Self {
        I8F24::saturating_from_fixed(number).into()
    }

    fn wrapping_from_fixed<F: Fixed>(number: F) -> Self {
        I8F24::wrapping_from_fixed(number).into()
    }

    fn overflowing_from_fixed<F: Fixed>(number: F) -> (Self, bool) {
        let (number, overflows) = I8F24::overflowing_from_fixed(number);
        (number.into(), overflows)
    }

    fn unwrapped_from_fixed<F: Fixed>(number: F) -> Self {
        I8F24::unwrapped_from_fixed(number).into()
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use std::string::ToString;

    use fixed::types::{I4F28, I16F16, I32F32, U8F8};

    use super::*;
    use crate::scalar::Scalar;

    /// Numbers of all sizes and both ends of the range.
    fn numbers() -> impl Iterator<Item = i32> {
        let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
        ends.into_iter().chain((0_u32..2000).map(|k| (k.wrapping_mul(0x9e37_79b9) as i32) >> (k % 31)))
    }

    #[test]
    fn there_and_back_nothing_is_lost() {
        for number in numbers().map(Q24::from_bits) {
            assert_eq!(Q24::from(I8F24::from(number)), number);
            assert_eq!(Q24::from(Q13::from(number)), number);
            assert_eq!(number.to_fixed(), I8F24::from(number));
            assert_eq!(I32F32::from_num(number).to_num::<Q24>(), number);
            assert_eq!(f64::from(I8F24::from(number)), number.to_f64());
        }
    }

    #[test]
    fn text_is_read_back_as_the_same_number() {
        for bits in numbers() {
            let (number, fast) = (Q24::from_bits(bits), Q13::from_bits(bits));
            assert_eq!(number.to_string().parse(), Ok(number));
            assert_eq!(fast.to_string().parse(), Ok(fast));
            assert_eq!(number.to_string(), fast.to_string());
        }
        assert_eq!(std::format!("{:.3}", Q24::from_f64(-0.125_4)), "-0.125");
        assert_eq!(std::format!("{:+8.2}", Q24::HALF), "   +0.50");
    }

    /// Half a last place is 2⁻²⁵ = 2.98023223876953125e-8.
    #[test]
    fn text_is_rounded_to_nearest() {
        for (text, bits) in [
            ("2.98023223876953125e-8", 0),
            ("2.98023223876953126e-8", 1),
            ("-2.98023223876953125e-8", 0),
            ("8.94069671630859375e-8", 2),
            ("0.1", 1_677_722),
            ("-0.1", -1_677_722),
            ("127.99999997", i32::MAX),
            ("-128", i32::MIN),
        ] {
            assert_eq!(text.parse(), Ok(Q24::from_bits(bits)), "{text}");
        }
        for k in -1000..1000 {
            let value = f64::from(k) * 0.123_456_789;
            assert_eq!(value.to_string().parse(), Ok(Q24::from_f64(value)), "{value}");
        }
    }

    #[test]
    fn what_is_no_number_or_out_of_range_is_refused() {
        for text in ["", "-", "one", "1.2.3", "0x10", "nan", "inf", "128", "-128.1", "1e3", " 1"] {
            assert!(text.parse::<Q24>().is_err() && text.parse::<Q13>().is_err(), "{text:?}");
        }
        assert_eq!("128".parse::<Q24>().unwrap_err().to_string(), "overflow");
    }

    #[test]
    fn other_types_round_and_overflow_as_i8f24_does() {
        let number = Q24::from_f64(-1.0 / 3.0);
        assert_eq!(I16F16::from_num(number), I16F16::from_num(I8F24::from(number)));
        assert_eq!(number.checked_to_fixed::<U8F8>(), None);
        assert_eq!(number.saturating_to_fixed::<U8F8>(), 0);
        assert_eq!(Q24::checked_from_fixed(I16F16::from_num(200)), None);
        assert_eq!(Q24::saturating_from_fixed(I16F16::from_num(200)), Q24::from_bits(i32::MAX));
        assert_eq!(Q13::wrapping_from_fixed(I16F16::from_num(200)), Q13::from_int(-56));
        assert!(Q24::overflowing_from_fixed(I16F16::from_num(-200)).1);
        assert_eq!(Q24::from_fixed(I4F28::from_bits(-1)), Q24::from_bits(-1), "down");
    }
}

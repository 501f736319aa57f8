//! Quotients and roots, without a division and over the whole range.

use super::FRACTION;
use super::newton::{self, inverse_root_wide};
use super::product::{mixed, unsigned};

#[inline]
pub(super) fn saturate(bits: i64) -> i32 {
    bits.clamp(-i64::from(i32::MAX), i64::from(i32::MAX)) as i32
}

/// `a/b`, to the last place; `b ≠ 0`.
///
/// Bounds: with zeros from 0 to 31 the shift is 7 to 38, of a product of 31 and 32 bits.
#[inline(never)]
pub(super) fn divide(a: i32, b: i32) -> i32 {
    // |b| = m·2^(7 − zeros) with 1 ≤ m < 2
    let zeros = b.unsigned_abs().leading_zeros();
    let inverse = newton::reciprocal(b.unsigned_abs() << zeros);
    let quotient = mixed(a, inverse);
    let quotient = saturate(((quotient >> (38 - zeros)) + 1) >> 1);
    if b < 0 { -quotient } else { quotient }
}

/// `a/b` with 24 fraction bits to one part in 2³⁰; `b ≠ 0`.
#[inline(never)]
pub(super) fn quotient(a: u128, b: u128) -> i32 {
    // the first 32 binary digits of both numbers
    let [zeros_a, zeros_b] = [a, b].map(u128::leading_zeros);
    if zeros_a == u128::BITS {
        return 0;
    }
    let [a, b] = [a << zeros_a, b << zeros_b].map(|x| (x >> 96) as u32);
    let product = unsigned(a, newton::reciprocal(b));
    // 1/b has 63 fraction bits, the result 24
    match 39 + zeros_a as i32 - zeros_b as i32 {
        ..=32 => i32::MAX,
        drop @ 33..=64 => (((product >> (drop - 1)) + 1) >> 1).min(i32::MAX as u64) as i32,
        _ => 0,
    }
}

/// The root of a sum of squares with 48 fraction bits.
///
/// Bounds: y ≤ 2³¹, so the upper product is at most 2⁶³ and the lower one adds less than 2³²; the remaining number has 32 bits. With e from −7 to 24 `drop` is
/// −2 to 30.
#[inline]
pub(super) fn root(x: u64) -> i32 {
    if x == 0 {
        return 0;
    }
    // √x = x · 1/√x, with separate exponents so that no bits are lost
    let (y, e) = inverse_root_wide(x);
    let normal = x.leading_zeros();
    let x = x << normal;
    let product = (unsigned((x >> 32) as u32, y) + (unsigned(x as u32, y) >> 32)) >> 32;
    // x has 48 fraction bits and `normal` more, y has 31, the product 64 fewer, the result 24
    let drop = 48 + normal as i32 + 31 - 64 - FRACTION as i32 - e;
    let bits = if drop > 0 { ((product >> (drop - 1)) + 1) >> 1 } else { product << -drop };
    saturate(bits as i64)
}

#[cfg(test)]
mod tests {
    use crate::scalar::wide::Wide;
    use crate::scalar::{Q24, Scalar};

    fn number(value: f64) -> Q24 {
        Q24::from_f64(value)
    }

    #[test]
    fn roots_are_right_to_the_last_place_over_the_whole_range() {
        let mut x = 1e-14_f64;
        while x < 16_000.0 {
            let squares = (x * (1_u64 << 48) as f64) as i64;
            let expected = (squares as f64).sqrt() / 16_777_216.0 * 16_777_216.0;
            let found = Q24::root(Wide::new(squares)).to_bits() as f64;
            assert!((found - expected).abs() <= 1.0 + expected * 1e-9, "{x}: {found} {expected}");
            x *= 1.37;
        }
    }

    #[test]
    fn division_is_right_to_the_last_place() {
        for (a, b) in [(1.0, 3.0), (-1.0, 3.0), (2.5, -0.7), (1e-6, 0.9), (100.0, 1.01)] {
            let (a, b) = (number(a), number(b));
            let error = a.divide(b).to_f64() - a.to_f64() / b.to_f64();
            assert!(error.abs() <= Q24::RESOLUTION, "{a:?} / {b:?}");
        }
        assert_eq!(Q24::ONE.divide(Q24::ZERO).to_bits(), i32::MAX);
    }

    #[test]
    fn quotients_of_sums_are_right_to_nine_digits() {
        let values = [1_i128, 3, 7_919, 1 << 24, 12_345_678_901, (1 << 48) + 1, (1 << 70) - 1, 1 << 100];
        for a in values {
            for b in values {
                let expected = a as f64 / b as f64;
                for (a, expected) in [(a, expected), (-a, -expected)] {
                    let found = Q24::quotient(a, b).to_f64();
                    let bound = Q24::RESOLUTION * 0.51 + expected.abs() * 2e-9;
                    assert!((found - expected.clamp(-Q24::LARGEST, Q24::LARGEST)).abs() <= bound, "{a} / {b}: {found}");
                }
            }
        }
        assert_eq!(Q24::quotient(0, 5), Q24::ZERO);
    }
}

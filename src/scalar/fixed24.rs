//! `Q24`: 8 bits before the point, 24 after it.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use fixed::types::I8F24;

use super::wide::Wide;
use super::{Rest, Scalar};

/// A fixed-point number from −128 to 128 in steps of 2⁻²⁴ (6·10⁻⁸).
///
/// Sums wrap, products are rounded to nearest. (The operators of the crate `fixed` round towards −∞, which pushes a sheet at rest
/// sideways.) Lengths are counted in cells: a sheet may move through 128 cells to either side of the origin.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Q24(I8F24);

const FRACTION: u32 = 24;

impl Q24 {
    /// The number with these bits, `bits / 2²⁴`.
    #[inline]
    pub const fn from_bits(bits: i32) -> Self {
        Self(I8F24::from_bits(bits))
    }

    /// The number's bits, `value · 2²⁴`.
    #[inline]
    pub const fn to_bits(self) -> i32 {
        self.0.to_bits()
    }

    /// The same number as a type of the crate `fixed`.
    pub const fn to_fixed(self) -> I8F24 {
        self.0
    }
}

impl core::fmt::Debug for Q24 {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        core::fmt::Debug::fmt(&self.0, f)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Q24 {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{}p-24", self.to_bits());
    }
}

impl Add for Q24 {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().wrapping_add(other.to_bits()))
    }
}

impl Sub for Q24 {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().wrapping_sub(other.to_bits()))
    }
}

impl Mul for Q24 {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::from_bits(round(self.product(other).signed()) as i32)
    }
}

impl Neg for Q24 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::from_bits(self.to_bits().wrapping_neg())
    }
}

impl AddAssign for Q24 {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Q24 {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// Drops 24 fraction bits, rounding to nearest.
#[inline]
const fn round(product: i64) -> i64 {
    product.wrapping_add(1 << (FRACTION - 1)) >> FRACTION
}

#[inline]
fn saturate(bits: i64) -> Q24 {
    Q24::from_bits(bits.clamp(-i64::from(i32::MAX), i64::from(i32::MAX)) as i32)
}

/// `1/√m` for `1 ≤ m < 4` with 30 fraction bits; the result lies in (½, 1] and has 31 fraction bits (1 is 2³¹).
///
/// A straight line, at most 9 % off, and four steps of Newton's method for `y⁻² = m`, each of which turns the relative error ε
/// into 1.5·ε²: 1.2e-2, 2.2e-4, 7e-8, < 2⁻³¹. No division, no table.
#[inline]
fn inverse_root(m: u32) -> u32 {
    const START: u64 = (1.07 * (1_u64 << 31) as f64) as u64;
    const SLOPE: u64 = (0.153 * (1_u64 << 32) as f64) as u64;
    let m = u64::from(m);
    let mut y = START - ((m * SLOPE) >> 31);
    for _ in 0..4 {
        let square = (y * y) >> 31;
        let defect = (3_u64 << 31) - ((square * m) >> 30);
        y = (y * defect) >> 32;
    }
    y.min(1 << 31) as u32
}

/// `(y, e)` with `1/√x = y · 2^e`, where `y` has 31 fraction bits and lies in (½, 1]; `x > 0` with 48 fraction bits.
#[inline]
fn inverse_root_wide(x: u64) -> (u32, i32) {
    // x = m · 4^half with 1 ≤ m < 4
    let half = (63 - x.leading_zeros() as i32 - 48).div_euclid(2);
    let shift = 2 * half + 18;
    let m = if shift >= 0 { x >> shift } else { x << -shift };
    (inverse_root(m as u32), -half)
}

/// `squares/L²` by 1/L², near one, with 48 fraction bits; it saturates at 2¹⁵, that is 181 rest lengths, where an elongation is 0.9945.
#[inline]
fn ratio(squares: u64, inverse_square: Q24) -> u64 {
    let inverse = inverse_square.to_bits() as u64;
    if squares < 1 << 54 {
        // the product needs up to 86 bits: its upper and its lower part apart
        ((squares >> FRACTION) * inverse + (((squares & 0xff_ffff) * inverse) >> FRACTION)).max(1)
    } else {
        ((u128::from(squares) * u128::from(inverse)) >> FRACTION).min(u128::from(u64::MAX >> 1)) as u64
    }
}

/// `1/√ratio` with 24 fraction bits, rounded to nearest.
#[inline]
fn inverse_stretch(ratio: u64) -> i64 {
    let (y, e) = inverse_root_wide(ratio);
    // y has 31 fraction bits
    let drop = 7 - e;
    if drop > 0 { ((i64::from(y) >> (drop - 1)) + 1) >> 1 } else { i64::from(y) << -drop }
}

/// The largest |e| of [`near_rest`], with 29 fraction bits: links stretched or shortened by up to 1.5 %.
const NEAR: i32 = 1 << 24;

/// e with `squares/L² = 1 + e` and 29 fraction bits, for a link near its rest length up to 2.8 cells: nearly all links at nearly all times.
#[inline(always)]
fn near_rest(squares: u64, inverse_square: Q24) -> Option<i32> {
    if squares >> 51 != 0 {
        return None;
    }
    let ratio = ((squares >> 19) * inverse_square.to_bits() as u64) >> FRACTION;
    let e = (ratio as u32).wrapping_sub(1 << 29) as i32;
    (ratio >> 31 == 0 && -NEAR < e && e < NEAR).then_some(e)
}

/// `e·(1/2 − e·(c₂ − e·(c₃ − e·c₄)))` with 24 fraction bits, |e| ≤ 1/32 with 29.
///
/// Every product keeps its upper word, which takes no shift: e with 36 fraction bits makes one of 32 − 36 = −4 fraction bits less than its other factor, so the
/// coefficients have 24, 20, 16 and 12 of them, which they all fit, and the result has 28. Cut off, they leave an error of 0.1 units of the last place.
#[inline(always)]
fn series(e: i32, [c2, c3, c4]: [f64; 3]) -> Q24 {
    let e = i64::from(e << 7);
    let times = |factor: i32| ((e * i64::from(factor)) >> 32) as i32;
    let c3 = (c3 * (1 << 16) as f64) as i32 - times((c4 * (1 << 12) as f64) as i32);
    let c2 = (c2 * (1 << 20) as f64) as i32 - times(c3);
    let result = times((1 << 23) - times(c2));
    Q24::from_bits((result + 8) >> 4)
}

/// Full range, out of the way of the rest.
#[inline(never)]
#[cold]
fn far_elongation(squares: u64, rest: &Rest<Q24>) -> Q24 {
    if squares == 0 {
        return Q24::ZERO;
    }
    saturate((1 << FRACTION) - inverse_stretch(ratio(squares, rest.inverse_square)))
}

/// Full range, out of the way of the rest.
#[inline(never)]
#[cold]
fn far_gauge(squares: u64, rest: &Rest<Q24>) -> (Q24, Q24) {
    if squares == 0 {
        return (-rest.length, Q24::ZERO);
    }
    let inverse = saturate(inverse_stretch(ratio(squares, rest.inverse_square)));
    (Q24::root(Wide::new(squares as i64)) - rest.length, inverse * rest.inverse)
}

/// Of `1 − 1/√(1 + e)`, the next term would be 63/256·e⁵ < 0.13 units.
const ELONGATION: [f64; 3] = [3.0 / 8.0, 5.0 / 16.0, 35.0 / 128.0];
/// Of `√(1 + e) − 1`, the next term would be 7/256·e⁵ < 0.02 units.
const EXCESS: [f64; 3] = [1.0 / 8.0, 1.0 / 16.0, 5.0 / 128.0];

impl Scalar for Q24 {
    const NAME: &'static str = "q24";
    const ZERO: Self = Self::from_bits(0);
    const ONE: Self = Self::from_bits(1 << FRACTION);
    const HALF: Self = Self::from_bits(1 << (FRACTION - 1));
    const LARGEST: f64 = 127.999_999_94;
    const RESOLUTION: f64 = 1.0 / (1 << FRACTION) as f64;
    const EMPTY: i128 = 0;

    type Product = Wide;
    type Sum = i128;

    #[inline]
    fn from_f64(value: f64) -> Self {
        // Decoded from the bits: a comparison or a product of floats would link a routine.
        let bits = value.to_bits();
        let exponent = ((bits >> 52) & 0x7ff) as i32 - 1075 + FRACTION as i32;
        let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
        let magnitude = if exponent >= 0 {
            i64::from(i32::MAX)
        } else if exponent > -54 {
            (((mantissa >> (-exponent - 1)) + 1) >> 1).min(i32::MAX as u64) as i64
        } else {
            0
        };
        Self::from_bits(if bits >> 63 == 0 { magnitude } else { -magnitude } as i32)
    }

    #[inline]
    fn from_int(value: i32) -> Self {
        Self::from_bits(value << FRACTION)
    }

    #[inline]
    fn to_f64(self) -> f64 {
        f64::from(self.to_bits()) * Self::RESOLUTION
    }

    #[inline]
    fn times(self, factor: i32) -> Self {
        Self::from_bits(self.to_bits().wrapping_mul(factor))
    }

    #[inline]
    fn double(self, shift: u32) -> Self {
        Self::from_bits(self.to_bits().wrapping_shl(shift))
    }

    #[inline]
    fn halve(self, shift: u32) -> Self {
        if shift == 0 {
            return self;
        }
        Self::from_bits(((self.to_bits() >> (shift - 1)).wrapping_add(1)) >> 1)
    }

    #[inline]
    fn rate(self, halves: u32, shift: u32) -> Self {
        self.times(halves as i32).double(shift).halve(1)
    }

    #[inline]
    fn product(self, other: Self) -> Wide {
        Wide::new(i64::from(self.to_bits()) * i64::from(other.to_bits()))
    }

    #[inline]
    fn narrow(product: Wide) -> Self {
        saturate(round(product.signed()))
    }

    #[inline]
    fn root(squares: Wide) -> Self {
        let x = squares.squares();
        if x == 0 {
            return Self::ZERO;
        }
        // √x = x · 1/√x, with the exponents kept apart so that nothing is lost
        let (y, e) = inverse_root_wide(x);
        let normal = x.leading_zeros();
        let product = ((u128::from(x << normal) * u128::from(y)) >> 64) as u64;
        // x has 48 fraction bits and `normal` more, y has 31, the product 64 fewer, the result 24
        let drop = 48 + normal as i32 + 31 - 64 - FRACTION as i32 - e;
        let bits = if drop > 0 { ((product >> (drop - 1)) + 1) >> 1 } else { product << -drop };
        saturate(bits as i64)
    }

    #[inline]
    fn recip(self) -> Self {
        Self::ONE.divide(self)
    }

    #[inline]
    fn divide(self, divisor: Self) -> Self {
        if divisor == Self::ZERO {
            return Self::from_bits(if self < Self::ZERO { -i32::MAX } else { i32::MAX });
        }
        let dividend = i64::from(self.to_bits()) << (FRACTION + 1);
        let twice = dividend / i64::from(divisor.to_bits());
        saturate((twice + 1) >> 1)
    }

    #[inline]
    fn elongation(squares: Wide, rest: &Rest<Self>) -> Self {
        let squares = squares.squares();
        match near_rest(squares, rest.inverse_square) {
            Some(e) => series(e, ELONGATION),
            None => far_elongation(squares, rest),
        }
    }

    #[inline]
    fn gauge(squares: Wide, rest: &Rest<Self>) -> (Self, Self) {
        let squares = squares.squares();
        match near_rest(squares, rest.inverse_square) {
            Some(e) => (series(e, EXCESS) * rest.length, rest.inverse - series(e, ELONGATION) * rest.inverse),
            None => far_gauge(squares, rest),
        }
    }

    #[inline]
    fn round_times(self, factor: i32) -> i32 {
        round(i64::from(self.to_bits()) * i64::from(factor)) as i32
    }

    #[inline]
    fn accumulate(sum: i128, product: Wide) -> i128 {
        sum + i128::from(product.signed())
    }

    #[inline]
    fn quotient(dividend: i128, divisor: i128) -> Self {
        let quotient = (dividend << FRACTION) / divisor;
        Self::from_bits(quotient.clamp(-i128::from(i32::MAX), i128::from(i32::MAX)) as i32)
    }

    #[inline]
    fn root_mean(sum: i128, count: u32) -> Self {
        Self::root(Wide::new((sum / i128::from(count)) as i64))
    }

    #[inline]
    fn bits(self, hash: impl FnMut(u8)) {
        self.to_bits().to_le_bytes().into_iter().for_each(hash);
    }

    #[inline]
    fn word(self) -> u32 {
        self.to_bits() as u32
    }

    #[inline]
    fn is_finite(self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3::Vec3;

    fn number(value: f64) -> Q24 {
        Q24::from_f64(value)
    }

    #[test]
    fn from_f64_rounds_to_nearest_and_saturates() {
        for value in [0.0, 1.0, -1.0, 0.3, -0.3, 1e-9, 127.5, -127.5, 3e-8, -3e-8, 5e-324] {
            let expected = (value * 16_777_216.0_f64).round() as i32;
            assert_eq!(number(value).to_bits(), expected, "{value}");
        }
        assert_eq!(number(1e9).to_bits(), i32::MAX);
        assert_eq!(number(-1e300).to_bits(), -i32::MAX);
    }

    #[test]
    fn near_rest_series_are_right_to_the_last_place() {
        for e in (1 - NEAR..NEAR).step_by(61) {
            let ratio = 1.0 + f64::from(e) / (1 << 29) as f64;
            let places = |found: Q24, expected: f64| (found.to_f64() - expected).abs() / Q24::RESOLUTION;
            assert!(places(series(e, ELONGATION), 1.0 - 1.0 / libm::sqrt(ratio)) < 0.75, "{ratio}");
            assert!(places(series(e, EXCESS), libm::sqrt(ratio) - 1.0) < 0.65, "{ratio}");
        }
    }

    #[test]
    fn products_round_to_nearest() {
        let ulp = Q24::from_bits(1);
        assert_eq!(ulp * Q24::HALF, ulp);
        assert_eq!(-ulp * Q24::HALF, Q24::ZERO);
        assert_eq!((-Q24::from_bits(3)).halve(2), Q24::from_bits(-1));
        assert_eq!(Q24::from_bits(5).halve(2), Q24::from_bits(1));
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
    fn elongation_agrees_with_f64_over_the_whole_range() {
        for length in [1.0, core::f64::consts::SQRT_2, 2.0, 0.37] {
            let rest = Rest::spanning(number(length), Q24::ZERO);
            let length = rest.length.to_f64();
            let mut stretch = 0.02;
            while stretch * length < 120.0 && stretch < 180.0 {
                let d = number(stretch * length);
                let expected = 1.0 - length / d.to_f64();
                let found = Q24::elongation(d.product(d), &rest).to_f64();
                let bound = 2e-7 * (1.0 + expected.abs());
                assert!(
                    (found - expected).abs() < bound.max(expected.abs() * 3e-7),
                    "{length} × {stretch}: {found} {expected}"
                );
                stretch *= 1.013;
            }
        }
    }

    #[test]
    fn a_link_at_rest_length_is_exactly_at_rest() {
        for (across, down) in [(1, 0), (1, 1), (2, 0)] {
            let rest = Rest::spanning(Q24::from_int(across), Q24::from_int(down));
            let squares =
                Q24::from_int(across).product(Q24::from_int(across)) + Q24::from_int(down).product(Q24::from_int(down));
            assert_eq!(Q24::elongation(squares, &rest), Q24::ZERO);
        }
        assert_eq!(Q24::elongation(Wide::new(0), &Rest::spanning(Q24::ONE, Q24::ZERO)), Q24::ZERO);
    }

    #[test]
    fn whole_numbers_are_the_nearest() {
        for (value, factor, expected) in
            [(0.5, 1, 1), (-0.5, 1, 0), (0.49, 1, 0), (-1.51, 1, -2), (127.9, 1_000_000, 127_900_000)]
        {
            assert_eq!(number(value).round_times(factor) / 10, expected / 10, "{value} · {factor}");
            assert_eq!(value.round_times(factor), expected, "{value} · {factor}");
        }
        assert_eq!(number(-0.5).round_times(3), -1);
    }

    #[test]
    fn no_distance_within_the_range_is_too_long() {
        // 208 cells: its square is more than an i64 holds
        let far = Vec3::new(number(120.0), number(-120.0), number(120.0));
        let reach = number(127.0);
        assert!(far.squared() > reach.product(reach));
        assert_eq!(far.length().to_bits(), i32::MAX);
        let rest = Rest::spanning(number(1.5), Q24::ZERO);
        assert!((Q24::elongation(far.squared(), &rest).to_f64() - (1.0 - 1.5 / (120.0 * 3.0_f64.sqrt()))).abs() < 1e-6);
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
}

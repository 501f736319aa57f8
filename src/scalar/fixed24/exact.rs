//! Links by 64-bit products.

use super::kernel::Kernel;
use super::newton::inverse_root_wide;
use super::product::{self, round, signed, unsigned};
use super::quotient::{divide, root, saturate};
use super::{FRACTION, Fixed24, ONE, each};
use crate::scalar::{Rest, Rounding};

/// Products of 64 bits: every result is accurate to its last place or the one before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Exact;

/// `squares/L²` from 1/L², near one, with 48 fraction bits. It saturates at 2¹⁵, which is 181 rest lengths, where an elongation is 0.9945.
///
/// Bounds: 1/L² < 2³¹, so both products are below 2⁶³. After the check the upper one is below 2⁵⁵ and fits once shifted, and the lower one adds less than 2³⁹.
#[inline]
fn ratio(squares: u64, inverse_square: i32) -> u64 {
    let inverse = inverse_square as u32;
    // the product needs up to 95 bits: its upper and lower parts are separate
    let upper = unsigned((squares >> 32) as u32, inverse);
    let lower = unsigned(squares as u32, inverse);
    if upper >> 55 != 0 {
        return u64::MAX >> 1;
    }
    ((upper << 8) + (lower >> FRACTION)).clamp(1, u64::MAX >> 1)
}

/// `1/√ratio` with 24 fraction bits, rounded to nearest. Ratios from 2⁻⁴⁸ to 2¹⁵ give exponents e of −7 to 24: shifts of −17 to 14, of 31 bits in 64.
#[inline]
fn inverse_stretch(ratio: u64) -> i64 {
    let (y, e) = inverse_root_wide(ratio);
    // y has 31 fraction bits
    let drop = 7 - e;
    if drop > 0 { ((i64::from(y) >> (drop - 1)) + 1) >> 1 } else { i64::from(y) << -drop }
}

/// The largest |e| of [`near_rest`], with 29 fraction bits: links with a strain of up to 1.5 % in either direction.
const NEAR: i32 = 1 << 24;

/// e with `squares/L² = 1 + e` and 29 fraction bits, for a link near its rest length up to 2.8 cells: nearly all links at nearly all times.
///
/// Bounds: squares below 2⁵¹ keep 32 bits, their product with 1/L² < 2³¹ is below 2⁶³, and a ratio below 2³¹ fits.
#[inline(always)]
fn near_rest(squares: u64, inverse_square: i32) -> Option<i32> {
    if squares >> 51 != 0 {
        return None;
    }
    let ratio = unsigned((squares >> 19) as u32, inverse_square as u32) >> FRACTION;
    let e = (ratio as u32).wrapping_sub(1 << 29) as i32;
    (ratio >> 31 == 0 && -NEAR < e && e < NEAR).then_some(e)
}

/// `e·(1/2 − e·(c₂ − e·(c₃ − e·c₄)))` with 24 fraction bits, |e| ≤ 1/32 with 29.
///
/// Every product keeps only its upper word, which takes no shift. e with 36 fraction bits gives a product with 32 − 36 = −4 fraction bits fewer than its other
/// factor. So the coefficients have 24, 20, 16 and 12 fraction bits, in which each fits, and the result has 28. The cut-off bits leave an error of 0.1 units of
/// the last place.
#[inline(always)]
fn series(e: i32, [c2, c3, c4]: [f64; 3]) -> i32 {
    let times = |factor: i32| (signed(e << 7, factor) >> 32) as i32;
    let c3 = (c3 * (1 << 16) as f64) as i32 - times((c4 * (1 << 12) as f64) as i32);
    let c2 = (c2 * (1 << 20) as f64) as i32 - times(c3);
    let result = times((1 << 23) - times(c2));
    (result + 8) >> 4
}

/// Coefficients of `1 − 1/√(1 + e)`; the next term would be 63/256·e⁵ < 0.13 units.
const ELONGATION: [f64; 3] = [3.0 / 8.0, 5.0 / 16.0, 35.0 / 128.0];
/// Coefficients of `√(1 + e) − 1`; the next term would be 7/256·e⁵ < 0.02 units.
const EXCESS: [f64; 3] = [1.0 / 8.0, 1.0 / 16.0, 5.0 / 128.0];

/// `1 − L/√squares`.
#[inline]
pub(super) fn elongation<K: Kernel>(squares: u64, rest: &Rest<Fixed24<K>>) -> i32 {
    match near_rest(squares, rest.inverse_square.to_bits()) {
        Some(e) => series(e, ELONGATION),
        None => far_elongation(squares, rest.inverse_square.to_bits()),
    }
}

/// `√squares − L` and `1/√squares`.
#[inline]
pub(super) fn gauge<K: Kernel>(squares: u64, rest: &Rest<Fixed24<K>>) -> (i32, i32) {
    let [length, inverse] = [rest.length.to_bits(), rest.inverse.to_bits()];
    match near_rest(squares, rest.inverse_square.to_bits()) {
        Some(e) => {
            (Exact::multiply(series(e, EXCESS), length), inverse - Exact::multiply(series(e, ELONGATION), inverse))
        }
        None => far_gauge(squares, [length, inverse, rest.inverse_square.to_bits()]),
    }
}

/// Full range; kept out of the inlined fast path.
#[inline(never)]
#[cold]
fn far_elongation(squares: u64, inverse_square: i32) -> i32 {
    if squares == 0 {
        return 0;
    }
    saturate(i64::from(ONE) - inverse_stretch(ratio(squares, inverse_square)))
}

/// Full range; kept out of the inlined fast path.
#[inline(never)]
#[cold]
fn far_gauge(squares: u64, [length, inverse, inverse_square]: [i32; 3]) -> (i32, i32) {
    if squares == 0 {
        return (-length, 0);
    }
    let stretch = saturate(inverse_stretch(ratio(squares, inverse_square)));
    (root(squares) - length, Exact::multiply(stretch, inverse))
}

/// The scalar product at full width.
#[inline(always)]
pub(super) fn dot(a: [i32; 3], b: [i32; 3]) -> i64 {
    let product = |k: usize| signed(a[k], b[k]);
    product(0).wrapping_add(product(1)).wrapping_add(product(2))
}

impl Kernel for Exact {
    const NAME: &'static str = "q24";
    const EDGE: f64 = 1.0 / (1 << super::FRACTION) as f64;
    const STRAY: f64 = 1.0 / 2048.0;

    type Prepared = ();

    #[inline(always)]
    fn prepared(_: i32, _: i32) {}

    #[inline]
    fn multiply(a: i32, b: i32) -> i32 {
        product::rounded(a, b, Rounding::NEAREST)
    }

    #[inline]
    fn scaled(a: i32, ratio: i32, rounding: Rounding) -> i32 {
        product::rounded(a, ratio, rounding)
    }

    #[inline]
    fn reciprocal(x: i32) -> i32 {
        divide(ONE, x)
    }

    #[inline]
    fn correction(d: [i32; 3], rest: &Rest<Fixed24<Self>>, part: i32, rounding: Rounding) -> [i32; 3] {
        let part = Self::multiply(elongation(dot(d, d) as u64, rest), part);
        each(d, |d| product::rounded(d, part, rounding))
    }

    #[inline]
    fn direction(d: [i32; 3], rest: &Rest<Fixed24<Self>>) -> (i32, [i32; 3]) {
        let (excess, inverse) = gauge(dot(d, d) as u64, rest);
        (excess, each(d, |d| Self::multiply(d, inverse)))
    }

    #[inline]
    fn cosine(a: [i32; 3], b: [i32; 3]) -> i32 {
        saturate(round(dot(a, b)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q24, Scalar};

    #[test]
    fn near_rest_series_are_right_to_the_last_place() {
        for e in (1 - NEAR..NEAR).step_by(61) {
            let ratio = 1.0 + f64::from(e) / (1 << 29) as f64;
            let places = |found: i32, expected: f64| (f64::from(found) - expected / Q24::RESOLUTION).abs();
            assert!(places(series(e, ELONGATION), 1.0 - 1.0 / libm::sqrt(ratio)) < 0.75, "{ratio}");
            assert!(places(series(e, EXCESS), libm::sqrt(ratio) - 1.0) < 0.65, "{ratio}");
        }
    }

    #[test]
    fn elongation_agrees_with_f64_over_the_whole_range() {
        for length in [1.0, core::f64::consts::SQRT_2, 2.0, 0.37] {
            let rest = Rest::spanning(Q24::from_f64(length), Q24::ZERO);
            let length = rest.length.to_f64();
            let mut stretch = 0.02;
            while stretch * length < 120.0 && stretch < 180.0 {
                let d = Q24::from_f64(stretch * length);
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
}

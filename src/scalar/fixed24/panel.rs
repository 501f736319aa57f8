//! The pressure of air on a panel by 32-bit products, without root or division.

use super::product::{round, signed};
use super::quotient::{divide, saturate};
use super::{FRACTION, ONE, each};
use crate::scalar::panel::MOST_OF_PANEL;

/// The fraction bits of diagonals, normals and velocities.
const BITS: u32 = 13;
/// The fraction bits of the part of the air's velocity that a corner gains.
const PART: u32 = 20;
/// The fastest air in the fast path, along an axis, cells per tick.
const FASTEST: i32 = 8;

/// The largest normal in the fast path, along an axis, cells².
const WIDEST: i32 = 2;

/// The range of the fast path in the square of a panel's area relative to its rest area, 25 fraction bits.
const LEAST: u32 = 5 << 22;
const LARGEST: u32 = 13 << 22;

/// The constants of a sheet's panels, prepared for 32-bit products.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Panel {
    /// 24 fraction bits.
    pressure: i32,
    /// A₀, 24 fraction bits.
    area: i32,
    /// 1/A₀, 24 fraction bits.
    inverse: i32,
    /// 1/A₀², 11 fraction bits; zero if the constants are outside the range of the fast path.
    inverse_square: u32,
    /// `pressure/A₀² = mantissa·2^(6 − shift − BITS)`, the mantissa of 14 bits.
    mantissa: u32,
    shift: u32,
}

impl Panel {
    pub(super) fn new(pressure: i32, area: i32) -> Self {
        let inverse = divide(ONE, area);
        let panel = Self { pressure, area, inverse, inverse_square: 0, mantissa: 0, shift: 0 };
        // no fast path for a rest area of less than 4/13 of a cell
        if inverse > 13 * (ONE / 4) {
            return panel;
        }
        let inverse_square = saturate(round(signed(inverse, inverse)));
        let product = signed(pressure, inverse_square) as u64;
        let length = 64 - product.leading_zeros();
        // no fast path for `pressure/A₀²` of 128 or more
        if length > 55 {
            return panel;
        }
        let (mantissa, shift) = if product == 0 { (0, 0) } else { ((product >> (length - 14)) as u32, 55 - length) };
        Self { inverse_square: inverse_square as u32 >> 13, mantissa, shift, ..panel }
    }

    /// The fast path of [`Scalar::press`](crate::Scalar::press): panels of 0.79 to 1.27 times their rest area in air of up to 8 cells per tick. The result is
    /// accurate to 2·10⁻⁴, and to the last places of numbers with 13 bits.
    ///
    /// No significant bits overflow: partial sums of products may wrap, but the final sums are small. |n| ≤ 1.28 and |u| ≤ 13.9 give |n·u| ≤ 17.8 < 2^4.2.
    /// `pressure·|n·u|` in 20 bits is at most 2³² before the shift, and is clamped to 0.5 after it. 1/y ≤ 1.6 in 12 bits: their product is below 2³². A part is
    /// at most 0.31. |n|² < 12 and 1/A₀² ≤ 10.6 give y < 128, which fits with 25 fraction bits.
    ///
    /// The normals of panels beyond 32 cells wrap. One in some thousand of them is mistaken for a panel near its rest area: the air then moves it too slowly.
    #[inline(always)]
    pub(super) fn press(
        &self,
        diagonals: [[i32; 3]; 2],
        air: [i32; 3],
        most: impl FnOnce() -> i32,
    ) -> Option<[i32; 3]> {
        let [a, b] = diagonals.map(|diagonal| each(diagonal, |d| shift(d, FRACTION - BITS)));
        let cross = |k: usize, l: usize| shift(times(a[k], b[l]).wrapping_sub(times(a[l], b[k])), BITS + 1);
        let n = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let [i, j, k] = each(n, |n| n.wrapping_add(WIDEST << BITS));
        if (i | j | k) as u32 >= (2 * WIDEST as u32) << BITS {
            return None;
        }
        let square = (dot(n, n) as u32) >> (2 * BITS - 14);
        let y = square.wrapping_mul(self.inverse_square);
        let u = each(air, |u| shift(u, FRACTION - BITS));
        let [i, j, k] = each(u, |u| u.wrapping_add(FASTEST << BITS));
        if y.wrapping_sub(LEAST) >= LARGEST - LEAST || (i | j | k) as u32 >= (2 * FASTEST as u32) << BITS {
            return None;
        }
        let across = shift(dot(n, u), BITS);
        // 3/32 of the velocity; before the division by y, 13/8 times as much
        let bound = (self.inverse as u32 >> (FRACTION - PART)) * 3 / 32;
        let part = ((self.mantissa.wrapping_mul(across.unsigned_abs())) >> self.shift).min(bound * 13 / 8);
        let part = (part.wrapping_mul(reciprocal(y >> 10) >> 3) >> 12).min(bound);
        // inverse masses are at most 128: smaller parts need no limit
        let part = if part < bound >> 7 { part } else { part.min(self.bound(most(), bound)) } as i32;
        // a product of 39 bits by two of 28
        let high = times(part, across >> 8);
        let gain = half(high.wrapping_add(times(part, across & 0xff) >> 8));
        Some(each(n, |n| half(times(n, gain >> 12).wrapping_add(times(n, gain & 0xfff) >> 12))))
    }

    /// The limit of the part for a panel of its rest area, if a corner of a panel of 1 cell² loses at most `most`; `usual` for particles of mass 1.
    #[inline(always)]
    fn bound(&self, most: i32, usual: u32) -> u32 {
        if most < (MOST_OF_PANEL * ONE as f64) as i32 { self.lighter(most) } else { usual }
    }

    #[inline(never)]
    #[cold]
    fn lighter(&self, most: i32) -> u32 {
        (saturate(round(signed(most, self.inverse))) >> (FRACTION - PART)) as u32
    }

    /// Full range; kept out of the inlined fast path. Normals are `m·2^k`, with the largest component of m between 1 and 2.
    #[inline(never)]
    #[cold]
    pub(super) fn press_any(&self, [a, b]: [[i32; 3]; 2], air: [i32; 3], most: i32) -> [i32; 3] {
        let times = |a: i32, b: i32| saturate(round(signed(a, b)));
        let wide = |a: [i32; 3], b: [i32; 3]| {
            let product = |k: usize| signed(a[k], b[k]);
            saturate(round(product(0).wrapping_add(product(1)).wrapping_add(product(2))))
        };
        let cross = |k: usize, l: usize| signed(a[k], b[l]).wrapping_sub(signed(a[l], b[k]));
        let n = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let largest = n[0].unsigned_abs() | n[1].unsigned_abs() | n[2].unsigned_abs();
        if largest == 0 {
            return [0; 3];
        }
        let length = 64 - largest.leading_zeros();
        let m = each(n, |n| if length > 25 { n >> (length - 25) } else { n << (25 - length) } as i32);
        let k = length as i32 - 50;
        let across = wide(m, air);
        let inverse = divide(ONE, wide(m, m));
        let part = times(times(self.pressure, across.saturating_abs()), inverse);
        let mut bound = times(times(most, inverse), self.area) * 2;
        let part = if k > 0 {
            if part > bound >> k { bound } else { part << k }
        } else {
            bound = bound.min(times(most, self.inverse) >> (-2 * k).min(31));
            (part >> (-k).min(31)).min(bound)
        };
        let gain = times(part, across);
        each(m, |m| times(m, gain))
    }
}

/// 1/y for y from 5/8 to 13/8, both with 15 fraction bits: a straight line, at most 11 % off, and two steps of Newton's method, which leave an error of
/// 1.4·10⁻⁴.
#[inline(always)]
const fn reciprocal(y: u32) -> u32 {
    const START: u32 = (1.9726 * (1 << 15) as f64) as u32;
    const SLOPE: u32 = (0.87671 * (1 << 15) as f64) as u32;
    let mut z = START - ((y * SLOPE) >> 15);
    z = (z * ((2 << 15) - ((y * z) >> 15))) >> 15;
    (z * ((2 << 15) - ((y * z) >> 15))) >> 15
}

/// `bits/2^by`, rounded to nearest.
#[inline(always)]
const fn shift(bits: i32, by: u32) -> i32 {
    bits.wrapping_add(1 << (by - 1)) >> by
}

#[inline(always)]
const fn half(bits: i32) -> i32 {
    bits.wrapping_add(1) >> 1
}

#[inline(always)]
const fn times(a: i32, b: i32) -> i32 {
    a.wrapping_mul(b)
}

#[inline(always)]
const fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    times(a[0], b[0]).wrapping_add(times(a[1], b[1])).wrapping_add(times(a[2], b[2]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q13, Scalar};

    /// Numbers from −1 to 1.
    fn random() -> impl FnMut() -> f64 {
        let mut state = 1_u64;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }
    }

    fn norm(x: [f64; 3]) -> f64 {
        libm::sqrt(x.iter().map(|x| x * x).sum())
    }

    /// The error of a panel's gain relative to `f64`, and the gain.
    fn compare(diagonals: [[f64; 3]; 2], air: [f64; 3], [pressure, area, most]: [f64; 3]) -> [f64; 2] {
        let numbers = |x: [f64; 3]| x.map(Q13::from_f64);
        let wide = |x: [f64; 3]| numbers(x).map(Q13::to_f64);
        let [p, a, m] = [pressure, area, most].map(Q13::from_f64);
        let (numbers_of, panel) = (diagonals.map(numbers), Q13::panel(p, a));
        let found = Q13::press(numbers_of, numbers(air), &panel, || m);
        let found = found.unwrap_or_else(|| Q13::press_any(numbers_of, numbers(air), &panel, m)).map(Q13::to_f64);
        let exact = f64::panel(p.to_f64(), a.to_f64());
        let exact = f64::press_any(diagonals.map(wide), wide(air), &exact, m.to_f64());
        [norm(core::array::from_fn(|k| found[k] - exact[k])), norm(exact)]
    }

    #[test]
    fn panels_near_rest_agree_with_f64() {
        let mut random = random();
        for k in 0..100_000 {
            let area = [1.0, 0.8, 0.5, 0.32][k % 4];
            let side = libm::sqrt(area * 2.0);
            let (stretch, turn) = (1.0 + 0.15 * random(), 0.1 * random());
            let [a, b] = [[side, turn, 0.3 * random()], [turn * random(), side * stretch, 0.3 * random()]];
            let speed = [0.05, 0.5, 3.0, 7.0][k / 4 % 4];
            let air = [random(), random(), random()].map(|u| speed * u);
            let pressure = [1e-3, 0.02, 0.3, 20.0][k / 16 % 4];
            let [error, gain] = compare([a, b], air, [pressure, area, 3.0 / 32.0]);
            // the last places of velocity, normal and part
            let across = 1e-4 + 3e-4 * norm(air);
            let slope = 2.0 * libm::sqrt(gain * pressure).min(3.0 / 32.0) / area;
            let bound = 5e-4 * gain + across * slope + 3e-6 * norm(air) + 3e-7;
            assert!(error < bound, "{error:e} of {gain:e}: {a:?} {b:?} {air:?} {pressure}");
        }
    }

    #[test]
    fn panels_of_any_size_in_any_air_agree_with_f64() {
        let mut random = random();
        for k in 0..100_000 {
            let area = [1.0, 0.7, 0.1, 0.01][k % 4];
            let mut size = || libm::exp2(3.5 * random() - 1.5);
            let sizes = [size(), size()];
            let diagonals = sizes.map(|size| [random(), random(), random()].map(|x| size * x));
            let air = [random(), random(), random()].map(|u| 20.0 * u);
            let most = if k % 3 == 0 { 3.0 / 32.0 } else { 15.0 / 128.0 / 100.0 };
            let [error, gain] = compare(diagonals, air, [0.3, area, most]);
            // for small panels a part has few places
            let bound = 2e-3 * gain + 5e-3 * most * area * norm(air) + 3e-5;
            assert!(error < bound, "{error:e} of {gain:e}: {diagonals:?} {air:?} {area} {most}");
        }
    }

    #[test]
    fn quotients_are_right_to_their_bound() {
        for y in (5 << 12)..(13_u32 << 12) {
            let expected = (1_u64 << 30) as f64 / f64::from(y);
            assert!((f64::from(reciprocal(y)) / expected - 1.0).abs() < 2.5e-4, "{y}");
        }
    }
}

//! Links by 32-bit products: a Cortex-M0 has no wider multiplication.

use super::exact::{self, dot};
use super::kernel::Kernel;
use super::quotient::divide;
use super::{FRACTION, Fixed24, ONE, each, product};
use crate::scalar::{Rest, Rounding};

/// Link vectors of 13 fraction bits, products of 32 bits: links are measured to 6·10⁻⁵ cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Short;

/// The fraction bits of a link vector.
const EDGE: u32 = 13;

/// `bits/2^shift`, rounded to nearest.
#[inline(always)]
const fn shift(bits: i32, shift: u32) -> i32 {
    bits.wrapping_add(1 << (shift - 1)) >> shift
}

/// `bits/2^shift` with the given rounding, for shifts of 8 and more.
#[inline(always)]
const fn rounded(bits: i32, shift: u32, rounding: Rounding) -> i32 {
    bits.wrapping_add((rounding.offset() as i32) << (shift - 8)) >> shift
}

#[inline(always)]
const fn times(a: i32, b: i32) -> i32 {
    a.wrapping_mul(b)
}

/// A link's vector d and `|d|² − L²`.
struct Edge {
    /// 13 fraction bits.
    d: [i32; 3],
    /// 26 fraction bits.
    e: i32,
}

impl Edge {
    /// The vector of a link near its rest length: `||d|² − L²| ≤ L²/8`, that is a strain within 6 %, for L between 0.61 and 2.8 cells.
    ///
    /// For shorter links the series would overflow.
    ///
    /// Squares wrap at 64 cells²: of links longer than 7.5 cells, one in a hundred is mistaken for a link near its rest length. A correction then moves it by
    /// less than a cell. Callers that need the direction check [`is_short`](Self::is_short).
    #[inline(always)]
    fn near(d: [i32; 3], rest: &Rest<Fixed24<Short>>) -> Option<Self> {
        let square = rest.square.to_bits();
        let near = if (3 * (ONE / 8)..8 * ONE).contains(&square) { square >> 1 } else { 0 };
        let d = each(d, |d| shift(d, FRACTION - EDGE));
        let [x, y, z] = each(d, |d| times(d, d));
        let e = x.wrapping_add(y).wrapping_add(z).wrapping_sub(square.wrapping_shl(2));
        ((e.wrapping_add(near) as u32) < 2 * near as u32).then_some(Self { d, e })
    }

    /// Whether no component exceeds 4 cells: then squares have not wrapped, and `d/|d|` is a direction.
    #[inline(always)]
    fn is_short(&self) -> bool {
        let [x, y, z] = each(self.d, |d| d.wrapping_add(4 << EDGE));
        ((x | y | z) as u32) < 8 << EDGE
    }

    /// `e·(a − e·(b − e·c))` with 20 fraction bits; a and b with 17, c with 15.
    ///
    /// Nothing overflows: |e| ≤ L²/8·2¹⁶, L² ≥ 3/8, and a part is at most 1. The largest coefficients are those of 1/|d|, in bits a ≤ L⁻³·2¹⁶, b ≤ 3·L⁻⁵·2¹⁴
    /// and c ≤ 5·L⁻⁷·2¹¹. So `e·c` ≤ 5/8·L⁻⁵·2²⁷ ≤ 0.91·2³⁰, which adds up to 5/48 to b. `e·(b − e·c)` ≤ 1.11·3/8·L⁻³·2³⁰ ≤ 1.82·2³⁰, which adds up to 0.052 to
    /// a. The last product is within 1.06·L⁻¹·2²⁹ ≤ 0.87·2³⁰.
    #[inline(always)]
    fn series(&self, [a, b, c]: [i32; 3], rounding: Rounding) -> i32 {
        let e = shift(self.e, 10);
        let inner = b.wrapping_sub(times(e, c) >> 14);
        let inner = a.wrapping_sub(times(e, inner) >> 16);
        rounded(times(e, inner), 13, rounding)
    }
}

/// Full range; kept out of the inlined fast path.
#[inline(never)]
#[cold]
fn far_correction(d: [i32; 3], rest: &Rest<Fixed24<Short>>, part: i32, rounding: Rounding) -> [i32; 3] {
    let part = Short::multiply(exact::elongation(dot(d, d) as u64, rest), part);
    each(d, |d| product::rounded(d, part, rounding))
}

/// Full range; kept out of the inlined fast path.
#[inline(never)]
#[cold]
fn far_direction(d: [i32; 3], rest: &Rest<Fixed24<Short>>) -> (i32, [i32; 3]) {
    let (excess, inverse) = exact::gauge(dot(d, d) as u64, rest);
    (excess, each(d, |d| Short::multiply(d, inverse)))
}

/// Full range; kept out of the inlined fast path.
#[inline(never)]
#[cold]
fn far_reciprocal(x: i32) -> i32 {
    divide(ONE, x)
}

/// The coefficients of [`Edge::series`] for a rest length L.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Powers {
    /// 1/L, L⁻³ and L⁻⁵, for L·(√(1 + ε) − 1).
    excess: [i32; 3],
    /// L⁻³, 3·L⁻⁵ and 5·L⁻⁷, for (1 − 1/√(1 + ε))/L.
    less: [i32; 3],
}

impl Kernel for Short {
    type Prepared = Powers;

    fn prepared(inverse: i32, square: i32) -> Powers {
        let third = Self::multiply(inverse, square);
        let fifth = Self::multiply(third, square);
        let seventh = Self::multiply(fifth, square);
        Powers {
            excess: [inverse >> 8, third >> 10, fifth >> 13],
            less: [third >> 8, (fifth >> 10) * 3, (seventh >> 13) * 5],
        }
    }

    const NAME: &'static str = "q13";
    const EDGE: f64 = 1.0 / (1 << EDGE) as f64;
    const STRAY: f64 = 8.0 * <Self as Kernel>::EDGE;

    #[inline(always)]
    fn multiply(a: i32, b: i32) -> i32 {
        product::rounded(a, b, Rounding::NEAREST)
    }

    /// Uses 14 fraction bits of the ratio: two products instead of the four of [`multiply`](Self::multiply).
    #[inline(always)]
    fn scaled(a: i32, ratio: i32, rounding: Rounding) -> i32 {
        let ratio = shift(ratio, 10);
        times(a >> 16, ratio).wrapping_shl(2).wrapping_add(rounded(times(a & 0xffff, ratio), 14, rounding))
    }

    /// Accurate to 5·10⁻⁵.
    ///
    /// Nothing overflows: `m·SLOPE < 2¹⁶·2¹⁵`, `m·y < 2³²` as y < 2¹⁶. With `m·y = 2³¹·(1 − ε)` the last product is `y·2¹⁶·(1 + ε) = 2⁴⁷/m·(1 − ε²) ≤ 2³²`, up
    /// to a rounding error; a test tries every m.
    #[inline(always)]
    fn reciprocal(x: i32) -> i32 {
        const START: u32 = (24 << 16) / 17;
        const SLOPE: u32 = (8 << 16) / 17;
        // most arguments are pivots, between 1 and 4
        if !(ONE..4 * ONE).contains(&x) {
            return far_reciprocal(x);
        }
        let exponent = x as u32 >> 25;
        // the rest follows [`newton::reciprocal`], with 15 fraction bits of m and 16 of y
        let m = (x >> 9 >> exponent) as u32;
        let mut y = START - ((m * SLOPE) >> 15);
        for _ in 0..2 {
            y = (y * ((1 << 17) - ((m * y) >> 15))) >> 16;
        }
        (y << 8 >> exponent) as i32
    }

    #[inline(always)]
    fn correction(d: [i32; 3], rest: &Rest<Fixed24<Self>>, part: i32, rounding: Rounding) -> [i32; 3] {
        let Some(edge) = Edge::near(d, rest) else { return far_correction(d, rest, part, rounding) };
        // part·(1 − 1/√(1 + ε)), ε = e/L²: the next term would be 35/128·ε⁴ < 7e-5
        let once = Self::multiply(part, rest.inverse_square.to_bits());
        let twice = Self::multiply(once, rest.inverse_square.to_bits());
        let thrice = Self::multiply(twice, rest.inverse_square.to_bits());
        let part = edge.series([once >> 8, (twice >> 10) * 3, (thrice >> 13) * 5], rounding);
        each(edge.d, |d| rounded(times(d, part), 9, rounding))
    }

    #[inline(always)]
    fn direction(d: [i32; 3], rest: &Rest<Fixed24<Self>>) -> (i32, [i32; 3]) {
        let Some(edge) = Edge::near(d, rest).filter(Edge::is_short) else { return far_direction(d, rest) };
        let inverse = rest.inverse.to_bits();
        let excess = edge.series(rest.prepared.excess, Rounding::NEAREST);
        let less = edge.series(rest.prepared.less, Rounding::NEAREST);
        let inverse = shift(inverse, 7).wrapping_sub(shift(less, 3));
        (excess << 4, each(edge.d, |d| shift(times(d, inverse), 6)))
    }

    #[inline(always)]
    fn cosine(a: [i32; 3], b: [i32; 3]) -> i32 {
        // components are within 1.01·2¹⁵, the sum of their products by Cauchy and Schwarz within 1.03·2³⁰
        let product = |k: usize| times(shift(a[k], 9), shift(b[k], 9));
        shift(product(0).wrapping_add(product(1)).wrapping_add(product(2)), 6)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q13, Scalar};

    /// Numbers of all magnitudes and both signs.
    fn some(count: usize) -> impl Iterator<Item = i32> {
        let mut state = 1_u64;
        (0..count).map(move |k| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 32) as i32 >> (k % 32)
        })
    }

    #[test]
    fn products_with_ratios_are_right_to_fourteen_bits_of_the_ratio() {
        for (a, ratio) in some(40_000).zip(some(50_001).skip(10_001)) {
            let ratio = ratio % (ONE + 1);
            let expected = f64::from(a) * f64::from(ratio) / f64::from(ONE);
            let error = (f64::from(Short::scaled(a, ratio, Rounding::NEAREST)) - expected).abs();
            assert!(error <= 0.51 + f64::from(a).abs() / f64::from(1 << 15), "{a} · {ratio}");
            assert_eq!(Short::scaled(a, ONE, Rounding::NEAREST), a);
        }
    }

    #[test]
    fn reciprocals_are_right_to_their_bound() {
        for x in (ONE / 2..5 * ONE).step_by(977) {
            let expected = f64::from(ONE) * f64::from(ONE) / f64::from(x);
            assert!((f64::from(Short::reciprocal(x)) / expected - 1.0).abs() < 5e-5, "{x}");
        }
    }

    #[test]
    fn links_agree_with_f64_over_the_whole_range() {
        let unit = [0.36, -0.48, 0.8];
        for length in [0.37, 0.6, 0.65, 0.71, 1.0, core::f64::consts::SQRT_2, 2.0] {
            let rest = Rest::<Q13>::spanning(Q13::from_f64(length), Q13::ZERO);
            let mut stretch = 0.1;
            while stretch * length < 7.0 {
                let d = unit.map(|component| Q13::from_f64(component * length * stretch));
                let exact = libm::sqrt(d.map(|d| d.to_f64() * d.to_f64()).iter().sum::<f64>());
                // half a last place of a link vector in three components, roundings, and the first term omitted by a series
                let strain = stretch - 1.0;
                let bound = 1.3e-4 + if strain.abs() < 0.07 { 5.0 * strain.powi(4) * length } else { 0.0 };
                let (excess, normal) = Q13::direction(d, &rest);
                assert!((excess.to_f64() - (exact - length)).abs() < bound, "{length} × {stretch}: {excess:?}");
                for (normal, d) in normal.into_iter().zip(d) {
                    assert!(
                        (normal.to_f64() - d.to_f64() / exact).abs() < 2.5 * bound / length,
                        "{length} × {stretch}"
                    );
                }
                let by = Q13::correction(d, &rest, Q13::HALF, Rounding::NEAREST);
                for (by, d) in by.into_iter().zip(d) {
                    let expected = 0.5 * (1.0 - length / exact) * d.to_f64();
                    assert!((by.to_f64() - expected).abs() < bound.max(1e-6 * expected.abs()), "{length} × {stretch}");
                }
                stretch *= 1.007;
            }
        }
    }

    /// Links longer than the length at which squares wrap.
    #[test]
    fn directions_of_long_links_are_right() {
        let rest = Rest::<Q13>::spanning(Q13::ONE, Q13::ZERO);
        for k in 0..200_000 {
            let length = 3.0 + 6e-4 * f64::from(k);
            let d = [0.36, -0.48, 0.8].map(|component| Q13::from_f64(component * length));
            let exact = libm::sqrt(d.map(|d| d.to_f64() * d.to_f64()).iter().sum::<f64>());
            let (excess, normal) = Q13::direction(d, &rest);
            assert!((excess.to_f64() - (exact - 1.0)).abs() < 1e-6, "{length}: {excess:?}");
            for (normal, d) in normal.into_iter().zip(d) {
                assert!((normal.to_f64() - d.to_f64() / exact).abs() < 1e-5, "{length}: {normal:?}");
            }
        }
    }

    #[test]
    fn a_link_at_rest_length_is_exactly_at_rest() {
        for (across, down) in [(1, 0), (1, 1), (2, 0)] {
            let rest = Rest::<Q13>::spanning(Q13::from_int(across), Q13::from_int(down));
            let d = [Q13::from_int(across), Q13::ZERO, Q13::from_int(down)];
            assert_eq!(Q13::correction(d, &rest, Q13::HALF, Rounding::NEAREST), [Q13::ZERO; 3]);
            assert_eq!(Q13::direction(d, &rest).0, Q13::ZERO);
        }
    }

    #[test]
    fn coincident_particles_have_no_direction() {
        let rest = Rest::<Q13>::spanning(Q13::ONE, Q13::ZERO);
        assert_eq!(Q13::correction([Q13::ZERO; 3], &rest, Q13::HALF, Rounding::NEAREST), [Q13::ZERO; 3]);
        assert_eq!(Q13::direction([Q13::ZERO; 3], &rest), (-Q13::ONE, [Q13::ZERO; 3]));
    }

    /// Every reciprocal of a pivot: only the upper 16 bits matter.
    #[test]
    fn every_reciprocal_is_right_to_its_bound() {
        for exponent in 0..2 {
            for m in 1 << 15..1 << 16 {
                // the smallest and the largest number with these bits
                for x in [m << 9 << exponent, ((m + 1) << 9 << exponent) - 1] {
                    let expected = f64::from(ONE) * f64::from(ONE) / f64::from(x);
                    assert!((f64::from(Short::reciprocal(x)) / expected - 1.0).abs() < 5e-5, "{x}");
                }
            }
        }
    }

    /// The corners of the overflow bounds: the shortest and the longest link of the fast path, at its largest strain, with the largest part.
    #[test]
    fn nothing_overflows_at_the_corners() {
        for length in [0.613, 0.65, 0.6667, 0.7072, 1.0, 2.0, 2.82] {
            let rest = Rest::<Q13>::spanning(Q13::from_f64(length), Q13::ZERO);
            for strain in [-0.064, -0.06, 0.05, 0.06] {
                for axis in 0..3 {
                    let mut d = [Q13::ZERO; 3];
                    d[axis] = Q13::from_f64(length * (1.0 + strain));
                    let (excess, normal) = Q13::direction(d, &rest);
                    // roundings, and the terms omitted by the series
                    let bound = 1.3e-4 + 5.0 * strain.powi(4) * length;
                    assert!((excess.to_f64() - length * strain).abs() < bound, "{length} × {strain}: {excess:?}");
                    assert!(
                        (normal[axis].to_f64() - 1.0).abs() < 2.5 * bound / length,
                        "{length} × {strain}: {normal:?}"
                    );
                    for part in [-1.0, 0.5, 1.0] {
                        let by = Q13::correction(d, &rest, Q13::from_f64(part), Rounding::NEAREST)[axis].to_f64();
                        assert!((by - part * length * strain).abs() < 2.0 * bound, "{length} × {strain}, {part}: {by}");
                    }
                }
            }
        }
    }
}

//! Links in 32-bit products: the one wide multiplication that a Cortex-M0 has.

use super::exact::{self, dot};
use super::kernel::Kernel;
use super::{FRACTION, Fixed24, ONE, divide};
use crate::scalar::Rest;

/// Edges of 13 fraction bits, products of 32 bits: links are measured to 6·10⁻⁵ cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Short;

/// The fraction bits of an edge.
const EDGE: u32 = 13;

/// `bits/2^shift`, rounded to nearest.
#[inline(always)]
const fn shift(bits: i32, shift: u32) -> i32 {
    bits.wrapping_add(1 << (shift - 1)) >> shift
}

#[inline(always)]
const fn times(a: i32, b: i32) -> i32 {
    a.wrapping_mul(b)
}

/// A link's edge d and `|d|² − L²`.
struct Edge {
    /// 13 fraction bits.
    d: [i32; 3],
    /// 26 fraction bits.
    e: i32,
}

impl Edge {
    /// The edge of a link near its rest length: `||d|² − L²| ≤ L²/8`, that is a strain within 6 %, for L between a half and 2.8 cells.
    ///
    /// Squares wrap at 64 cells²: one link in a hundred that are longer than 7.5 cells is taken for one near its rest length, and moved by less than a cell.
    #[inline(always)]
    fn near(d: [i32; 3], rest: &Rest<Fixed24<Short>>) -> Option<Self> {
        let square = rest.square.to_bits();
        let near = if square >= ONE / 4 && square < 8 * ONE { square >> 1 } else { 0 };
        let d = d.map(|d| shift(d, FRACTION - EDGE));
        let [x, y, z] = d.map(|d| times(d, d));
        let e = x.wrapping_add(y).wrapping_add(z).wrapping_sub(square.wrapping_shl(2));
        ((e.wrapping_add(near) as u32) < 2 * near as u32).then_some(Self { d, e })
    }

    /// `e·(a − e·(b − e·c))` with 20 fraction bits; a, b, c with 17.
    #[inline(always)]
    fn series(&self, [a, b, c]: [i32; 3]) -> i32 {
        let e = shift(self.e, 10);
        let inner = b.wrapping_sub(times(e, c) >> 16);
        let inner = a.wrapping_sub(times(e, inner) >> 16);
        shift(times(e, inner), 13)
    }
}

/// Full range, out of the way of the rest.
#[inline(never)]
#[cold]
fn far_correction(d: [i32; 3], rest: &Rest<Fixed24<Short>>, part: i32) -> [i32; 3] {
    let part = Short::multiply(exact::elongation(dot(d, d) as u64, rest), part);
    d.map(|d| Short::multiply(d, part))
}

/// Full range, out of the way of the rest.
#[inline(never)]
#[cold]
fn far_direction(d: [i32; 3], rest: &Rest<Fixed24<Short>>) -> (i32, [i32; 3]) {
    let (excess, inverse) = exact::gauge(dot(d, d) as u64, rest);
    (excess, d.map(|d| Short::multiply(d, inverse)))
}

/// Full range, out of the way of the rest.
#[inline(never)]
#[cold]
fn far_reciprocal(x: i32) -> i32 {
    divide(ONE, x)
}

/// Whether the machine multiplies to 64 bits. (Rust can't be asked for that; of the machines with the Thumb instructions it is those with atomics.)
const WIDE: bool = cfg!(not(target_arch = "arm")) || cfg!(target_has_atomic = "32");

/// The product of two numbers, by parts of 16 bits: a third of the instructions of a product of 64.
#[inline(always)]
const fn by_parts(a: i32, b: i32) -> i32 {
    let [low_a, low_b] = [a & 0xffff, b & 0xffff];
    let [high_a, high_b] = [a >> 16, b >> 16];
    let low = times(low_a, low_b) as u32 >> 16;
    let middle = times(high_a, low_b).wrapping_add(low as i32);
    let lower = times(low_a, high_b).wrapping_add(middle & 0xffff);
    let high = times(high_a, high_b).wrapping_add(middle >> 16);
    high.wrapping_shl(8).wrapping_add(shift(lower, 8))
}

impl Kernel for Short {
    const NAME: &'static str = "q13";

    #[inline(always)]
    fn multiply(a: i32, b: i32) -> i32 {
        if WIDE { exact::Exact::multiply(a, b) } else { by_parts(a, b) }
    }

    /// To 14 fraction bits of the ratio: two products, where [`multiply`](Self::multiply) has four.
    #[inline(always)]
    fn scaled(a: i32, ratio: i32) -> i32 {
        let ratio = shift(ratio, 10);
        times(a >> 16, ratio).wrapping_shl(2).wrapping_add(shift(times(a & 0xffff, ratio), 14))
    }

    /// Right to 5·10⁻⁵.
    #[inline(always)]
    fn reciprocal(x: i32) -> i32 {
        // most are those of pivots, between 1 and 4
        if x < ONE || x >= 4 * ONE {
            return far_reciprocal(x);
        }
        let exponent = x as u32 >> 25;
        // from here on as in [`newton::reciprocal`], m with 15 fraction bits, y with 16
        const START: u32 = (24 << 16) / 17;
        const SLOPE: u32 = (8 << 16) / 17;
        let m = (x >> 9 >> exponent) as u32;
        let mut y = START - ((m * SLOPE) >> 15);
        for _ in 0..2 {
            y = (y * ((1 << 17) - ((m * y) >> 15))) >> 16;
        }
        (y << 8 >> exponent) as i32
    }

    #[inline(always)]
    fn correction(d: [i32; 3], rest: &Rest<Fixed24<Self>>, part: i32) -> [i32; 3] {
        let Some(edge) = Edge::near(d, rest) else { return far_correction(d, rest, part) };
        // part·(1 − 1/√(1 + ε)), ε = e/L²: the next term would be 35/128·ε⁴ < 7e-5
        let once = Self::multiply(part, rest.inverse_square.to_bits());
        let twice = Self::multiply(once, rest.inverse_square.to_bits());
        let thrice = Self::multiply(twice, rest.inverse_square.to_bits());
        let part = edge.series([once >> 8, (twice >> 10) * 3, (thrice >> 11) * 5]);
        edge.d.map(|d| shift(times(d, part), 9))
    }

    #[inline(always)]
    fn direction(d: [i32; 3], rest: &Rest<Fixed24<Self>>) -> (i32, [i32; 3]) {
        let Some(edge) = Edge::near(d, rest) else { return far_direction(d, rest) };
        let inverse = rest.inverse.to_bits();
        let square = rest.inverse_square.to_bits();
        let third = Self::multiply(inverse, square);
        let fifth = Self::multiply(third, square);
        let seventh = Self::multiply(fifth, square);
        // L·(√(1 + ε) − 1) and (1 − 1/√(1 + ε))/L
        let excess = edge.series([inverse >> 8, third >> 10, fifth >> 11]);
        let less = edge.series([third >> 8, (fifth >> 10) * 3, (seventh >> 11) * 5]);
        let inverse = shift(inverse, 7).wrapping_sub(shift(less, 3));
        (excess << 4, edge.d.map(|d| shift(times(d, inverse), 6)))
    }

    #[inline(always)]
    fn cosine(a: [i32; 3], b: [i32; 3]) -> i32 {
        let [x, y, z] = [0, 1, 2].map(|k| times(shift(a[k], 9), shift(b[k], 9)));
        shift(x.wrapping_add(y).wrapping_add(z), 6)
    }
}

//! Products of 32-bit numbers in 64 bits.
//!
//! Most processors have an instruction for them. A Cortex-M0 has only the lower 32 bits of a product, and its compiler would call a routine for products of 64
//! by 64 bits. Four products of 16-bit halves take half the time.

use super::FRACTION;
use crate::scalar::Rounding;

/// Whether the processor multiplies to 64 bits. (Rust has no `cfg` for that. Among processors with Thumb instructions it is those with atomics.)
const WIDE: bool = cfg!(not(target_arch = "arm")) || cfg!(target_has_atomic = "32");

/// `a·b`
#[inline(always)]
pub(super) const fn unsigned(a: u32, b: u32) -> u64 {
    if WIDE { a as u64 * b as u64 } else { unsigned_by_halves(a, b) }
}

/// `a·b`
#[inline(always)]
pub(super) const fn signed(a: i32, b: i32) -> i64 {
    if WIDE { a as i64 * b as i64 } else { signed_by_halves(a, b) }
}

/// `a·b`
#[inline(always)]
pub(super) const fn mixed(a: i32, b: u32) -> i64 {
    if WIDE { a as i64 * b as i64 } else { mixed_by_halves(a, b) }
}

/// `a·b` for numbers with 24 fraction bits; it wraps.
#[inline(always)]
pub(super) const fn rounded(a: i32, b: i32, rounding: Rounding) -> i32 {
    let offset = rounding.offset() as i32;
    if WIDE {
        ((a as i64 * b as i64).wrapping_add((offset as i64) << (FRACTION - 8)) >> FRACTION) as i32
    } else {
        rounded_by_halves(a, b, offset)
    }
}

/// Drops 24 fraction bits, rounding to nearest.
#[inline(always)]
pub(super) const fn round(product: i64) -> i64 {
    product.wrapping_add(1 << (FRACTION - 1)) >> FRACTION
}

// No sum below overflows: (2¹⁶ − 1)² + 2·(2¹⁶ − 1) < 2³² unsigned, and 2¹⁵·(2¹⁶ − 1) + 2¹⁶ < 2³¹ signed. The highest parts wrap, as the product may.

#[inline(always)]
const fn unsigned_by_halves(a: u32, b: u32) -> u64 {
    let [low_a, low_b, high_a, high_b] = [a & 0xffff, b & 0xffff, a >> 16, b >> 16];
    let low = low_a.wrapping_mul(low_b);
    let middle = high_a.wrapping_mul(low_b).wrapping_add(low >> 16);
    let lower = low_a.wrapping_mul(high_b).wrapping_add(middle & 0xffff);
    let high = high_a.wrapping_mul(high_b).wrapping_add(middle >> 16).wrapping_add(lower >> 16);
    (high as u64) << 32 | (lower << 16 | low & 0xffff) as u64
}

#[inline(always)]
const fn signed_by_halves(a: i32, b: i32) -> i64 {
    let [low_a, low_b, high_a, high_b] = [a & 0xffff, b & 0xffff, a >> 16, b >> 16];
    let low = low_a.wrapping_mul(low_b) as u32;
    let middle = high_a.wrapping_mul(low_b).wrapping_add((low >> 16) as i32);
    let lower = low_a.wrapping_mul(high_b).wrapping_add(middle & 0xffff);
    let high = high_a.wrapping_mul(high_b).wrapping_add(middle >> 16).wrapping_add(lower >> 16);
    (high as i64) << 32 | ((lower as u32) << 16 | low & 0xffff) as i64
}

#[inline(always)]
const fn mixed_by_halves(a: i32, b: u32) -> i64 {
    // for a < 0: a = (a + 2³²) − 2³²
    let product = unsigned_by_halves(a as u32, b);
    product.wrapping_sub(((b & (a >> 31) as u32) as u64) << 32) as i64
}

/// Omits the lowest bits, which rounding drops: an `offset` in 256ths of a last place has none of them.
#[inline(always)]
const fn rounded_by_halves(a: i32, b: i32, offset: i32) -> i32 {
    let [low_a, low_b, high_a, high_b] = [a & 0xffff, b & 0xffff, a >> 16, b >> 16];
    let low = low_a.wrapping_mul(low_b) as u32 >> 16;
    let middle = high_a.wrapping_mul(low_b).wrapping_add(low as i32);
    let lower = low_a.wrapping_mul(high_b).wrapping_add(middle & 0xffff);
    let high = high_a.wrapping_mul(high_b).wrapping_add(middle >> 16);
    high.wrapping_shl(8).wrapping_add(lower.wrapping_add(offset) >> 8)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of all magnitudes and both signs, and all combinations of the extreme values.
    fn some() -> impl Iterator<Item = (i32, i32)> {
        let mut state = 1_u64;
        let mut next = move |k: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 32) as i32 >> (k % 32)
        };
        let corners = [i32::MIN, i32::MIN + 1, -0x1_0000, -0xffff, -1, 0, 1, 0x8000, 0xffff, 0x1_0000, i32::MAX];
        corners
            .into_iter()
            .flat_map(move |a| corners.map(|b| (a, b)))
            .chain((0..100_000).map(move |k| (next(k), next(k / 32))))
    }

    #[test]
    fn products_by_halves_are_the_products() {
        for (a, b) in some() {
            let [u, v] = [a, b].map(|x| x as u32);
            assert_eq!(unsigned_by_halves(u, v), u64::from(u) * u64::from(v), "{u} · {v}");
            assert_eq!(signed_by_halves(a, b), i64::from(a) * i64::from(b), "{a} · {b}");
            assert_eq!(mixed_by_halves(a, v), i64::from(a) * i64::from(v), "{a} · {v}");
            let exact = i128::from(a) * i128::from(b);
            for (turn, offset) in [(0, 64), (1, 192)] {
                let expected = ((exact + (offset << 16)) >> FRACTION) as i32;
                assert_eq!(rounded(a, b, Rounding::of_turn(turn, 2, 1)), expected, "{a} · {b}");
                assert_eq!(rounded_by_halves(a, b, offset as i32), expected, "{a} · {b}");
            }
            assert_eq!(rounded(a, b, Rounding::NEAREST), round(i64::from(a) * i64::from(b)) as i32, "{a} · {b}");
        }
    }

    #[test]
    fn products_of_all_turns_add_up_to_the_product_however_small_they_are() {
        for a in -40..=40 {
            let b = 1 << 21 | 12_345;
            for shift in 0..6 {
                let turns = 1 << shift;
                let sum: i32 = (0..turns).map(|turn| rounded(a, b, Rounding::of_turn(turn, turns, shift))).sum();
                assert_eq!(sum, rounded(a << shift, b, Rounding::NEAREST), "{a} in {turns} turns");
            }
            for turns in 1..=128_u32 {
                let shift = turns.next_power_of_two().trailing_zeros();
                let sum: i32 = (0..turns).map(|turn| rounded(a, b, Rounding::of_turn(turn, turns, shift))).sum();
                let exact = rounded(a * turns as i32, b, Rounding::NEAREST);
                assert!((sum - exact).abs() <= 2, "{a} in {turns} turns: {sum}, exactly {exact}");
            }
        }
    }
}

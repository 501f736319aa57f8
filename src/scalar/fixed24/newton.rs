//! Reciprocals and inverse roots by Newton's method: no division, no table.

use super::product::{signed, unsigned};

/// `1/√m` for `1 ≤ m < 4` with 30 fraction bits; the result lies in (½, 1] and has 31 fraction bits (1 is 2³¹).
///
/// A straight line, at most 9 % off, and four steps of Newton's method for `y⁻² = m`, each of which turns the relative error ε
/// into 1.5·ε²: 1.2e-2, 2.2e-4, 7e-8, < 2⁻³¹. No division, no table.
#[inline]
fn inverse_root(m: u32) -> u32 {
    const START: u32 = (1.07 * (1_u64 << 31) as f64) as u32;
    const SLOPE: u32 = (0.153 * (1_u64 << 32) as f64) as u32;
    let mut y = START - (unsigned(m, SLOPE) >> 31) as u32;
    for _ in 0..4 {
        let square = (unsigned(y, y) >> 31) as u32;
        // (3 − y²·m)/2 = 1 + defect, which is small
        let defect = (1_u32 << 31).wrapping_sub((unsigned(square, m) >> 30) as u32) as i32;
        y = y.wrapping_add((signed((y >> 1) as i32, defect) >> 31) as u32);
    }
    y.min(1 << 31)
}

/// `(y, e)` with `1/√x = y · 2^e`, where `y` has 31 fraction bits and lies in (½, 1]; `x > 0` with 48 fraction bits.
#[inline]
pub(super) fn inverse_root_wide(x: u64) -> (u32, i32) {
    // x = m · 4^half with 1 ≤ m < 4
    let half = (63 - x.leading_zeros() as i32 - 48).div_euclid(2);
    let shift = 2 * half + 18;
    let m = if shift >= 0 { x >> shift } else { x << -shift };
    (inverse_root(m as u32), -half)
}

/// `1/m` for `1 ≤ m < 2` with 31 fraction bits; the result lies in (½, 1] and has 32.
///
/// A straight line, at most a 17th off, and three steps of `y + y·(1 − m·y)`, each of which squares the relative error: 3.5e-3, 1.2e-5, 1.5e-10.
#[inline]
pub(super) fn reciprocal(m: u32) -> u32 {
    const START: u32 = (24.0 / 17.0 * (1_u64 << 32) as f64 - (1_u64 << 32) as f64) as u32;
    const SLOPE: u32 = (8.0 / 17.0 * (1_u64 << 32) as f64) as u32;
    let mut y = START.wrapping_sub((unsigned(m, SLOPE) >> 31) as u32);
    for _ in 0..3 {
        // near nothing, so that its lower word is all of it
        let defect = ((unsigned(m, y) >> 31) as u32).wrapping_neg() as i32;
        y = y.wrapping_add((signed((y >> 1) as i32, defect) >> 31) as u32);
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reciprocals_are_right_to_one_part_in_a_thousand_million() {
        let mut x = 1_u64 << 31;
        while x < 1 << 32 {
            let expected = (1_u128 << 63) as f64 / x as f64;
            let found = f64::from(reciprocal(x as u32));
            assert!((found / expected - 1.0).abs() < 1e-9, "{x}: {found} {expected}");
            x += 65_521;
        }
        assert_eq!(reciprocal(1 << 31), u32::MAX);
        assert_eq!(reciprocal(u32::MAX) >> 20, 1 << 11);
    }
}

//! Reciprocals and inverse roots by Newton's method: no division, no table.

use super::product::{signed, unsigned};

/// `1/√m` for `1 ≤ m < 4` with 30 fraction bits; the result lies in (½, 1] and has 31 fraction bits (1 is 2³¹).
///
/// The start is a straight line, at most 9 % off. Four steps of Newton's method for `y⁻² = m` follow, each of which turns the relative error ε into
/// −1.5·ε² − 0.5·ε³: 1.2e-2, 2.3e-4, 8e-8, < 2⁻³¹. No division, no table.
///
/// Bounds, in units of 2³¹ unless stated otherwise: the line 1.07 − 0.153·m lies in (0.45, 0.92). Its error is −8.4 % at m = 1 and 4, and +9 % at
/// m = 1.07/0.459. After the first step ε ≤ 0, so y ≤ 1.09/√m, y² ≤ 1.19/m ≤ 1 and y²·m ≤ 1.19 < 2: both fit 32 bits. The bits cut off from them make the defect,
/// of −0.19 to 0.17, up to 5 units of 2⁻³¹ too large. The last step changes y by half of that, and its own cut-off bits by one unit: the result is within 4
/// units.
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
/// The start is a straight line, at most a 17th off. Three steps of `y + y·(1 − m·y)` follow, each of which squares the relative error: 3.5e-3, 1.2e-5,
/// 1.5e-10.
///
/// Bounds: the line lies in (0.47, 0.95). Without cut-off bits every step would leave y at or below 1/m. One unit of 2⁻³² is cut off in the defect and one in
/// the step: the result is within 2 units, at most one of them upwards. For m ≥ 1 + 2⁻³¹ the result is two units below 1; for m = 1 no bits are cut off from
/// m·y: it never is 2³². The defect is at most a 17th, so the lower word keeps its sign.
#[inline]
pub(super) fn reciprocal(m: u32) -> u32 {
    const START: u32 = (24.0 / 17.0 * (1_u64 << 32) as f64 - (1_u64 << 32) as f64) as u32;
    const SLOPE: u32 = (8.0 / 17.0 * (1_u64 << 32) as f64) as u32;
    let mut y = START.wrapping_sub((unsigned(m, SLOPE) >> 31) as u32);
    for _ in 0..3 {
        // the product is near 1, so its lower word contains the whole defect
        let defect = ((unsigned(m, y) >> 31) as u32).wrapping_neg() as i32;
        y = y.wrapping_add((signed((y >> 1) as i32, defect) >> 31) as u32);
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of 32 bits from `low` on: the first million, the last, and one in 65 521 between.
    fn from(low: u32) -> impl Iterator<Item = u32> {
        let ends = (low..low + (1 << 20)).chain(u32::MAX - (1 << 20)..=u32::MAX);
        ends.chain((low..=u32::MAX).step_by(65_521))
    }

    #[test]
    fn reciprocals_are_within_their_bounds() {
        for m in from(1 << 31) {
            let expected = (1_u128 << 63) as f64 / f64::from(m);
            let off = f64::from(reciprocal(m)) - expected;
            assert!((-3.0..=1.0).contains(&off), "{m}: {off} units");
        }
        assert_eq!(reciprocal(1 << 31), u32::MAX);
    }

    #[test]
    fn inverse_roots_are_within_their_bounds() {
        for m in from(1 << 30) {
            let expected = (1_u64 << 46) as f64 / f64::from(m).sqrt();
            let off = f64::from(inverse_root(m)) - expected;
            assert!(off.abs() <= 4.0, "{m}: {off} units");
        }
    }
}

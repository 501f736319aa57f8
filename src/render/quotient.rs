//! Division on processors without a divide instruction.

/// Whether the processor divides, or a divider beside it does. Rust has no `cfg` for it: of the processors with Thumb instructions, those with atomics divide.
const DIVIDES: bool = cfg!(not(target_arch = "arm")) || cfg!(target_has_atomic = "32") || cfg!(feature = "divider");

/// `dividend/divisor`, rounded towards zero; a division by zero gives 0.
///
/// On a Cortex-M0, division bit by bit takes a third of the time of the library's routine, because the quotients of a picture have few bits.
#[inline]
pub(super) fn quotient(dividend: i32, divisor: i32) -> i32 {
    if DIVIDES || divisor == 0 {
        return dividend.checked_div(divisor).unwrap_or(0);
    }
    let positive = bit_by_bit(dividend.unsigned_abs(), divisor.unsigned_abs()) as i32;
    if (dividend < 0) == (divisor < 0) { positive } else { -positive }
}

/// `dividend/divisor`, for a divisor that is not 0.
#[inline(never)]
fn bit_by_bit(dividend: u32, divisor: u32) -> u32 {
    let (mut rest, mut part, mut bit) = (dividend, divisor, 1_u32);
    while part <= rest >> 1 {
        part <<= 1;
        bit <<= 1;
    }
    let mut quotient = 0;
    while bit != 0 {
        if part <= rest {
            rest -= part;
            quotient |= bit;
        }
        part >>= 1;
        bit >>= 1;
    }
    quotient
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bit_by_bit_is_division() {
        let mut state = 1_u32;
        for drop in 0..32 {
            for _ in 0..1000 {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let (a, b) = (state, (state.rotate_left(13) >> drop).max(1));
                assert_eq!(bit_by_bit(a, b), a / b, "{a}/{b}");
                assert_eq!(bit_by_bit(b, a | 1), b / (a | 1), "{b}/{a}");
            }
        }
        assert_eq!([quotient(-7, 2), quotient(7, -2), quotient(-7, -2), quotient(7, 0)], [-3, -3, 3, 0]);
        assert_eq!(bit_by_bit(u32::MAX, 1), u32::MAX);
    }
}

//! The rounding of fixed-point results, with dither.

/// The offset added to a result before the digits below its last place are cut off, in 256ths of a last place.
///
/// An offset of half a place rounds to nearest, but then a correction below half a last place is always lost, however often it is repeated. Offsets that are
/// spread evenly over the last place and differ between substeps let it take effect in a proportional number of substeps (dither: L. Schuchman, *Dither signals
/// and their effect on quantization noise*, 1964). They cost no more than an offset of half a place.
///
/// Results of zero stay zero. Floats ignore it, because they keep small results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rounding(u8);

impl Rounding {
    /// To nearest.
    pub const NEAREST: Self = Self(HALF);

    /// The offset of turn `turn` of `turns`, counted from 0; `turns ≤ 2^shift`.
    ///
    /// In the first half of the turns the offsets follow the sequence of J. G. van der Corput, 1935, in the middle of slots of 2^−shift. In the second half
    /// their complements follow in reverse order. So the mean is one half for any number of turns, and there is no drift. From 128 turns on they repeat.
    #[inline]
    pub const fn of_turn(turn: u32, turns: u32, shift: u32) -> Self {
        let mirrored = turns - 1 - turn;
        if turn < mirrored {
            Self(slot(turn, shift))
        } else if turn > mirrored {
            Self(slot(mirrored, shift).wrapping_neg())
        } else {
            Self::NEAREST
        }
    }

    /// The offset, 256ths of a last place.
    #[inline]
    pub(super) const fn offset(self) -> u8 {
        self.0
    }
}

const HALF: u8 = 1 << 7;

/// The middle of the slot whose number is `turn` with its `shift` bits reversed, at most 7 bits.
const fn slot(turn: u32, shift: u32) -> u8 {
    let middle = if shift < 7 { HALF >> shift } else { 1 };
    // the bits of `turn` above the slot's are cut off
    (turn as u8 & 0x7f).reverse_bits() | middle
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_are_spread_over_the_last_place_and_nearest_in_the_mean() {
        for turns in 1..=300_u32 {
            let shift = turns.next_power_of_two().trailing_zeros();
            let offsets = || (0..turns).map(|turn| u32::from(Rounding::of_turn(turn, turns, shift).0));
            assert_eq!(offsets().sum::<u32>(), 128 * turns, "{turns} turns");
            // no interval of the last place is left out
            let width = 512 / turns.min(128);
            for start in (0..=256 - width.min(256)).step_by(3) {
                assert!(offsets().any(|offset| (start..=start + width).contains(&offset)), "{turns} turns: {start} on");
            }
        }
    }
}

//! Hysteresis for the numbers of sweeps and parts.
//!
//! With more sweeps, or in shorter parts of a substep, a sheet responds more stiffly. If it is stretched with few sweeps and released with more, it gives back more energy than
//! was put in. So sheets whose sweeps or parts changed in every bounce bounced for good. Both numbers rise as soon as they are needed. They fall only after a streak of turns in
//! which less would have been enough, long enough for a whole bounce with the same numbers.

use crate::scalar::Scalar;

/// The easy turns in a row after which a number falls. With 16, sheets still bounce; with 64, no more of them come to rest.
const EASY: u8 = 32;

/// A residual is easy below the tolerance over 2 to this power. Parts twice as long have residuals up to four times as large.
const EASILY: u32 = 3;

/// Whether a residual is so small that fewer sweeps or parts would have been enough.
pub(super) fn is_easy<S: Scalar>(residual: S, tolerance: S) -> bool {
    residual < tolerance.halve(EASILY)
}

/// The number of easy turns in a row. Zero at first, so that a program stores no copy of a solver's first memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(into = "u8", try_from = "u8"))]
pub(super) struct Streak(u8);

impl Streak {
    /// No easy turn yet.
    pub(super) const NONE: Self = Self(0);

    /// Counts a turn. Returns whether the streak is long enough for a number to fall; then the next count starts.
    pub(super) fn is_over(&mut self, easy: bool) -> bool {
        self.0 = if easy { self.0 + 1 } else { 0 };
        let over = self.0 == EASY;
        if over {
            *self = Self::NONE;
        }
        over
    }
}

#[cfg(feature = "serde")]
impl From<Streak> for u8 {
    fn from(Streak(turns): Streak) -> Self {
        turns
    }
}

#[cfg(feature = "serde")]
impl TryFrom<u8> for Streak {
    type Error = &'static str;

    fn try_from(turns: u8) -> Result<Self, Self::Error> {
        if turns < EASY { Ok(Self(turns)) } else { Err("no solver counts that far") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_turn_that_is_not_easy_starts_the_count_again() {
        let mut streak = Streak::NONE;
        let mut over = |easy: bool, turns: u8| (0..turns).filter(|_| streak.is_over(easy)).count();
        assert_eq!(over(true, EASY - 1), 0);
        assert_eq!(over(false, 1), 0);
        assert_eq!(over(true, EASY - 1), 0);
        assert_eq!(over(true, 1), 1);
        assert_eq!(over(true, 3 * EASY), 3);
    }

    #[test]
    fn an_eighth_of_the_tolerance_is_easy() {
        assert!(is_easy(0.0024_f32, 0.02) && !is_easy(0.0026_f32, 0.02));
    }
}

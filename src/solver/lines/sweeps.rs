//! The number of sweeps that is kept from substep to substep.
//!
//! The number rises at once if rows need more sweeps. It falls one by one, each time after a [streak](super::streak) in which one sweep fewer would have been enough. A constant
//! number brings a sheet to rest; one that rises and falls with the strain makes it bounce.

use super::streak::Streak;

/// The least number of sweeps in the next substep; 0 if the least number that the caller asks for is enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Kept {
    sweeps: u8,
    easy: Streak,
}

impl Kept {
    /// None. All zeros, so that a program stores no copy of a solver's first memory.
    pub(super) const NONE: Self = Self { sweeps: 0, easy: Streak::NONE };

    /// The number.
    pub(super) fn number(self) -> u32 {
        u32::from(self.sweeps)
    }

    /// The number after a substep with `sweeps` sweeps, of which the caller asks for `least`; `easy` if one sweep fewer would have been enough.
    pub(super) fn after(self, sweeps: u32, least: u32, easy: bool) -> Self {
        if sweeps <= least {
            return Self::NONE;
        }
        let sweeps = sweeps.min(u32::from(u8::MAX)) as u8;
        let mut streak = if sweeps > self.sweeps { Streak::NONE } else { self.easy };
        let fewer = u8::from(streak.is_over(easy));
        Self { sweeps: sweeps - fewer, easy: streak }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number kept after substeps that need so many sweeps.
    fn kept(needed: &[u32], easy: bool) -> u32 {
        let after = |kept: Kept, &needed: &u32| kept.after(needed.max(kept.number()), 2, easy);
        needed.iter().fold(Kept::NONE, after).number()
    }

    #[test]
    fn the_least_number_needs_no_keeping() {
        assert_eq!(kept(&[2; 99], false), 0);
    }

    #[test]
    fn a_number_rises_at_once_and_stays() {
        assert_eq!(kept(&[2, 3, 2, 2, 2], false), 3);
        assert_eq!(kept(&[2, 3, 2, 6, 2], false), 6);
        assert_eq!(kept(&[6, 2, 2, 2, 2], true), 6);
    }

    #[test]
    fn what_has_been_easy_for_long_falls_one_by_one() {
        assert_eq!(kept(&[&[6][..], &[2; 40]].concat(), true), 5);
        assert_eq!(kept(&[&[6][..], &[2; 70]].concat(), true), 4);
        assert_eq!(kept(&[&[6][..], &[2; 200]].concat(), true), 0);
    }

    #[test]
    fn any_number_of_sweeps_can_be_had() {
        assert_eq!(kept(&[1000], false), 255);
    }
}

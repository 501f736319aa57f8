//! A number of sweeps that flickers is kept.
//!
//! A constant number of sweeps brings a sheet to rest. One that rises and falls from substep to substep makes it jump between the states in which different
//! numbers leave it: jumps that strain rows by more than the tolerance, which calls for more sweeps, which still them, which calls for fewer. So where a number
//! has fallen, risen and fallen again twice, each soon after the other, and the sheet moves little, it falls no more until the last sweep but one has met rows
//! that are within the tolerance by far, or more sweeps are called for. What rises and falls with a swing or a bounce is left alone: what is stretched with few
//! sweeps and let go with more gives back more than was put in.

/// Substeps from a fall to a rise and from a rise to a fall of a number that flickers.
const SOON: u8 = 3;

/// How often a number flickers before it is kept. Once may be the height of a bounce.
const TWICE: u8 = 2;

/// How the number of sweeps changed lately.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flicker {
    /// The sweeps that a substep takes at least; 0 where they change as they need.
    kept: u8,
    last: u8,
    /// For how many substeps the last fall, and the last rise that came soon after a fall, still count.
    fall: u8,
    rise: u8,
    /// How often it has flickered in a row.
    flickers: u8,
}

impl Flicker {
    /// Of a number that was never another: nothing but zeros, so that a solver's memory needs no copy of its start.
    pub(super) const NONE: Self = Self { kept: 0, last: 0, fall: 0, rise: 0, flickers: 0 };

    /// The sweeps that the next substep takes at least.
    pub(super) fn kept(self) -> u32 {
        u32::from(self.kept)
    }

    /// Lets their number change as it needs.
    pub(super) fn release(&mut self) {
        self.kept = 0;
    }

    /// Learns what a substep took of sweeps, at least `least`, and whether that was plenty.
    #[inline(never)] // one for all scenes
    pub(super) fn learn(&mut self, sweeps: u32, least: u32, plenty: bool) {
        let sweeps = sweeps.min(u32::from(u8::MAX)) as u8;
        if self.kept > 0 {
            self.kept = if sweeps > self.kept { 0 } else { self.kept - u8::from(plenty) };
        } else if sweeps < self.last {
            self.flickers = if self.rise > 0 { self.flickers + 1 } else { 0 };
            if self.flickers == TWICE {
                (self.kept, self.flickers) = (self.last, 0);
            }
            self.fall = SOON + 1;
        } else if sweeps > self.last {
            self.rise = if self.fall > 0 { SOON + 1 } else { 0 };
        }
        if self.kept() <= least {
            self.release();
        }
        self.last = sweeps;
        (self.fall, self.rise) = (self.fall.saturating_sub(1), self.rise.saturating_sub(1));
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;

    /// What is kept after each of some substeps.
    fn kept(sweeps: &[u32], plenty: bool) -> Vec<u32> {
        let mut flicker = Flicker::NONE;
        let mut learn = |&sweeps: &u32| {
            flicker.learn(sweeps, 2, plenty);
            flicker.kept()
        };
        sweeps.iter().map(&mut learn).collect()
    }

    #[test]
    fn what_flickers_twice_is_kept() {
        let flickers = [2, 3, 2, 3, 2, 3, 2];
        assert_eq!(kept(&flickers, false), [0, 0, 0, 0, 0, 0, 3]);
        // until it is plenty, one by one, or more are called for
        assert_eq!(kept(&[2, 6, 2, 6, 2, 6, 2, 6, 5, 4, 3], true)[6..], [6, 5, 4, 3, 0]);
        assert_eq!(kept(&[2, 3, 2, 3, 2, 3, 2, 3, 4], false)[6..], [3, 3, 0]);
    }

    #[test]
    fn what_swings_is_left_alone() {
        let bounce: Vec<u32> = [2, 2, 2, 3, 5, 6, 5, 4, 3, 2, 2].repeat(4);
        assert!(kept(&bounce, false).iter().all(|&kept| kept == 0));
    }

    #[test]
    fn any_number_of_sweeps_can_be_had() {
        assert_eq!(kept(&[2, 1000, 2, 1000, 2, 1000, 2], false)[6], 255);
    }
}

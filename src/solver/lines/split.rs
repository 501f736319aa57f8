//! Substeps that are split.

use crate::scalar::Scalar;

/// The substeps in a row that must be solved easily before parts are joined.
const CALM: u8 = 8;

/// How the parts of a substep ended.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outcome<S> {
    /// The largest strain of a row that the last sweep found.
    pub(super) met: S,
    /// Whether the least number of sweeps was enough.
    pub(super) few: bool,
}

impl<S: Scalar> Outcome<S> {
    pub(super) const NONE: Self = Self { met: S::ZERO, few: true };

    pub(super) fn and(self, other: Self) -> Self {
        Self { met: self.met.max(other.met), few: self.few && other.few }
    }
}

/// The halvings by which a grid with a side of so many particles needs more parts than one of 32.
const fn longer(side: usize) -> u32 {
    2 * (side as u32).div_ceil(32).next_power_of_two().ilog2()
}

/// Into how many parts substeps are split.
#[derive(Clone, Copy, Debug)]
pub(super) struct Split {
    halvings: u8,
    calm: u8,
    new: bool,
}

impl Split {
    pub(super) const NONE: Self = Self { halvings: 0, calm: 0, new: false };

    /// Of a sheet of which nothing is known yet.
    pub(super) fn start(side: usize, most_sweeps: u32) -> Self {
        Self { halvings: if most_sweeps > 1 { longer(side) as u8 } else { 0 }, ..Self::NONE }
    }

    pub(super) fn halvings(self) -> u32 {
        u32::from(self.halvings)
    }

    pub(super) fn is_new(self) -> bool {
        self.new
    }

    /// Returns whether the next substep is split otherwise.
    #[inline(never)]
    pub(super) fn learn<S: Scalar>(
        &mut self,
        outcome: &Outcome<S>,
        tolerance: S,
        side: usize,
        most_sweeps: u32,
    ) -> bool {
        let most = (longer(side) + most_sweeps.max(1).ilog2()) as u8;
        let before = self.halvings;
        if outcome.met > tolerance {
            self.halvings = (before + 2).min(most);
            self.calm = 0;
        } else if outcome.few && outcome.met < tolerance.halve(3) {
            self.calm += 1;
            if self.calm >= CALM {
                self.halvings = before.saturating_sub(1);
                self.calm = 0;
            }
        } else {
            self.calm = 0;
        }
        self.new = self.halvings != before;
        self.new
    }
}

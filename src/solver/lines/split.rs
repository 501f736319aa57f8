//! Splitting of substeps into parts.
//!
//! On a grid of N particles a side, a sweep leaves a residual of 1 − c/N² of the one before. So if a step is long for the grid, no affordable number of sweeps converges. The
//! residual acts as a soft spring in place of a stiff one, stretches the sheet and gives it energy. The residual at the start of a step, however, shrinks with the square of the
//! step: two half steps with one sweep each are worth more than one step with any number of sweeps. So if the sweeps of a substep end with a row strained by more than twice the
//! tolerance, the next substep is made in four times as many equal parts, each with a quarter of the sweeps at most. After a [streak](super::streak) of substeps that were solved
//! easily, every two parts are joined again.
//!
//! Parts are substeps in all respects: they stiffen and damp nothing that a shorter step of the caller would not. After a change, the rule in time starts by backward Euler,
//! as after a rough substep.

use crate::scalar::Scalar;

use super::streak::{Streak, is_easy};

/// The result of the sweeps of a substep, or of some of its parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outcome<S> {
    /// The largest residual strain after the sweeps, or zero where shorter steps would not reduce it.
    pub(super) mendable: S,
    /// Whether the least number of sweeps was enough in all parts.
    pub(super) few: bool,
}

impl<S: Scalar> Outcome<S> {
    /// The result of no part yet.
    pub(super) const NONE: Self = Self { mendable: S::ZERO, few: true };

    /// The result of both.
    pub(super) fn and(self, other: Self) -> Self {
        Self { mendable: self.mendable.max(other.mendable), few: self.few && other.few }
    }
}

/// The halvings that a grid with a side of so many particles may have more than one of 32.
const fn longer(side: usize) -> u32 {
    2 * (side as u32).div_ceil(32).next_power_of_two().ilog2()
}

/// The number of parts of a substep.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Split {
    #[cfg_attr(feature = "serde", serde(deserialize_with = "bounded"))]
    halvings: u8,
    /// Substeps whose parts were solved easily.
    easy: Streak,
}

impl Split {
    /// One part. All zeros, so that a program stores no copy of a solver's first memory.
    pub(super) const NONE: Self = Self { halvings: 0, easy: Streak::NONE };

    /// The split at the start of a motion, for a side of so many particles. Large sheets start in parts: in one, they would stretch at once.
    pub(super) const fn start(side: usize, most_sweeps: u32) -> Self {
        Self { halvings: if most_sweeps > 1 { longer(side) as u8 } else { 0 }, ..Self::NONE }
    }

    /// The binary logarithm of the number of parts.
    pub(super) fn halvings(self) -> u32 {
        u32::from(self.halvings)
    }

    /// Adapts the split to the outcome of a substep. Returns whether it has changed.
    #[inline(never)] // one copy for all scenes
    pub(super) fn learn<S: Scalar>(
        &mut self,
        outcome: &Outcome<S>,
        tolerance: S,
        side: usize,
        most_sweeps: u32,
    ) -> bool {
        let before = self.halvings;
        let join = self.easy.is_over(outcome.few && is_easy(outcome.mendable, tolerance));
        if outcome.mendable > tolerance.double(1) {
            let most = longer(side) + most_sweeps.max(1).ilog2();
            self.halvings = (before + 2).min(most as u8);
        } else if join {
            self.halvings = before.saturating_sub(1);
        }
        self.halvings != before
    }
}

/// Refuses a damaged memory with so many parts that a step would never end.
#[cfg(feature = "serde")]
fn bounded<'de, D: serde::Deserializer<'de>>(from: D) -> Result<u8, D::Error> {
    let halvings: u8 = serde::Deserialize::deserialize(from)?;
    if halvings <= 16 { Ok(halvings) } else { Err(serde::de::Error::custom("no substep is split that far")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn substeps_are_split_as_far_as_sweeps_and_grid_allow() {
        for (side, sweeps, most) in [(8, 1, 0), (32, 2, 1), (32, 16, 4), (33, 16, 6), (64, 16, 6), (65, 16, 8)] {
            let mut split = Split::start(side, sweeps);
            for _ in 0..9 {
                split.learn(&Outcome { mendable: 0.1, few: false }, 0.02, side, sweeps);
            }
            assert_eq!(split.halvings(), most, "{sweeps} sweeps, {side} particles");
        }
    }

    #[test]
    fn parts_are_joined_one_by_one_where_all_is_easy() {
        let mut split = Split { halvings: 2, ..Split::NONE };
        let mut run = |residual, few, substeps| {
            (0..substeps).for_each(|_| _ = split.learn(&Outcome { mendable: residual, few }, 0.02, 32, 16));
            split.halvings()
        };
        assert_eq!(run(0.002, true, 31), 2);
        // neither a residual near the tolerance nor a substep with more sweeps is easy
        assert_eq!(run(0.01, true, 80), 2);
        assert_eq!(run(0.002, false, 80), 2);
        assert_eq!(run(0.002, true, 32), 1);
        assert_eq!(run(0.002, true, 80), 0);
    }
}

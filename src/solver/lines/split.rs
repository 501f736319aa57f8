//! Substeps that are split.
//!
//! A sweep leaves 1 − c/N² of what it finds on a grid of N particles a side, so where a step is long for the grid, no affordable number of sweeps converges. What they leave
//! acts as a soft spring in the place of a stiff one, stretches the sheet and gives it energy. What is to be solved in a step, however, shrinks with its square: two half steps with
//! one sweep each are worth more than a step with any number of them. So when the sweeps of a substep end with a row strained by more than twice the tolerance, the next substep
//! is made in four times as many equal parts, with as many sweeps fewer in each. After a [streak](super::streak) of substeps that were solved easily every two parts are joined again.
//!
//! Parts are substeps in all respects: nothing is stiffened or damped that a shorter step of the caller would not. After a change the rule in time starts as after a
//! rough substep, by backward Euler.

use crate::scalar::Scalar;

use super::streak::{Streak, is_easy};

/// What the sweeps of a substep, or of its parts, came to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outcome<S> {
    /// The largest strain of a row that a last sweep found, as far as shorter steps leave less.
    pub(super) mendable: S,
    /// Whether the least number of sweeps was enough everywhere.
    pub(super) few: bool,
}

impl<S: Scalar> Outcome<S> {
    /// Of no part yet.
    pub(super) const NONE: Self = Self { mendable: S::ZERO, few: true };

    /// Of parts one after the other.
    pub(super) fn and(self, other: Self) -> Self {
        Self { mendable: self.mendable.max(other.mendable), few: self.few && other.few }
    }
}

/// The halvings by which a grid with a side of so many particles needs more parts than one of 32.
const fn longer(side: usize) -> u32 {
    2 * (side as u32).div_ceil(32).next_power_of_two().ilog2()
}

/// Into how many parts substeps are split.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Split {
    #[cfg_attr(feature = "serde", serde(deserialize_with = "bounded"))]
    halvings: u8,
    /// Substeps whose parts were solved easily.
    easy: Streak,
}

impl Split {
    /// Not at all: nothing but zeros, so that a solver's memory needs no copy of its start.
    pub(super) const NONE: Self = Self { halvings: 0, easy: Streak::NONE };

    /// For the start of a sheet with a side of so many particles: a large one is not given the time to stretch.
    pub(super) const fn start(side: usize, most_sweeps: u32) -> Self {
        Self { halvings: if most_sweeps > 1 { longer(side) as u8 } else { 0 }, ..Self::NONE }
    }

    /// How often a substep is halved.
    pub(super) fn halvings(self) -> u32 {
        u32::from(self.halvings)
    }

    /// Learns what a substep came to. Returns whether the next one is split otherwise.
    #[inline(never)] // one for all scenes
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

/// Further no substep is split: with more parts than that a damaged memory would never end a step.
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
        // neither what is near the tolerance nor what takes sweeps is easy
        assert_eq!(run(0.01, true, 80), 2);
        assert_eq!(run(0.002, false, 80), 2);
        assert_eq!(run(0.002, true, 32), 1);
        assert_eq!(run(0.002, true, 80), 0);
    }
}

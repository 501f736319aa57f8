//! How many sweeps a sheet that hardly moves takes.
//!
//! A constant number of sweeps brings a sheet to rest. One that rises and falls makes it jump between the states in which different numbers leave it: jumps that strain
//! rows by more than the tolerance, which calls for more sweeps, which still them, which calls for fewer. So while a sheet is calm, their number does not fall until the
//! last sweep but one has found rows within a small part of the tolerance. In motion it is free: what is stretched with few sweeps and let go with more gives back
//! more than was put in.

/// The sweeps that a calm sheet takes at least; 0 where they change as they need. All zeros at first, so that a solver's memory needs no copy of its start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Kept(u8);

impl Kept {
    /// None.
    pub(super) const NONE: Self = Self(0);

    /// Their number.
    pub(super) fn number(self) -> u32 {
        u32::from(self.0)
    }

    /// After a substep with so many sweeps, which may have been plenty.
    pub(super) fn after(self, sweeps: u32, plenty: bool) -> Self {
        let sweeps = sweeps.min(u32::from(u8::MAX)) as u8;
        Self(sweeps.max(self.0).saturating_sub(u8::from(plenty)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is kept after some substeps.
    fn kept(sweeps: &[u32], plenty: bool) -> u32 {
        sweeps.iter().fold(Kept::NONE, |kept, &sweeps| kept.after(sweeps.max(kept.number()), plenty)).number()
    }

    #[test]
    fn a_number_rises_and_does_not_fall() {
        assert_eq!(kept(&[2, 3, 2, 2, 2], false), 3);
        assert_eq!(kept(&[2, 3, 2, 6, 2], false), 6);
    }

    #[test]
    fn a_number_that_is_plenty_falls_one_by_one() {
        assert_eq!(kept(&[6], true), 5);
        assert_eq!(kept(&[6, 2, 2], true), 3);
        assert_eq!(kept(&[6, 2, 2, 2, 2, 2, 2, 2], true), 1);
    }

    #[test]
    fn any_number_of_sweeps_can_be_had() {
        assert_eq!(kept(&[1000], false), 255);
    }
}

//! A substep's position within a frame.

use crate::scalar::{Rounding, Scalar};
use crate::vec3::Vec3;

/// The current substep of a frame, and the relation between displacement and velocity in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Moment {
    /// The substep, counted from 1.
    pub substep: u32,
    /// The substeps of the frame.
    pub substeps: u32,
    /// The logarithm to base 2 of the substeps in a tick.
    pub shift: u32,
    /// Twice the velocity, in units of displacement per substep, that corresponds to a displacement: 2 for one-step methods, 3 for BDF2.
    pub halves: u32,
}

impl Moment {
    /// The time since the frame's start, ticks (at most one).
    #[inline]
    pub fn ticks<S: Scalar>(self) -> S {
        S::ONE.halve(self.shift).times(self.substep as i32)
    }

    /// The rounding of corrections in this substep.
    #[inline]
    pub const fn rounding(self) -> Rounding {
        Rounding::of_turn(self.substep - 1, self.substeps, self.shift)
    }

    /// The velocity that corresponds to a displacement within the substep.
    #[inline]
    pub fn velocity<S: Scalar>(self, displacement: Vec3<S>) -> Vec3<S> {
        match self.halves {
            // the same result by a shift alone
            2 => displacement.double(self.shift),
            halves => displacement.map(|component| component.rate(halves, self.shift)),
        }
    }

    /// The part of a velocity that corresponds to a position, along an axis in fixed point. The parts of two positions differ by the velocity that corresponds
    /// to their difference. It wraps.
    #[inline]
    pub(crate) fn share<S: Scalar>(self, position: S) -> S {
        let whole = position.double(self.shift);
        match self.halves {
            2 => whole,
            _ if self.shift > 0 => whole + position.double(self.shift - 1),
            _ => whole + position.halve(1),
        }
    }

    /// The displacement at a given velocity during the substep.
    #[inline]
    pub fn displacement<S: Scalar>(self, velocity: Vec3<S>) -> Vec3<S> {
        velocity.halve(self.shift)
    }
}

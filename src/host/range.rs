//! Detection of particles that leave the range of a number type.

use std::vec::Vec;

use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// The positions of particles at the last check. Fixed point wraps: a particle that leaves the range at one end is at the other end in the next frame.
#[derive(Debug)]
pub(super) struct Range<S> {
    last: Vec<Vec3<S>>,
    left: bool,
}

impl<S: Scalar> Range<S> {
    /// Takes an iterator: compiled for each number type, not for each grid.
    pub(super) fn new(positions: &mut dyn Iterator<Item = Vec3<S>>) -> Self {
        Self { last: positions.collect(), left: false }
    }

    /// Compares positions with the last check.
    pub(super) fn look(&mut self, positions: &mut dyn Iterator<Item = Vec3<S>>) {
        for (last, now) in self.last.iter_mut().zip(positions) {
            let (from, to) = (last.to_f64(), now.to_f64());
            // a jump by more than half the range is a wrap
            self.left |= (0..3).any(|axis| (to[axis] - from[axis]).abs() > S::LARGEST);
            *last = now;
        }
    }

    /// Whether a particle has left the range.
    pub(super) const fn is_left(&self) -> bool {
        self.left
    }
}

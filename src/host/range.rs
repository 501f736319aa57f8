//! Notices particles that leave the range of a number type.

use std::vec::Vec;

use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// Where particles were at the last look. Fixed point wraps: what leaves its range at one end is at the other in the next frame.
#[derive(Debug)]
pub(super) struct Range<S> {
    last: Vec<Vec3<S>>,
    left: bool,
}

impl<S: Scalar> Range<S> {
    /// Compiled for each number type, not for each grid.
    pub(super) fn new(positions: &mut dyn Iterator<Item = Vec3<S>>) -> Self {
        Self { last: positions.collect(), left: false }
    }

    /// Compares with the last look.
    pub(super) fn look(&mut self, positions: &mut dyn Iterator<Item = Vec3<S>>) {
        for (last, now) in self.last.iter_mut().zip(positions) {
            let (from, to) = (last.to_f64(), now.to_f64());
            // halfway round, or it did not come this way
            self.left |= (0..3).any(|axis| (to[axis] - from[axis]).abs() > S::LARGEST);
            *last = now;
        }
    }

    /// Whether a particle has left.
    pub(super) const fn is_left(&self) -> bool {
        self.left
    }
}

//! When nothing moves, nothing needs to be computed.

use kerchief::{Cloth, Scalar, Units};

/// Watches a sheet and says when it has come to rest: when for some frames no particle was faster than a limit. One frame is not enough, because all that swings
/// stands still where it turns.
///
/// What moves a sheet from outside [wakes](Self::wake) it. (`kerchief::Resting` looks for such changes by itself, and keeps a copy of the sheet for that.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rest<S> {
    /// Cells per tick, along each axis.
    limit: S,
    /// Frames without motion that make rest.
    enough: u32,
    /// Frames without motion so far.
    still: u32,
}

impl<S: Scalar> Rest<S> {
    /// Rest is `frames` frames in which no particle has a velocity of more than `limit` m/s along any axis.
    pub(crate) fn new(units: &Units, limit: f64, frames: u32) -> Self {
        Self { limit: S::from_f64(units.velocity([limit, 0.0, 0.0]).0[0]), enough: frames, still: 0 }
    }

    /// Looks at a sheet after a frame, and says whether it moved.
    pub(crate) fn watch<const W: usize, const H: usize>(&mut self, cloth: &Cloth<S, W, H>) -> bool {
        let moved = cloth.velocity.values().any(|v| v.x.abs().max(v.y.abs()).max(v.z.abs()) > self.limit);
        self.still = if moved { 0 } else { self.still.saturating_add(1) };
        moved
    }

    /// Whether the sheet rests.
    pub(crate) fn has_come(&self) -> bool {
        self.still >= self.enough
    }

    /// Ends the rest.
    pub(crate) fn wake(&mut self) {
        self.still = 0;
    }
}

//! When nothing moves, nothing needs to be computed.

use crate::cloth::Cloth;
use crate::scalar::Scalar;
use crate::units::Units;

/// Watches a sheet and says when it has come to rest: when for some frames no particle was faster than a limit. One frame is not enough, because all that swings
/// stands still where it turns.
///
/// What moves a sheet from outside [wakes](Self::wake) it.
///
/// ```
/// use kerchief::{rest::Rest, *};
///
/// const UNITS: Units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
/// let mut cloth = Cloth::<Q24, 4, 4>::hang(&UNITS, UNITS.point([0.0; 3]));
/// let scene = Scene::new(&UNITS, (), Stretch::new(&UNITS, UNITS.stiffness(100.0)), (), Xpbd);
/// let mut rest = Rest::new(&UNITS, 0.01, 10);
/// let mut frames = 0;
/// while !rest.has_come() {
///     scene.step(&mut cloth, &mut ());
///     rest.watch(&cloth);
///     frames += 1;
/// }
/// assert_eq!(frames, 10);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest<S> {
    /// Cells per tick, along each axis.
    limit: S,
    /// Frames without motion that make rest.
    enough: u32,
    /// Frames without motion so far.
    still: u32,
}

impl<S: Scalar> Rest<S> {
    /// Rest is `frames` frames in which no particle has a velocity of more than `limit` m/s along any axis.
    pub fn new(units: &Units, limit: f64, frames: u32) -> Self {
        Self { limit: S::from_f64(units.velocity([limit, 0.0, 0.0]).0[0]), enough: frames, still: 0 }
    }

    /// Looks at a sheet after a frame, and says whether it moved.
    pub fn watch<const W: usize, const H: usize>(&mut self, cloth: &Cloth<S, W, H>) -> bool {
        let moved = cloth.velocity.values().any(|v| v.x.abs().max(v.y.abs()).max(v.z.abs()) > self.limit);
        self.still = if moved { 0 } else { self.still.saturating_add(1) };
        moved
    }

    /// Whether the sheet rests.
    pub fn has_come(&self) -> bool {
        self.still >= self.enough
    }

    /// Ends the rest.
    pub fn wake(&mut self) {
        self.still = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Gravity, Node, Q24, Scene, Shear, Stretch, Xpbd};

    const UNITS: Units = Units::sheet([5, 5], [0.2, 0.2], 1e-3, 1.0 / 60.0, 8);

    /// A sheet that swings on two corners until it rests, or for a while: the frame and the sheet's largest speed there, m/s.
    fn swing<S: Scalar>(drag: f64) -> Option<u32> {
        let mut cloth = Cloth::<S, 5, 5>::hang(&UNITS, UNITS.point([0.0; 3]));
        cloth.pin(Node::new(0, 0));
        cloth.pin(Node::new(4, 0));
        let forces = (Gravity::new(UNITS.acceleration([0.0, 3.0, -9.0])), crate::Drag::new(UNITS.drag(drag)));
        let links = (Stretch::new(&UNITS, UNITS.stiffness(100.0)), Shear::new(&UNITS, UNITS.stiffness(10.0)));
        let scene = Scene::new(&UNITS, forces, links, (), Xpbd);
        let mut rest = Rest::new(&UNITS, 2e-3, 12);
        (0..3000).find(|_| {
            scene.step(&mut cloth, &mut ());
            rest.watch(&cloth);
            rest.has_come()
        })
    }

    #[test]
    fn a_damped_sheet_comes_to_rest_and_a_swinging_one_does_not() {
        for found in [swing::<f64>(3.0), swing::<f32>(3.0), swing::<Q24>(3.0)] {
            assert!(found.is_some_and(|frame| (60..600).contains(&frame)), "{found:?}");
        }
        assert_eq!(swing::<f64>(0.0), None);
    }

    #[test]
    fn what_is_woken_rests_anew() {
        let cloth = Cloth::<f32, 5, 5>::hang(&UNITS, UNITS.point([0.0; 3]));
        let mut rest = Rest::new(&UNITS, 1e-3, 2);
        assert!(!rest.watch(&cloth) && !rest.has_come());
        assert!(!rest.watch(&cloth) && rest.has_come());
        rest.wake();
        assert!(!rest.has_come());
    }
}

//! A ball.

use crate::collider::{Collider, Contact, Moving, coefficient, gap, reach};
use crate::fingerprint::Fingerprint;
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::units::{Length, Point, Velocity};
use crate::vec3::Vec3;

/// A ball at rest (thesis, listing 5.4); [`with_velocity`](Self::with_velocity) makes it move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S> {
    /// The centre at the start of the frame, cells.
    pub centre: Vec3<S>,
    /// The velocity, cells per tick.
    pub(super) velocity: Vec3<S>,
    /// Coulomb's coefficient of friction.
    pub friction: S,
    /// The sum of radius and margin, cells.
    reach: S,
}

impl<S: Scalar> Sphere<S> {
    /// A ball at rest without friction; particles keep `margin` away from its surface.
    ///
    /// # Panics
    /// If the ball is beyond the range of the number type, or a length negative.
    #[track_caller]
    pub fn new(centre: Point, radius: Length, margin: Length) -> Self {
        centre.check::<S>();
        Self { centre: centre.to_vec(), velocity: Vec3::ZERO, friction: S::ZERO, reach: reach(radius, margin) }
    }

    /// The same ball with friction.
    ///
    /// # Panics
    /// If the coefficient is negative or not finite, or doesn't fit the number type.
    #[must_use]
    #[track_caller]
    pub fn with_friction(self, friction: f64) -> Self {
        Self { friction: coefficient(friction), ..self }
    }

    /// The same ball in motion.
    ///
    /// # Panics
    /// If the velocity doesn't [fit](Velocity::fits) the number type.
    #[must_use]
    #[track_caller]
    pub fn with_velocity(self, velocity: Velocity) -> Moving<Self> {
        Moving::new(self, velocity)
    }
}

impl<S: Scalar> Collider<S> for Sphere<S> {
    #[inline]
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        let travelled = self.velocity * moment.ticks();
        let d = position.difference(self.centre + travelled);
        let squared = d.squared();
        // no root without contact
        if squared >= self.reach.product(self.reach) {
            return None;
        }
        let distance = S::root(squared);
        let up = Vec3::new(S::ZERO, S::ZERO, S::ONE);
        let normal = if distance == S::ZERO { up } else { d.map(|component| component.divide(distance)) };
        let slid = moved - moment.displacement(self.velocity);
        let contact = Contact { velocity: self.velocity, ..Contact::smooth(normal, self.reach - distance) };
        Some(contact.rough(self.friction, slid))
    }

    #[inline]
    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        gap(low, high, self.centre + self.velocity * moment.ticks()).squared() < self.reach.product(self.reach)
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.vector(self.centre);
        print.vector(self.velocity);
        print.numbers([self.reach, self.friction]);
    }

    #[inline]
    fn advance(&mut self, end: Moment) {
        self.centre += self.velocity * end.ticks();
        // the next frame would wrap to the other end of the range
        let Self { centre, velocity, .. } = *self;
        if centre.x.wraps(velocity.x) || centre.y.wraps(velocity.y) || centre.z.wraps(velocity.z) {
            self.velocity = Vec3::ZERO;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q13, Q24};

    #[test]
    fn balls_stop_at_the_end_of_the_range() {
        fn check<S: Scalar>() {
            let frame = Moment { substep: 3, substeps: 3, shift: 2, halves: 2 };
            for axis in 0..3 {
                for velocity in [0.9, 7.3, 100.0, -0.9, -7.3, -100.0] {
                    let mut velocities = [0.0, 0.0, 0.01];
                    velocities[axis] = velocity;
                    let centre = Vec3::from_f64([1.0, -2.0, 3.0]);
                    let mut ball =
                        Sphere { centre, velocity: Vec3::from_f64(velocities), friction: S::ZERO, reach: S::ONE };
                    let mut ticks = 0.0;
                    while ball.velocity != Vec3::ZERO {
                        ball.advance(frame);
                        ticks += 0.75;
                        let travelled = ball.centre.to_f64()[axis] - centre.to_f64()[axis];
                        assert!((travelled - velocity * ticks).abs() < 1e-5, "{velocity} in {}: {travelled}", S::NAME);
                    }
                    let room = S::LARGEST - ball.centre.to_f64()[axis].abs();
                    assert!(room < velocity.abs(), "{velocity} in {}: {room} cells from the end", S::NAME);
                    ball.advance(frame);
                    assert!(S::LARGEST - ball.centre.to_f64()[axis].abs() == room, "it stays there");
                }
            }
        }
        check::<Q24>();
        check::<Q13>();
    }
}

//! A half-space: ground, wall, slope.

use crate::collider::{Collider, Contact, coefficient};
use crate::fingerprint::Fingerprint;
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::units::{Length, Point};
use crate::vec3::Vec3;

/// A plane and the half-space behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<S> {
    /// A point on it, cells.
    pub point: Vec3<S>,
    /// The unit normal, towards the free side.
    pub normal: Vec3<S>,
    /// Coulomb's coefficient of friction.
    pub friction: S,
    margin: S,
}

impl<S: Scalar> Plane<S> {
    /// A plane without friction through `point`, normal to `direction` (of any length but zero, up to 8); particles keep `margin` away from it.
    ///
    /// # Panics
    /// If the direction is zero or not finite, if a position or the margin is beyond the range of the number type, or if the margin is negative.
    #[track_caller]
    pub fn new(point: Point, direction: Vec3<S>, margin: Length) -> Self {
        point.check::<S>();
        margin.check_size::<S>();
        let length = direction.length();
        assert!(length > S::ZERO && length.is_finite(), "a plane's normal is finite and not zero");
        let normal = direction.map(|component| component.divide(length));
        Self { point: point.to_vec(), normal, friction: S::ZERO, margin: S::from_f64(margin.0) }
    }

    /// The distance of a position in front of the plane.
    #[inline]
    fn height(&self, place: Vec3<S>) -> S {
        S::height(place.array(), self.point.array(), self.normal.array())
    }

    /// The same plane with friction.
    ///
    /// # Panics
    /// If the coefficient is negative or not finite, or doesn't fit the number type.
    #[must_use]
    #[track_caller]
    pub fn with_friction(self, friction: f64) -> Self {
        Self { friction: coefficient(friction), ..self }
    }
}

impl<S: Scalar> Collider<S> for Plane<S> {
    #[inline]
    fn contact(&self, _moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        let depth = self.margin.difference(self.height(position));
        (depth > S::ZERO).then(|| Contact::smooth(self.normal, depth).rough(self.friction, moved))
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.vector(self.point);
        print.vector(self.normal);
        print.numbers([self.margin, self.friction]);
    }

    #[inline]
    fn reaches(&self, _moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        // the box's corner deepest in the half-space
        let deepest = |low: S, high: S, normal: S| if normal > S::ZERO { low } else { high };
        let Vec3 { x, y, z } = self.normal;
        let corner = Vec3::new(deepest(low.x, high.x, x), deepest(low.y, high.y, y), deepest(low.z, high.z, z));
        self.height(corner) < self.margin
    }
}

//! A rod with round ends.

use crate::collider::{Collider, Contact, coefficient, reach};
use crate::fingerprint::Fingerprint;
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::units::{Length, Point};
use crate::vec3::Vec3;

/// All points within a radius of a line segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule<S> {
    /// The middle of the segment: with it, the distance to any particle in contact is within the range of fixed point.
    middle: Vec3<S>,
    /// The unit vector along the segment.
    axis: Vec3<S>,
    /// Half the length of the segment.
    half: S,
    /// The sum of radius and margin, cells.
    reach: S,
    /// Coulomb's coefficient of friction.
    pub friction: S,
}

impl<S: Scalar> Capsule<S> {
    /// A capsule without friction around the segment from `a` to `b`; particles keep `margin` away from its surface. If `a` equals `b` it is a sphere.
    ///
    /// # Panics
    /// If the capsule is beyond the range of the number type or longer than that range, or if a length is negative.
    #[track_caller]
    pub fn new(a: Point, b: Point, radius: Length, margin: Length) -> Self {
        a.check::<S>();
        b.check::<S>();
        let (start, end): (Vec3<S>, Vec3<S>) = (a.to_vec(), b.to_vec());
        let segment = end - start;
        // a segment longer than the range wraps
        let whole = |segment: S, end: S, start: S| segment == end.difference(start);
        let whole =
            whole(segment.x, end.x, start.x) && whole(segment.y, end.y, start.y) && whole(segment.z, end.z, start.z);
        let length = segment.length();
        assert!(whole && length.is_finite(), "a capsule is longer than the range of the number type");
        let axis = if length == S::ZERO { Vec3::ZERO } else { segment.map(|component| component.divide(length)) };
        let middle = start.halve(1) + end.halve(1);
        Self { middle, axis, half: length.halve(1), reach: reach(radius, margin), friction: S::ZERO }
    }

    /// The same capsule with friction.
    ///
    /// # Panics
    /// If the coefficient is negative or not finite, or doesn't fit the number type.
    #[must_use]
    #[track_caller]
    pub fn with_friction(self, friction: f64) -> Self {
        Self { friction: coefficient(friction), ..self }
    }
}

impl<S: Scalar> Collider<S> for Capsule<S> {
    #[inline]
    fn contact(&self, _moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        let from_middle = position.difference(self.middle);
        let along = from_middle.dot(self.axis).max(-self.half).min(self.half);
        let d = from_middle - self.axis * along;
        let squared = d.squared();
        // no root without contact
        if squared >= self.reach.product(self.reach) {
            return None;
        }
        let distance = S::root(squared);
        let up = Vec3::new(S::ZERO, S::ZERO, S::ONE);
        let normal = if distance == S::ZERO { up } else { d.map(|component| component.divide(distance)) };
        Some(Contact::smooth(normal, self.reach - distance).rough(self.friction, moved))
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.vector(self.middle);
        print.vector(self.axis);
        print.numbers([self.half, self.reach, self.friction]);
    }

    #[inline]
    fn reaches(&self, _moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        // the segment's bounding box, with a little more than the reach for rounding
        let to_end = self.axis * self.half;
        let [start, end] = [self.middle - to_end, self.middle + to_end];
        let reach = self.reach + self.reach.halve(10);
        let apart = |low: S, high: S, a: S, b: S| a.min(b).difference(high) > reach || low.difference(a.max(b)) > reach;
        !(apart(low.x, high.x, start.x, end.x)
            || apart(low.y, high.y, start.y, end.y)
            || apart(low.z, high.z, start.z, end.z))
    }
}

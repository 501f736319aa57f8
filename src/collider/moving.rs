//! A moving collider.

use core::ops::{Deref, DerefMut};

use crate::collider::{Collider, Contact, Meeting, Sphere};
use crate::fingerprint::Fingerprint;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::Velocity;
use crate::vec3::Vec3;

/// A moving collider: [`Scene::play`](crate::Scene::play) steps a sheet and advances it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moving<C>(pub(super) C);

impl<S: Scalar> Moving<Sphere<S>> {
    #[track_caller]
    pub(super) fn new(sphere: Sphere<S>, velocity: Velocity) -> Self {
        let mut moving = Self(sphere);
        moving.turn(velocity);
        moving
    }

    /// The velocity, cells per tick. In fixed point a ball stops at the end of the range, before a further tick would leave it.
    pub fn velocity(&self) -> Vec3<S> {
        self.0.velocity
    }

    /// The velocity as a mutable reference. With any value a step cannot fail.
    pub const fn velocity_mut(&mut self) -> &mut Vec3<S> {
        &mut self.0.velocity
    }

    /// The same ball with friction.
    ///
    /// # Panics
    /// If the coefficient is negative or not finite.
    #[must_use]
    #[track_caller]
    pub fn with_friction(self, friction: f64) -> Self {
        Self(self.0.with_friction(friction))
    }

    /// Changes the velocity.
    ///
    /// # Panics
    /// If the velocity doesn't [fit](Velocity::fits) the number type.
    #[track_caller]
    pub fn turn(&mut self, velocity: Velocity) {
        self.0.velocity = Vec3::from_f64(velocity.fits::<S>().0);
    }
}

impl<C> Deref for Moving<C> {
    type Target = C;

    fn deref(&self) -> &C {
        &self.0
    }
}

impl<C> DerefMut for Moving<C> {
    fn deref_mut(&mut self) -> &mut C {
        &mut self.0
    }
}

impl<S: Scalar, C: Collider<S>> Collider<S> for Moving<C> {
    #[inline]
    fn is_present(&self) -> bool {
        self.0.is_present()
    }

    #[inline]
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        self.0.contact(moment, position, moved)
    }

    #[inline]
    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        self.0.reaches(moment, low, high)
    }

    #[inline]
    fn meets(&self) -> bool {
        self.0.meets()
    }

    #[inline]
    fn meet<const W: usize, const H: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        meeting: &mut impl Meeting<S, W, H>,
    ) {
        self.0.meet(particles, meeting);
    }

    #[inline]
    fn advance(&mut self, end: Moment) {
        self.0.advance(end);
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        self.0.fingerprint(print);
    }
}

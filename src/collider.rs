//! Obstacles: sphere, plane, capsule.
//!
//! A particle closer than the margin to a surface is moved out along the normal to exactly that distance; friction is Coulomb's coefficient, applied to the
//! displacement along the surface. `()` is no obstacle; a tuple, a slice or a `heapless::Vec` combines its members.

mod capsule;
mod moving;
mod plane;
mod sphere;
#[cfg(test)]
mod wrapped;

use crate::fingerprint::Fingerprint;
use crate::grid::Node;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::scalar::fit::{is_finite, is_not_negative};
use crate::units::{Length, check_fit};
use crate::vec3::Vec3;

pub use capsule::Capsule;
pub use moving::Moving;
pub use plane::Plane;
pub use sphere::Sphere;

/// An obstacle.
pub trait Collider<S: Scalar> {
    /// Whether there is any obstacle: if not, nothing is computed.
    #[inline]
    fn is_present(&self) -> bool {
        true
    }

    /// The contact of a particle at `position`, which `moved` in this substep; `None` if it touches no surface.
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>>;

    /// Whether a particle somewhere between the corners `low` and `high` of a box may have a contact: whole rows are skipped by this test. Never false if
    /// [`contact`](Self::contact) would be `Some`.
    #[inline]
    fn reaches(&self, _moment: Moment, _low: Vec3<S>, _high: Vec3<S>) -> bool {
        true
    }

    /// Whether particles collide with each other: if not, [`meet`](Self::meet) is not called.
    #[inline]
    fn meets(&self) -> bool {
        false
    }

    /// Separates colliding particles, before they are moved out of surfaces: see [`self_contact`](crate::self_contact).
    #[inline]
    fn meet<const W: usize, const H: usize>(
        &self,
        _particles: &mut Particles<S, W, H>,
        _meeting: &mut impl Meeting<S, W, H>,
    ) {
    }

    /// Moves the collider to `end`, the end of a frame.
    #[inline]
    fn advance(&mut self, _end: Moment) {}

    /// Adds all data that the collider depends on, so that a sheet at rest wakes when it changes: see [`rest`](crate::rest). A collider with the default method
    /// keeps sheets awake.
    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.unknown();
    }
}

/// A collider that does not move while a scene is stepped: its [`advance`](Collider::advance) does nothing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` may move, and a step leaves it where it is",
    note = "`scene.play(..)` steps a sheet and moves on what moves; several sheets among the same colliders make a `step_one` each before `scene.advance()`"
)]
pub trait Stationary {}

impl Stationary for () {}
impl<S> Stationary for Sphere<S> {}
impl<S> Stationary for Plane<S> {}
impl<S> Stationary for Capsule<S> {}
impl<T: Stationary> Stationary for Option<T> {}
impl<T: Stationary> Stationary for [T] {}
impl<T: Stationary, const N: usize> Stationary for heapless::Vec<T, N> {}

/// A contact between a particle and a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S> {
    /// The particle's correction: outwards, and back along the surface by friction.
    pub by: Vec3<S>,
    /// The surface's unit normal, towards the free side.
    pub normal: Vec3<S>,
    /// The correction along the normal, cells.
    pub depth: S,
    /// The surface's velocity, cells per tick.
    pub velocity: Vec3<S>,
    /// Coulomb's coefficient of friction.
    pub friction: S,
}

impl<S: Scalar> Contact<S> {
    /// Contact with a smooth surface at rest.
    #[inline]
    pub fn smooth(normal: Vec3<S>, depth: S) -> Self {
        Self { by: normal * depth, normal, depth, velocity: Vec3::ZERO, friction: S::ZERO }
    }

    /// The same contact with friction, for a particle that `moved` in this substep: it moves back along the surface by at most `friction · depth`.
    #[inline]
    #[must_use]
    pub fn rough(self, friction: S, moved: Vec3<S>) -> Self {
        if friction == S::ZERO {
            return self;
        }
        Self {
            by: self.by - friction_limited(moved, self.normal, S::narrow(friction.product(self.depth))),
            friction,
            ..self
        }
    }
}

/// A solver's access to particles during self-contact.
pub trait Meeting<S: Scalar, const W: usize, const H: usize> {
    /// The current substep.
    fn moment(&self) -> Moment;

    /// The displacement of a particle so far in this substep.
    fn moved(&self, particles: &Particles<S, W, H>, node: Node) -> Vec3<S>;

    /// Separates two particles: the first moves by its share of the contact's correction, the second by its share the opposite way. The contact's surface is the
    /// second particle.
    fn separate(&mut self, particles: &mut Particles<S, W, H>, pair: [Node; 2], contact: &Contact<S>);
}

/// Self-contact in a one-step rule: a particle's displacement is in its velocity.
struct OneStep(Moment);

impl<S: Scalar, const W: usize, const H: usize> Meeting<S, W, H> for OneStep {
    fn moment(&self) -> Moment {
        self.0
    }

    #[inline(always)]
    fn moved(&self, particles: &Particles<S, W, H>, node: Node) -> Vec3<S> {
        self.0.displacement(particles.velocity.at(node))
    }

    #[inline(always)]
    fn separate(&mut self, particles: &mut Particles<S, W, H>, [i, j]: [Node; 2], contact: &Contact<S>) {
        let [to_i, to_j] = shared(contact.by, [i, j].map(|node| particles.inverse_mass[node]));
        particles.displace(i, to_i, self.0);
        particles.displace(j, -to_j, self.0);
    }
}

/// The shares of two particles with these inverse masses in a mutual correction. Equal masses get shares equal to the bit, so that momentum is conserved.
#[inline(always)]
pub(crate) fn shared<S: Scalar>(by: Vec3<S>, [first, second]: [S; 2]) -> [Vec3<S>; 2] {
    if first == second {
        return [by.halve(1); 2];
    }
    let share = first.divide(first + second);
    [by * share, by * (S::ONE - share)]
}

/// The sum of radius and margin, cells.
#[track_caller]
#[inline]
fn reach<S: Scalar>(radius: Length, margin: Length) -> S {
    radius.check_size::<S>();
    margin.check_size::<S>();
    let [radius, margin] = [radius, margin].map(|Length(cells)| S::from_f64(cells));
    let reach = radius + margin;
    assert!(reach >= radius && reach.is_finite(), "a length is beyond the range of the number type");
    reach
}

/// A coefficient of friction. It is an `f64` here, so that the scene determines the number type.
#[track_caller]
#[inline]
pub(crate) fn coefficient<S: Scalar>(friction: f64) -> S {
    assert!(is_finite(friction) && is_not_negative(friction), "a coefficient of friction is finite, zero or above");
    check_fit::<S, 1>([friction]);
    S::from_f64(friction)
}

/// The part of a vector that friction removes: its component along the surface, at most `grip`.
#[inline]
pub(crate) fn friction_limited<S: Scalar>(vector: Vec3<S>, normal: Vec3<S>, grip: S) -> Vec3<S> {
    let along = vector - normal * vector.dot(normal);
    let length = along.length();
    if length <= grip { along } else { along * grip.divide(length) }
}

/// Moves every free particle out of `colliders`.
#[inline]
pub(crate) fn resolve<S: Scalar, C: Collider<S>, const W: usize, const H: usize>(
    colliders: &C,
    particles: &mut Particles<S, W, H>,
    moment: Moment,
) {
    if colliders.meets() {
        colliders.meet(particles, &mut OneStep(moment));
    }
    touch(
        colliders,
        particles,
        moment,
        |particles, node| moment.displacement(particles.velocity.at(node)),
        |particles, node, contact| particles.displace(node, contact.by, moment),
    );
}

/// Calls `act` with every free particle in contact with `colliders`, given its displacement `moved` in this substep.
#[inline]
pub(crate) fn touch<S: Scalar, C: Collider<S>, const W: usize, const H: usize>(
    colliders: &C,
    particles: &mut Particles<S, W, H>,
    moment: Moment,
    moved: impl Fn(&Particles<S, W, H>, Node) -> Vec3<S>,
    mut act: impl FnMut(&mut Particles<S, W, H>, Node, Contact<S>),
) {
    if !colliders.is_present() {
        return;
    }
    for row in 0..H {
        let [low, high] = bounds(&particles.position.0[row]);
        if !colliders.reaches(moment, low, high) {
            continue;
        }
        for column in 0..W {
            let node = Node { column, row };
            if particles.is_pinned(node) {
                continue;
            }
            let moved = moved(particles, node);
            if let Some(contact) = colliders.contact(moment, particles.position.at(node), moved) {
                act(particles, node, contact);
            }
        }
    }
}

/// The corners of a row's bounding box.
#[inline]
fn bounds<S: Scalar, const W: usize>(row: &Vec3<[S; W]>) -> [Vec3<S>; 2] {
    let extreme = |row: &[S; W], choose: fn(S, S) -> S| row.iter().fold(row[0], |found, &x| choose(found, x));
    let all =
        |choose: fn(S, S) -> S| Vec3::new(extreme(&row.x, choose), extreme(&row.y, choose), extreme(&row.z, choose));
    [all(S::min), all(S::max)]
}

/// The distance from a box to a point outside it, along each axis without sign; zero if the point is inside.
#[inline]
fn gap<S: Scalar>(low: Vec3<S>, high: Vec3<S>, point: Vec3<S>) -> Vec3<S> {
    let along = |low: S, high: S, x: S| low.difference(x).max(x.difference(high)).max(S::ZERO);
    Vec3::new(along(low.x, high.x, point.x), along(low.y, high.y, point.y), along(low.z, high.z, point.z))
}

impl<S: Scalar> Collider<S> for () {
    #[inline]
    fn is_present(&self) -> bool {
        false
    }

    #[inline]
    fn contact(&self, _moment: Moment, _position: Vec3<S>, _moved: Vec3<S>) -> Option<Contact<S>> {
        None
    }

    #[inline]
    fn reaches(&self, _moment: Moment, _low: Vec3<S>, _high: Vec3<S>) -> bool {
        false
    }

    #[inline]
    fn fingerprint(&self, _print: &mut Fingerprint) {}
}

/// An optional collider, chosen at run time.
impl<S: Scalar, T: Collider<S>> Collider<S> for Option<T> {
    #[inline]
    fn is_present(&self) -> bool {
        self.as_ref().is_some_and(T::is_present)
    }

    #[inline]
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        self.as_ref()?.contact(moment, position, moved)
    }

    #[inline]
    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        self.as_ref().is_some_and(|collider| collider.reaches(moment, low, high))
    }

    #[inline]
    fn meets(&self) -> bool {
        self.as_ref().is_some_and(T::meets)
    }

    #[inline]
    fn meet<const W: usize, const H: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        meeting: &mut impl Meeting<S, W, H>,
    ) {
        if let Some(collider) = self {
            collider.meet(particles, meeting);
        }
    }

    #[inline]
    fn advance(&mut self, end: Moment) {
        if let Some(collider) = self {
            collider.advance(end);
        }
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.word(u32::from(self.is_some()));
        if let Some(collider) = self {
            collider.fingerprint(print);
        }
    }
}

impl<S: Scalar, T: Collider<S>> Collider<S> for [T] {
    #[inline]
    fn is_present(&self) -> bool {
        self.iter().any(T::is_present)
    }

    #[inline]
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        let mut total = None;
        for collider in self {
            total = then(total, collider, moment, position, moved);
        }
        total
    }

    #[inline]
    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        self.iter().any(|collider| collider.reaches(moment, low, high))
    }

    #[inline]
    fn meets(&self) -> bool {
        self.iter().any(T::meets)
    }

    #[inline]
    fn meet<const W: usize, const H: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        meeting: &mut impl Meeting<S, W, H>,
    ) {
        self.iter().for_each(|collider| collider.meet(particles, meeting));
    }

    #[inline]
    fn advance(&mut self, end: Moment) {
        for collider in self {
            collider.advance(end);
        }
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.word(self.len() as u32);
        self.iter().for_each(|collider| collider.fingerprint(print));
    }
}

impl<S: Scalar, T: Collider<S>, const N: usize> Collider<S> for heapless::Vec<T, N> {
    #[inline]
    fn is_present(&self) -> bool {
        self.as_slice().is_present()
    }

    #[inline]
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        self.as_slice().contact(moment, position, moved)
    }

    #[inline]
    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        self.as_slice().reaches(moment, low, high)
    }

    #[inline]
    fn meets(&self) -> bool {
        self.as_slice().meets()
    }

    #[inline]
    fn meet<const W: usize, const H: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        meeting: &mut impl Meeting<S, W, H>,
    ) {
        self.as_slice().meet(particles, meeting);
    }

    #[inline]
    fn advance(&mut self, end: Moment) {
        self.as_mut_slice().advance(end);
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        self.as_slice().fingerprint(print);
    }
}

/// The sum of the corrections of `total` and then `collider`; the surface is the last one's.
#[inline]
fn then<S: Scalar, T: Collider<S>>(
    total: Option<Contact<S>>,
    collider: &T,
    moment: Moment,
    position: Vec3<S>,
    moved: Vec3<S>,
) -> Option<Contact<S>> {
    let by = total.map_or(Vec3::ZERO, |contact| contact.by);
    let last = collider.contact(moment, position + by, moved + by);
    last.map(|contact| Contact { by: by + contact.by, ..contact }).or(total)
}

macro_rules! tuple {
    ($($name:ident),+) => {
        impl<$($name: Stationary),+> Stationary for ($($name,)+) {}

        impl<S: Scalar, $($name: Collider<S>),+> Collider<S> for ($($name,)+) {
            #[inline]
            fn is_present(&self) -> bool {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.is_present())||+
            }

            #[inline]
            fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                let total = None;
                $(let total = then(total, $name, moment, position, moved);)+
                total
            }

            #[inline]
            fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.reaches(moment, low, high))||+
            }

            #[inline]
            fn meets(&self) -> bool {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.meets())||+
            }

            #[inline]
            fn meet<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, meeting: &mut impl Meeting<S, W, H>) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.meet(particles, meeting);)+
            }

            #[inline]
            fn advance(&mut self, end: Moment) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.advance(end);)+
            }

            #[inline]
            fn fingerprint(&self, print: &mut Fingerprint) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.fingerprint(print);)+
            }
        }
    };
}

tuple!(A);
tuple!(A, B);
tuple!(A, B, C);

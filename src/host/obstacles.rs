//! The obstacles of a scene, in one number type.

use std::format;
use std::vec::Vec;

use super::description::{Description, Surface};
use super::error::SceneError;
use super::fit::Fit;
use crate::collider::{Capsule, Collider, Contact, Moving, Plane, Sphere};
use crate::fingerprint::Fingerprint;
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::units::Units;
use crate::vec3::Vec3;

/// The obstacles of a scene, or none.
pub trait Obstacles<S: Scalar>: Collider<S> + Send + 'static {
    /// The centres of the balls, m.
    fn centres(&self, units: &Units) -> Vec<[f64; 3]>;
    /// Moves the balls to these centres, m.
    fn set_centres(&mut self, units: &Units, centres: &[[f64; 3]]);
}

impl<S: Scalar> Obstacles<S> for () {
    fn centres(&self, _: &Units) -> Vec<[f64; 3]> {
        Vec::new()
    }

    fn set_centres(&mut self, _: &Units, _: &[[f64; 3]]) {}
}

/// An obstacle of a sheet.
#[derive(Debug)]
enum Obstacle<S> {
    Sphere(Moving<Sphere<S>>),
    Plane(Plane<S>),
    Capsule(Capsule<S>),
}

impl<S: Scalar> Collider<S> for Obstacle<S> {
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        match self {
            Self::Sphere(sphere) => sphere.contact(moment, position, moved),
            Self::Plane(plane) => plane.contact(moment, position, moved),
            Self::Capsule(capsule) => capsule.contact(moment, position, moved),
        }
    }

    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        match self {
            Self::Sphere(sphere) => sphere.reaches(moment, low, high),
            Self::Plane(plane) => plane.reaches(moment, low, high),
            Self::Capsule(capsule) => capsule.reaches(moment, low, high),
        }
    }

    fn advance(&mut self, end: Moment) {
        if let Self::Sphere(sphere) = self {
            sphere.advance(end);
        }
    }

    fn fingerprint(&self, print: &mut Fingerprint) {
        match self {
            Self::Sphere(sphere) => sphere.fingerprint(print),
            Self::Plane(plane) => plane.fingerprint(print),
            Self::Capsule(capsule) => capsule.fingerprint(print),
        }
    }
}

/// All obstacles of a scene.
#[derive(Debug)]
pub struct Solids<S>(Vec<Obstacle<S>>);

impl<S: Scalar + Send> Obstacles<S> for Solids<S> {
    fn centres(&self, units: &Units) -> Vec<[f64; 3]> {
        let centre = |obstacle: &Obstacle<S>| match obstacle {
            Obstacle::Sphere(sphere) => Some(sphere.centre.to_f64().map(|component| component * units.cell)),
            _ => None,
        };
        self.0.iter().filter_map(centre).collect()
    }

    fn set_centres(&mut self, units: &Units, centres: &[[f64; 3]]) {
        let spheres = self.0.iter_mut().filter_map(|obstacle| match obstacle {
            Obstacle::Sphere(sphere) => Some(sphere),
            _ => None,
        });
        for (sphere, centre) in spheres.zip(centres) {
            sphere.centre = units.place(*centre).to_vec();
        }
    }
}

impl<S: Scalar> Collider<S> for Solids<S> {
    fn is_present(&self) -> bool {
        self.0.as_slice().is_present()
    }

    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        self.0.as_slice().contact(moment, position, moved)
    }

    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        self.0.as_slice().reaches(moment, low, high)
    }

    fn advance(&mut self, end: Moment) {
        self.0.as_mut_slice().advance(end);
    }

    fn fingerprint(&self, print: &mut Fingerprint) {
        self.0.as_slice().fingerprint(print);
    }
}

impl Description {
    pub(super) fn solids<S: Scalar>(&self, units: &Units) -> Result<Solids<S>, SceneError> {
        let mut obstacles = Vec::new();
        let reach = |table: &str, radius: f64, surface: &Surface| {
            // A contact compares squares of lengths that may be twice as long.
            Fit::<S>::number(format!("{table}.radius"), 2.0 * units.length(radius).0)?;
            Fit::<S>::number(format!("{table}.margin"), units.length(surface.margin).0)?;
            Fit::<S>::number(
                format!("{table}.margin"),
                2.0 * (units.length(radius).0 + units.length(surface.margin).0),
            )?;
            Fit::<S>::constant(format!("{table}.friction"), [surface.friction]).map(|_| surface.friction)
        };
        for (index, sphere) in self.spheres.iter().enumerate() {
            let table = format!("sphere[{index}]");
            let friction = reach(&table, sphere.radius, &sphere.surface)?;
            let centre = units.point(sphere.centre);
            Fit::<S>::place(format!("{table}.centre"), centre.0)?;
            let velocity = units.velocity(sphere.velocity);
            Fit::<S>::constant(format!("{table}.velocity"), velocity.0)?;
            let seconds = self.solver.step * f64::from(self.frames);
            let end: [f64; 3] = core::array::from_fn(|axis| sphere.centre[axis] + sphere.velocity[axis] * seconds);
            Fit::<S>::place(format!("{table}.velocity"), units.place(end).0)?;
            let (radius, margin) = (units.length(sphere.radius), units.length(sphere.surface.margin));
            let sphere = Sphere::new(centre, radius, margin).with_friction(friction).with_velocity(velocity);
            obstacles.push(Obstacle::Sphere(sphere));
        }
        for (index, plane) in self.planes.iter().enumerate() {
            let table = format!("plane[{index}]");
            Fit::<S>::place(format!("{table}.point"), units.point(plane.point).0)?;
            let margin = units.length(plane.surface.margin);
            Fit::<S>::number(format!("{table}.margin"), margin.0)?;
            let friction = plane.surface.friction;
            Fit::<S>::constant(format!("{table}.friction"), [friction])?;
            let plane = Plane::new(units.point(plane.point), Vec3::from_f64(plane.normal), margin);
            obstacles.push(Obstacle::Plane(plane.with_friction(friction)));
        }
        for (index, capsule) in self.capsules.iter().enumerate() {
            let table = format!("capsule[{index}]");
            let friction = reach(&table, capsule.radius, &capsule.surface)?;
            let [a, b] = [capsule.a, capsule.b].map(|end| units.point(end));
            Fit::<S>::place(format!("{table}.a"), a.0)?;
            Fit::<S>::place(format!("{table}.b"), b.0)?;
            Fit::<S>::vector(format!("{table}.b"), [0, 1, 2].map(|axis| b.0[axis] - a.0[axis]))?;
            let (radius, margin) = (units.length(capsule.radius), units.length(capsule.surface.margin));
            obstacles.push(Obstacle::Capsule(Capsule::new(a, b, radius, margin).with_friction(friction)));
        }
        Ok(Solids(obstacles))
    }
}

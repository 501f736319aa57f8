//! A rod with round ends.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::Rgb888;

use super::{Ball, Solids};
use crate::render::camera::Camera;
use crate::render::light::Light;
use crate::scalar::Scalar;
use crate::units::{Length, Point as Place};
use crate::vec3::Vec3;

/// A rod with round ends, drawn as a row of balls an eighth of their radius apart (64 balls at most). Memory: seven numbers and a
/// colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod<S> {
    /// One end of its axis, cells.
    pub a: Vec3<S>,
    /// The other end.
    pub b: Vec3<S>,
    /// Its radius, cells.
    pub radius: S,
    /// Its colour.
    pub tone: Rgb888,
}

impl<S: Scalar> Rod<S> {
    /// A rod with these ends of its axis, this radius and colour.
    pub fn new(a: Place, b: Place, radius: Length, tone: Rgb888) -> Self {
        Self { a: a.to_vec(), b: b.to_vec(), radius: S::from_f64(radius.0), tone }
    }

    /// The ball a part of the way (0 to 1) along the axis.
    fn ball(&self, part: S) -> Ball<S> {
        Ball { centre: self.a + (self.b - self.a) * part, radius: self.radius, tone: self.tone }
    }

    /// How many steps lead from one end to the other.
    fn steps(&self) -> i32 {
        (self.b - self.a).length().divide(self.radius).round_times(8).clamp(1, 63)
    }
}

impl<S: Scalar> Solids<S> for Rod<S> {
    fn count(&self) -> usize {
        1
    }

    fn depth(&self, _index: usize, camera: &Camera<S>) -> S {
        camera.place(self.ball(S::HALF).centre).z
    }

    fn hides(&self, _index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool {
        // by the ball whose middle is nearest to the ray through the place
        let (a, b) = (camera.place(self.a), camera.place(self.b));
        let ray = crate::render::light::unit(place);
        let beside = |v: Vec3<S>| v - ray * v.dot(ray);
        let (start, axis) = (beside(a), beside(b - a));
        let square = axis.dot(axis);
        let part = if square == S::ZERO { S::HALF } else { (-start.dot(axis)).divide(square).max(S::ZERO).min(S::ONE) };
        self.ball(part).hides(0, place, camera)
    }

    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool {
        let steps = self.steps();
        let step = S::from_int(steps).recip();
        (0..=steps).any(|k| self.ball(step.times(k)).shades(point, towards))
    }

    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        _index: usize,
        camera: &Camera<S>,
        light: &Light,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let steps = self.steps();
        let step = S::from_int(steps).recip();
        let toward_b = camera.place(self.a).z > camera.place(self.b).z;
        for k in 0..=steps {
            let part = step.times(if toward_b { k } else { steps - k });
            self.ball(part).draw(0, camera, light, target)?;
        }
        Ok(())
    }
}

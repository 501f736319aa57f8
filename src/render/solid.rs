//! The solids that a sheet lies on or hangs before.

mod ball;
mod rod;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::Rgb888;

use super::camera::Camera;
use super::light::Light;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

pub use ball::Ball;
pub use rod::Rod;

/// Solids in a picture: `()` is none, a pair is both, an array and a slice are all of their members.
///
/// A solid has a plane through its outline as the eye sees it: what is outside the solid and beyond that plane may be hidden by it,
/// all else hides it. A sheet is therefore drawn in two parts, before and after the solid, and never cut.
pub trait Solids<S: Scalar> {
    /// How many there are.
    fn count(&self) -> usize;

    /// The depth of one's middle, in distances to the camera's target: the deepest is drawn first.
    fn depth(&self, index: usize, camera: &Camera<S>) -> S;

    /// Whether one may hide a place outside of it (as the eye sees it: [`Camera::place`]).
    fn hides(&self, index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool;

    /// Whether any of them takes the light from a point (cells), where `towards` is the unit vector to the lamp.
    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool;

    /// Draws one.
    ///
    /// # Errors
    /// Whatever the target reports.
    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        index: usize,
        camera: &Camera<S>,
        light: &Light,
        target: &mut D,
    ) -> Result<(), D::Error>;
}

impl<S: Scalar> Solids<S> for () {
    fn count(&self) -> usize {
        0
    }

    fn depth(&self, _index: usize, _camera: &Camera<S>) -> S {
        S::ZERO
    }

    fn hides(&self, _index: usize, _place: Vec3<S>, _camera: &Camera<S>) -> bool {
        false
    }

    fn shades(&self, _point: Vec3<S>, _towards: Vec3<S>) -> bool {
        false
    }

    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        _: usize,
        _: &Camera<S>,
        _: &Light,
        _: &mut D,
    ) -> Result<(), D::Error> {
        Ok(())
    }
}

impl<S: Scalar, A: Solids<S>, B: Solids<S>> Solids<S> for (A, B) {
    fn count(&self) -> usize {
        self.0.count() + self.1.count()
    }

    fn depth(&self, index: usize, camera: &Camera<S>) -> S {
        match index.checked_sub(self.0.count()) {
            None => self.0.depth(index, camera),
            Some(index) => self.1.depth(index, camera),
        }
    }

    fn hides(&self, index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool {
        match index.checked_sub(self.0.count()) {
            None => self.0.hides(index, place, camera),
            Some(index) => self.1.hides(index, place, camera),
        }
    }

    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool {
        self.0.shades(point, towards) || self.1.shades(point, towards)
    }

    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        index: usize,
        camera: &Camera<S>,
        light: &Light,
        target: &mut D,
    ) -> Result<(), D::Error> {
        match index.checked_sub(self.0.count()) {
            None => self.0.draw(index, camera, light, target),
            Some(index) => self.1.draw(index, camera, light, target),
        }
    }
}

/// All of its members, each of them one solid.
impl<S: Scalar, T: Solids<S>> Solids<S> for [T] {
    fn count(&self) -> usize {
        self.len()
    }

    fn depth(&self, index: usize, camera: &Camera<S>) -> S {
        self[index].depth(0, camera)
    }

    fn hides(&self, index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool {
        self[index].hides(0, place, camera)
    }

    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool {
        self.iter().any(|solid| solid.shades(point, towards))
    }

    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        index: usize,
        camera: &Camera<S>,
        light: &Light,
        target: &mut D,
    ) -> Result<(), D::Error> {
        self[index].draw(0, camera, light, target)
    }
}

macro_rules! through {
    ($({$($generics:tt)*} $wrapper:ty => $inner:ty),*) => {
        $(impl<$($generics)*> Solids<S> for $wrapper {
            fn count(&self) -> usize {
                <$inner>::count(self)
            }

            fn depth(&self, index: usize, camera: &Camera<S>) -> S {
                <$inner>::depth(self, index, camera)
            }

            fn hides(&self, index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool {
                <$inner>::hides(self, index, place, camera)
            }

            fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool {
                <$inner>::shades(self, point, towards)
            }

            fn draw<D: DrawTarget<Color = Rgb888>>(
                &self,
                index: usize,
                camera: &Camera<S>,
                light: &Light,
                target: &mut D,
            ) -> Result<(), D::Error> {
                <$inner>::draw(self, index, camera, light, target)
            }
        })*
    };
}

through!({S: Scalar, T: Solids<S>, const N: usize} [T; N] => [T], {S: Scalar, T: Solids<S> + ?Sized} &T => T);

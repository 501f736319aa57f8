//! The solids that a sheet lies on or hangs in front of.

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

/// Solids in a picture: `()` has none, a pair has both, an array or a slice has all of its members.
///
/// The outline of a solid, as the eye sees it, defines a plane. The solid may hide a face that is outside of it and beyond that plane; any
/// other face may hide the solid. The cells of a sheet are therefore drawn in two groups, before and after the solid, and never cut.
pub trait Solids<S: Scalar> {
    /// The number of solids.
    fn count(&self) -> usize;

    /// The depth of the middle of a solid, in distances to the camera's target. The deepest solid is drawn first.
    fn depth(&self, index: usize, camera: &Camera<S>) -> S;

    /// Whether a solid may hide a place, in eye coordinates: see [`Camera::place`].
    fn hides(&self, index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool;

    /// Whether any solid blocks the light at a point (cells). `towards` is the unit vector to the lamp.
    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool;

    /// Draws a solid.
    ///
    /// # Errors
    /// Errors of the target.
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

/// All members of the slice, each of them one solid.
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

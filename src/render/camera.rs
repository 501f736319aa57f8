//! The camera: the projection of points of the scene to pixels.

use embedded_graphics::geometry::{Point, Size};

use super::view::View;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// A perspective camera that orbits a target.
///
/// It computes in the sheet's own number type, so every board draws the same picture. Depths are in units of the distance to the target
/// and therefore near one, so the eye may be far away even in fixed point. The target must lie within the type's range of every
/// particle (128 cells for [`Q24`](crate::Q24)).
///
/// Memory: 18 numbers and 12 bytes: 84 bytes for 32-bit numbers.
///
/// ```
/// use embedded_graphics::geometry::{Point, Size};
/// use kerchief::{Q24, Vec3, render::{Camera, View}};
///
/// const VIEW: View = View::new(0.0, 0.0);
/// let camera = Camera::<Q24>::new(&VIEW, Size::new(240, 240));
/// assert_eq!(camera.project(Vec3::ZERO), Some(Point::new(120, 120)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<S> {
    target: Vec3<S>,
    /// The reciprocal of the distance to the target, 1/cells.
    nearness: S,
    azimuth: Turn<S>,
    elevation: Turn<S>,
    pub(super) axes: Axes<S>,
    /// Pixels · 256 per unit of slope.
    focal: i32,
    /// The slope of 16 half pixels.
    pixel: S,
    screen: (i32, i32),
}

/// The axes of the eye, unit vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axes<S> {
    pub(super) right: Vec3<S>,
    pub(super) up: Vec3<S>,
    pub(super) forward: Vec3<S>,
}

/// A direction in a plane, as sine and cosine of its angle.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turn<S> {
    sin: S,
    cos: S,
}

/// A place on the screen, pixels · 256: the middle of the first pixel is (128, 128).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Spot {
    pub(super) x: i32,
    pub(super) y: i32,
}

/// The near plane: points nearer to the eye than 2⁻⁴ of its distance to the target are not drawn.
const NEAR: u32 = 4;

/// Places further than this from the screen's first pixel are not drawn, so that an area fits 64 bits and a slope 32.
pub(super) const FARTHEST: i32 = 4096 * 256;

impl<S: Scalar> Camera<S> {
    /// A camera with this view that draws on a screen of this size (up to 4096 pixels a side).
    pub fn new(view: &View, screen: Size) -> Self {
        let screen = (screen.width.max(1) as i32, screen.height.max(1) as i32);
        let shorter = screen.0.min(screen.1);
        let field = S::from_f64(view.field);
        let blocks = S::from_int(shorter >> 6) + S::from_int(shorter & 63).halve(6);
        let turn = |(sin, cos)| Turn { sin: S::from_f64(sin), cos: S::from_f64(cos) };
        let (azimuth, elevation) = (turn(view.azimuth), turn(view.elevation));
        Self {
            target: Vec3::from_f64(view.target),
            nearness: S::from_f64(view.distance).recip(),
            azimuth,
            elevation,
            axes: Axes::new(azimuth, elevation),
            focal: field.recip().round_times(128 * shorter),
            pixel: field.divide(blocks).halve(2),
            screen,
        }
    }

    /// Turns around the target by `azimuth` to the right and `elevation` upwards, in radians and at most 1 each. The series used
    /// has an error of 10⁻⁷ at 0.1 and 0.008 at 1. The elevation stops at straight up and straight down.
    pub fn orbit(&mut self, azimuth: S, elevation: S) {
        self.azimuth = self.azimuth.turned(azimuth);
        let raised = self.elevation.turned(elevation);
        self.elevation = if raised.cos < S::ZERO {
            Turn { sin: if raised.sin < S::ZERO { -S::ONE } else { S::ONE }, cos: S::ZERO }
        } else {
            raised
        };
        self.axes = Axes::new(self.azimuth, self.elevation);
    }

    /// Divides the distance to the target by `factor` (`factor > 0`). The distance stays at least one cell.
    pub fn zoom(&mut self, factor: S) {
        self.nearness = (self.nearness * factor).min(S::ONE);
    }

    /// Looks at another target from the same direction and distance.
    pub fn aim(&mut self, target: Vec3<S>) {
        self.target = target;
    }

    /// The pixel at which a point (cells) appears, on or beside the screen; `None` if it is behind the camera, too near, or too far aside.
    pub fn project(&self, point: Vec3<S>) -> Option<Point> {
        self.spot(self.place(point)).map(|spot| Point::new(spot.x >> 8, spot.y >> 8))
    }

    /// The ray through a pixel: the inverse of [`project`](Self::project). It begins at the near plane.
    pub fn ray(&self, pixel: Point) -> Ray<S> {
        let Axes { right, up, forward } = self.axes;
        let (x, y) = (self.slope_right(pixel.x), self.slope_up(pixel.y));
        // a point at the depth of the target: the eye may be out of range
        let through = self.target + right * x.divide(self.nearness) + up * y.divide(self.nearness);
        let direction = forward + right * x + up * y;
        let start = (Self::near() - S::ONE) * direction.length();
        Ray::line(through, direction, start.divide(self.nearness))
    }

    /// The place (cells) under a pixel at the depth of `point`: the target of a particle dragged by a pointer.
    pub fn under(&self, pixel: Point, point: Vec3<S>) -> Vec3<S> {
        let Axes { right, up, forward } = self.axes;
        let depth = self.place(point).z;
        let (x, y) = (self.slope_right(pixel.x) * depth, self.slope_up(pixel.y) * depth);
        let offset = right * x + up * y + forward * (depth - S::ONE);
        self.target + offset.map(|component| component.divide(self.nearness))
    }

    /// A point in eye coordinates: right, up and depth, in distances to the target (which is at 0, 0, 1).
    pub fn place(&self, point: Vec3<S>) -> Vec3<S> {
        let Axes { right, up, forward } = self.axes;
        let offset = point - self.target;
        Vec3::new(offset.dot(right), offset.dot(up), offset.dot(forward)) * self.nearness
            + Vec3::new(S::ZERO, S::ZERO, S::ONE)
    }

    /// A length (cells) in distances to the target.
    pub fn scale(&self, length: S) -> S {
        length * self.nearness
    }

    /// The depth of the near plane.
    pub(super) fn near() -> S {
        S::ONE.halve(NEAR)
    }

    /// The screen position of a place; `None` if it is not drawn.
    pub(super) fn spot(&self, place: Vec3<S>) -> Option<Spot> {
        if place.z < Self::near() {
            return None;
        }
        let nearness = place.z.recip();
        let spot = Spot { x: self.column(place.x * nearness), y: self.row(place.y * nearness) };
        (spot.x.abs() < FARTHEST && spot.y.abs() < FARTHEST).then_some(spot)
    }

    /// The intersection of the near plane with a segment, of which `hidden` lies before it.
    pub(super) fn clip(hidden: Vec3<S>, seen: Vec3<S>) -> Vec3<S> {
        let part = (Self::near() - hidden.z).divide(seen.z - hidden.z);
        let mut cut = hidden + (seen - hidden) * part;
        cut.z = Self::near();
        cut
    }

    /// Whether a line between two pixels is not wholly beyond one edge of the screen.
    pub(super) fn may_show(&self, a: Point, b: Point) -> bool {
        a.x.max(b.x) >= 0 && a.y.max(b.y) >= 0 && a.x.min(b.x) < self.screen.0 && a.y.min(b.y) < self.screen.1
    }

    /// The column (pixels · 256) of a slope to the right.
    pub(super) fn column(&self, slope: S) -> i32 {
        slope.round_times(self.focal) + self.screen.0 * 128
    }

    /// The row (pixels · 256) of a slope upwards.
    pub(super) fn row(&self, slope: S) -> i32 {
        self.screen.1 * 128 - slope.round_times(self.focal)
    }

    /// The slope to the right at the middle of a column of pixels.
    pub(super) fn slope_right(&self, column: i32) -> S {
        self.pixel.times(2 * column + 1 - self.screen.0).halve(4)
    }

    /// The slope upwards at the middle of a row of pixels.
    pub(super) fn slope_up(&self, row: i32) -> S {
        self.pixel.times(self.screen.1 - 2 * row - 1).halve(4)
    }

    /// The middle of a row of pixels as a fraction of the screen's height, of 256.
    pub(super) fn fraction_down(&self, row: i32) -> i32 {
        (256 * row + 128) / self.screen.1
    }

    /// The point at which the camera looks, cells.
    pub fn target(&self) -> Vec3<S> {
        self.target
    }

    /// A direction in eye coordinates: right, up, forward.
    pub(super) fn seen(&self, direction: Vec3<S>) -> Vec3<S> {
        let Axes { right, up, forward } = self.axes;
        Vec3::new(direction.dot(right), direction.dot(up), direction.dot(forward))
    }
}

impl<S: Scalar> Axes<S> {
    fn new(azimuth: Turn<S>, elevation: Turn<S>) -> Self {
        let (Turn { sin: sa, cos: ca }, Turn { sin: se, cos: ce }) = (azimuth, elevation);
        Self {
            right: Vec3::new(ca, sa, S::ZERO),
            up: Vec3::new(-(sa * se), ca * se, ce),
            forward: Vec3::new(-(sa * ce), ca * ce, -se),
        }
    }
}

impl<S: Scalar> Turn<S> {
    /// Turned by an angle in radians, and normalised: it stays a unit vector after any number of turns.
    fn turned(self, angle: S) -> Self {
        // the series up to the fourth power
        let square = angle * angle;
        let sin = angle - angle * square * S::from_f64(1.0 / 6.0);
        let cos = S::ONE - square.halve(1) + square * square * S::from_f64(1.0 / 24.0);
        let turned = Vec3::new(self.sin * cos + self.cos * sin, self.cos * cos - self.sin * sin, S::ZERO);
        let inverse = turned.length().recip();
        Self { sin: turned.x * inverse, cos: turned.y * inverse }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Q24;
    use crate::units::{Length, Point as Place};

    const SCREEN: Size = Size::new(320, 240);
    const VIEW: View = View::new(30.0, 20.0).at(Place([4.0, -3.0, 2.0]), Length(60.0));

    /// The same projection in closed form, with the sines and cosines of `libm` and the eye as a point.
    fn closed_form(point: [f64; 3], azimuth: f64, elevation: f64) -> (f64, f64) {
        let (a, e) = (azimuth.to_radians(), elevation.to_radians());
        let (sa, ca, se, ce) = (libm::sin(a), libm::cos(a), libm::sin(e), libm::cos(e));
        let eye = [4.0 + 60.0 * ce * sa, -3.0 - 60.0 * ce * ca, 2.0 + 60.0 * se];
        let d = [0, 1, 2].map(|k| point[k] - eye[k]);
        let x = d[0] * ca + d[1] * sa;
        let y = -d[0] * sa * se + d[1] * ca * se + d[2] * ce;
        let z = -d[0] * sa * ce + d[1] * ca * ce - d[2] * se;
        let focal = 120.0 / libm::tan(15_f64.to_radians());
        (160.0 + focal * x / z, 120.0 - focal * y / z)
    }

    fn spots<S: Scalar>(bound: f64) {
        let camera = Camera::<S>::new(&VIEW, SCREEN);
        for point in [[0.0, 0.0, 0.0], [14.0, 3.5, -6.0], [-9.0, 20.0, 11.0], [8.0, -17.0, 5.5]] {
            let spot = camera.spot(camera.place(Vec3::from_f64(point))).unwrap();
            let (x, y) = closed_form(point, 30.0, 20.0);
            let error = (f64::from(spot.x) / 256.0 - x).abs().max((f64::from(spot.y) / 256.0 - y).abs());
            assert!(error < bound, "{} {point:?}: {error}", S::NAME);
        }
    }

    #[test]
    fn projections_agree_with_the_closed_form() {
        spots::<f64>(0.004);
        spots::<f32>(0.004);
        spots::<Q24>(0.004);
    }

    #[test]
    fn an_orbit_in_small_turns_ends_where_one_view_begins() {
        fn end<S: Scalar>() -> Vec3<S> {
            let mut camera = Camera::<S>::new(&VIEW, SCREEN);
            for _ in 0..100 {
                camera.orbit(S::from_f64(0.5_f64.to_radians()), S::from_f64(-0.1_f64.to_radians()));
            }
            camera.axes.forward - Camera::<S>::new(&View::new(80.0, 10.0), SCREEN).axes.forward
        }
        assert!(end::<f64>().length() < 1e-8);
        assert!(end::<f32>().length() < 1e-5);
        assert!(end::<Q24>().to_f64().iter().all(|part| part.abs() < 1e-5));
    }

    #[test]
    fn a_large_turn_is_as_exact_as_documented() {
        let turn = Turn { sin: 0.0, cos: 1.0 };
        assert!((libm::asin(turn.turned(1.0_f64).sin) - 1.0).abs() < 8e-3);
        assert!((libm::asin(turn.turned(0.1_f64).sin) - 0.1).abs() < 1e-7);
    }

    #[test]
    fn elevation_stops_at_the_poles() {
        let mut camera = Camera::<Q24>::new(&VIEW, SCREEN);
        for _ in 0..20 {
            camera.orbit(Q24::ZERO, Q24::HALF);
        }
        assert_eq!(camera.axes.forward, Vec3::new(Q24::ZERO, Q24::ZERO, -Q24::ONE));
    }

    #[test]
    fn nothing_behind_the_camera_appears() {
        let camera = Camera::<f32>::new(&VIEW, SCREEN);
        let back = camera.target() - camera.axes.forward * 70.0;
        assert_eq!(camera.project(back), None);
        assert_eq!(camera.project(camera.target() - camera.axes.forward * 57.0), None);
        assert_eq!(camera.project(camera.target() - camera.axes.forward * 50.0), Some(Point::new(160, 120)));
    }

    #[test]
    fn pixels_and_slopes_are_each_others_inverse() {
        fn check<S: Scalar>() {
            let camera = Camera::<S>::new(&VIEW, SCREEN);
            for pixel in [0, 1, 100, 160, 319] {
                assert!(
                    (camera.column(camera.slope_right(pixel)) - pixel * 256 - 128).abs() <= 1,
                    "{} {pixel}",
                    S::NAME
                );
                assert!((camera.row(camera.slope_up(pixel)) - pixel * 256 - 128).abs() <= 1, "{} {pixel}", S::NAME);
            }
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }

    fn a_ray_goes_through_all_that_its_pixel_shows<S: Scalar>(view: &View, bound: f64) {
        let camera = Camera::<S>::new(view, SCREEN);
        for pixel in [(0, 0), (319, 0), (160, 120), (37, 201), (-40, 300)] {
            let pixel = Point::new(pixel.0, pixel.1);
            let ray = camera.ray(pixel);
            for point in [[0.0, 0.0, 0.0], [14.0, 3.5, -6.0], [-9.0, 20.0, 11.0], [8.0, -17.0, 5.5]] {
                let seen = camera.spot(camera.place(ray.foot(Vec3::from_f64(point)))).unwrap();
                let [x, y] =
                    [seen.x - 256 * pixel.x - 128, seen.y - 256 * pixel.y - 128].map(|part| f64::from(part) / 256.0);
                assert!(x.abs().max(y.abs()) < bound, "{pixel:?} {point:?} in {}: {x}, {y}", S::NAME);
            }
        }
    }

    #[test]
    fn rays_are_the_inverse_of_projection() {
        let far = View::new(-70.0, 5.0).field_of_view(4.0).at(Place([1.0, 2.0, 3.0]), Length(400.0));
        for view in [VIEW, far] {
            a_ray_goes_through_all_that_its_pixel_shows::<f64>(&view, 0.01);
            a_ray_goes_through_all_that_its_pixel_shows::<f32>(&view, 0.02);
            a_ray_goes_through_all_that_its_pixel_shows::<Q24>(&view, 0.05);
        }
    }

    #[test]
    fn what_is_under_a_pixel_stays_in_its_plane() {
        fn check<S: Scalar>(bound: f64) {
            let camera = Camera::<S>::new(&VIEW, SCREEN);
            for pixel in [(0, 0), (319, 0), (160, 120), (37, 201), (-40, 300)] {
                let pixel = Point::new(pixel.0, pixel.1);
                for point in [[0.0, 0.0, 0.0], [14.0, 3.5, -6.0], [-9.0, 20.0, 11.0]].map(Vec3::<S>::from_f64) {
                    let under = camera.under(pixel, point);
                    assert_eq!(camera.project(under), Some(pixel), "{point:?} in {}", S::NAME);
                    let deeper = (under - point).dot(camera.axes.forward).to_f64();
                    assert!(deeper.abs() < bound, "{pixel:?} {point:?} in {}: {deeper}", S::NAME);
                }
            }
        }
        check::<f64>(1e-12);
        check::<f32>(1e-4);
        check::<Q24>(1e-4);
    }

    #[test]
    fn memory_is_as_documented() {
        assert_eq!(size_of::<Camera<Q24>>(), 84);
    }

    #[test]
    fn zooming_halves_the_distance() {
        let mut camera = Camera::<f64>::new(&VIEW, SCREEN);
        let point = camera.target() + camera.axes.forward * 6.0;
        camera.zoom(2.0);
        assert!((camera.place(point).z - 36.0 / 30.0).abs() < 1e-12);
    }
}

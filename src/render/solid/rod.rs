//! A rod with round ends.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::ball::{PAINT, Sphere};
use super::{Ball, Solids};
use crate::render::camera::Camera;
use crate::render::canvas::union;
use crate::render::light::{Light, Normal, unit};
use crate::scalar::Scalar;
use crate::units::{Length, Point as Place};
use crate::vec3::Vec3;

/// A rod with round ends: a pole, or a capsule. Memory: seven numbers and a colour.
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
    ///
    /// # Panics
    /// For a radius that is negative or beyond the range of the number type.
    #[track_caller]
    pub fn new(a: Place, b: Place, radius: Length, tone: Rgb888) -> Self {
        radius.check_size::<S>();
        Self { a: a.to_vec(), b: b.to_vec(), radius: S::from_f64(radius.0), tone }
    }

    /// The ball at a point of the axis.
    fn ball(&self, centre: Vec3<S>) -> Ball<S> {
        Ball { centre, radius: self.radius, tone: self.tone }
    }

    /// The point of the axis nearest to the line through `point` in this direction (a unit vector).
    fn nearest(&self, point: Vec3<S>, direction: Vec3<S>) -> Vec3<S> {
        // in units of 32 cells, so that the squares of all lengths fit the type
        let beside = |v: Vec3<S>| v - direction * v.dot(direction);
        let (start, axis) = (beside((self.a - point).halve(5)), beside((self.b - self.a).halve(5)));
        let square = axis.dot(axis);
        let part = if square == S::ZERO { S::HALF } else { (-start.dot(axis)).divide(square).max(S::ZERO).min(S::ONE) };
        self.a + (self.b - self.a) * part
    }
}

impl<S: Scalar> Solids<S> for Rod<S> {
    fn count(&self) -> usize {
        1
    }

    fn depth(&self, _index: usize, camera: &Camera<S>) -> S {
        camera.place((self.a + self.b).halve(1)).z
    }

    fn hides(&self, _index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool {
        // by the ball nearest to the ray through the place
        let seen = Rod { a: camera.place(self.a), b: camera.place(self.b), ..*self };
        Sphere::new(seen.nearest(Vec3::ZERO, unit(place)), camera.scale(self.radius)).hides(place)
    }

    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool {
        self.ball(self.nearest(point, towards)).shades(point, towards)
    }

    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        _index: usize,
        camera: &Camera<S>,
        light: &Light,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let ends = [self.a, self.b].map(|end| Sphere::new(camera.place(end), camera.scale(self.radius)));
        let [Some(near_a), Some(near_b)] = ends.map(|end| end.outline(camera)) else { return Ok(()) };
        let lamp = light.lamp_seen(camera);
        let side = Side::new(ends[0].centre, ends[1].centre, camera.scale(self.radius));
        let meet = |column: i32, y: S| {
            let ray = Vec3::new(camera.slope_right(column), y, S::ONE);
            let cap = |end: &Sphere<S>| {
                Some(end.inside(ray)).filter(|&inside| inside >= S::ZERO).map(|inside| end.meet(ray, inside))
            };
            let hits = [side.meet(ray), cap(&ends[0]), cap(&ends[1])].into_iter().flatten();
            hits.reduce(|first, hit| if hit.0 < first.0 { hit } else { first })
        };
        let area = union(&near_a, &near_b).intersection(&target.bounding_box());
        for row in area.rows() {
            // A rod is convex: its pixels in a row are contiguous.
            let y = camera.slope_up(row);
            let shows = |&column: &i32| meet(column, y).is_some();
            let (Some(first), Some(last)) = (area.columns().find(shows), area.columns().rfind(shows)) else { continue };
            let stretch = Rectangle::with_corners(Point::new(first, row), Point::new(last, row));
            // a pixel in between that misses the rod by rounding takes its neighbour's tone
            let mut tone = self.tone;
            let tones = (first..=last).map(|column| {
                if let Some((_, normal)) = meet(column, y) {
                    tone = lamp.tone(self.tone, &PAINT, Normal::of(normal));
                }
                tone
            });
            target.fill_contiguous(&stretch, tones)?;
        }
        Ok(())
    }
}

/// The cylindrical side of a rod in eye coordinates.
///
/// A ray intersects it where its component perpendicular to the axis is `radius` away from the axis.
struct Side<S> {
    start: Vec3<S>,
    axis: Vec3<S>,
    length: S,
    /// The component of `start` perpendicular to the axis.
    across: Vec3<S>,
    /// The square of `across` minus the square of the radius.
    power: S,
    per_radius: S,
}

impl<S: Scalar> Side<S> {
    fn new(start: Vec3<S>, end: Vec3<S>, radius: S) -> Self {
        let axis = unit(end - start);
        let across = start - axis * start.dot(axis);
        let power = across.dot(across) - radius * radius;
        Self { start, axis, length: (end - start).dot(axis), across, power, per_radius: radius.recip() }
    }

    /// The depth of a ray's first intersection, and the unit normal there.
    fn meet(&self, ray: Vec3<S>) -> Option<(S, Vec3<S>)> {
        let across = ray - self.axis * ray.dot(self.axis);
        let (square, half) = (across.dot(across), across.dot(self.across));
        let inside = half * half - square * self.power;
        if inside < S::ZERO || square == S::ZERO {
            return None;
        }
        let depth = (half - S::root(inside.product(S::ONE))).divide(square);
        let offset = ray * depth - self.start;
        let along = offset.dot(self.axis);
        let is_between = along >= S::ZERO && along <= self.length;
        is_between.then(|| (depth, (offset - self.axis * along) * self.per_radius))
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::Size;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::RgbColor;

    use super::*;
    use crate::render::View;
    use crate::scalar::Q24;

    const SCREEN: Size = Size::new(48, 48);
    const VIEW: View = View::new(0.0, 0.0).at(Place([0.0, 0.0, 0.0]), Length(40.0));

    #[test]
    fn it_looks_like_all_the_balls_on_its_axis() {
        fn check<S: Scalar>() {
            let camera = Camera::<S>::new(&VIEW, SCREEN);
            let light = Light::new(0.0, 45.0);
            for (a, b) in
                [([-6.0, 0.0, -5.0], [5.0, 6.0, 7.0]), ([0.0, -8.0, 0.0], [0.0, 8.0, 2.0]), ([1.0; 3], [1.0; 3])]
            {
                let rod = Rod::<S>::new(Place(a), Place(b), Length(1.5), Rgb888::RED);
                let mut found = MockDisplay::<Rgb888>::new();
                rod.draw(0, &camera, &light, &mut found).unwrap();
                let mut expected = MockDisplay::<Rgb888>::new();
                expected.set_allow_overdraw(true);
                for k in 0..=64 {
                    let part = f64::from(k) / 64.0;
                    let centre = [0, 1, 2].map(|axis| a[axis] + part * (b[axis] - a[axis]));
                    let ball = Ball::<S>::new(Place(centre), Length(1.5), Rgb888::RED);
                    ball.draw(0, &camera, &light, &mut expected).unwrap();
                }
                let drawn = |display: &MockDisplay<Rgb888>, x, y| display.get_pixel(Point::new(x, y)).is_some();
                let pixels = || (0..48).flat_map(|y| (0..48).map(move |x| (x, y)));
                let wrong = pixels().filter(|&(x, y)| drawn(&found, x, y) != drawn(&expected, x, y)).count();
                let total = pixels().filter(|&(x, y)| drawn(&expected, x, y)).count();
                assert!(total > 20 && wrong <= 1, "{} {a:?}: {wrong} of {total}", S::NAME);
            }
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }

    #[test]
    fn it_hides_what_is_beyond_it_and_shades_what_is_below() {
        let camera = Camera::<Q24>::new(&VIEW, SCREEN);
        let rod = Rod::<Q24>::new(Place([-50.0, 0.0, 5.0]), Place([50.0, 0.0, 5.0]), Length(1.0), Rgb888::RED);
        let hides = |point| rod.hides(0, camera.place(Vec3::from_f64(point)), &camera);
        assert!(hides([30.0, 2.0, 5.0]) && hides([-3.0, 2.0, 5.0]));
        assert!(!hides([3.0, -2.0, 5.0]) && !hides([-30.0, -2.0, 5.0]));
        let up = Vec3::from_f64([0.0, 0.0, 1.0]);
        let shades = |point| rod.shades(Vec3::from_f64(point), up);
        assert!(
            shades([40.0, 0.9, 0.0])
                && !shades([40.0, 1.1, 0.0])
                && shades([50.9, 0.0, 0.0])
                && !shades([51.1, 0.0, 0.0])
        );
    }
}

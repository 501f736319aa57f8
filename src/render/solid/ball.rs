//! A ball.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::Solids;
use crate::render::camera::Camera;
use crate::render::fill::next_middle;
use crate::render::light::{Finish, Light, Normal};
use crate::scalar::Scalar;
use crate::units::{Length, Point as Place};
use crate::vec3::Vec3;

/// A ball. Memory: four numbers and a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball<S> {
    /// Its middle, cells.
    pub centre: Vec3<S>,
    /// Its radius, cells.
    pub radius: S,
    /// Its colour.
    pub tone: Rgb888,
}

pub(super) const PAINT: Finish = Finish { gloss: Rgb888::new(110, 110, 110), polish: 5, translucency: 0 };

impl<S: Scalar> Ball<S> {
    /// A ball with this middle, radius and colour.
    ///
    /// # Panics
    /// For a radius that is negative or beyond the range of the number type.
    #[track_caller]
    pub fn new(centre: Place, radius: Length, tone: Rgb888) -> Self {
        radius.check_size::<S>();
        Self { centre: centre.to_vec(), radius: S::from_f64(radius.0), tone }
    }

    fn seen(&self, camera: &Camera<S>) -> Sphere<S> {
        Sphere::new(camera.place(self.centre), camera.scale(self.radius))
    }
}

impl<S: Scalar> Solids<S> for Ball<S> {
    fn count(&self) -> usize {
        1
    }

    fn depth(&self, _index: usize, camera: &Camera<S>) -> S {
        camera.place(self.centre).z
    }

    fn hides(&self, _index: usize, place: Vec3<S>, camera: &Camera<S>) -> bool {
        self.seen(camera).hides(place)
    }

    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool {
        let offset = self.centre - point;
        let along = offset.dot(towards);
        let reach = self.radius;
        let across = offset - towards * along;
        // outside of the ball's box, the square may not fit the type
        let near = across.x.abs() < reach && across.y.abs() < reach && across.z.abs() < reach;
        along > S::ZERO && near && across.squared() < reach.product(reach)
    }

    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        _index: usize,
        camera: &Camera<S>,
        light: &Light,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let sphere = self.seen(camera);
        let Some(outline) = sphere.outline(camera) else { return Ok(()) };
        let lamp = light.lamp_seen(camera);
        let Sphere { centre: c, power, .. } = sphere;
        let across = power - c.x * c.x;
        let area = outline.intersection(&target.bounding_box());
        for row in area.rows() {
            // b² − k·(x² + y² + 1) = 0 solved for x
            let y = camera.slope_up(row);
            let m = y * c.y + c.z;
            let inside = (m * m - across * (S::ONE + y * y)).max(S::ZERO);
            let (left, right) = roots(c.x * m, S::root(power.product(inside)), across);
            let columns = area.columns();
            let columns =
                next_middle(camera.column(left)).max(columns.start)..next_middle(camera.column(right)).min(columns.end);
            if columns.is_empty() {
                continue;
            }
            let stretch = Rectangle::new(Point::new(columns.start, row), Size::new(columns.len() as u32, 1));
            let tones = columns.map(|column| {
                let ray = Vec3::new(camera.slope_right(column), y, S::ONE);
                let (_, normal) = sphere.meet(ray, sphere.inside(ray).max(S::ZERO));
                lamp.tone(self.tone, &PAINT, Normal::of(normal))
            });
            target.fill_contiguous(&stretch, tones)?;
        }
        Ok(())
    }
}

/// A ball in eye coordinates, with middle c and radius r.
///
/// A ray t·(x, y, 1) intersects it if b² ≥ k·(x² + y² + 1), where b = (x, y, 1)·c and k = c² − r².
#[derive(Clone, Copy)]
pub(super) struct Sphere<S> {
    pub(super) centre: Vec3<S>,
    radius: S,
    per_radius: S,
    /// k
    power: S,
}

impl<S: Scalar> Sphere<S> {
    pub(super) fn new(centre: Vec3<S>, radius: S) -> Self {
        Self { centre, radius, per_radius: radius.recip(), power: centre.dot(centre) - radius * radius }
    }

    /// Whether a place p is beyond the polar plane of the eye, (p − c)·(eye − c) = r², or deep inside. A face that comes out of a pole is thereby drawn as coming from
    /// behind it. (The middle of a face that lies on a ball is inside it too, but not deep.)
    pub(super) fn hides(&self, place: Vec3<S>) -> bool {
        let (offset, deep) = (self.centre - place, self.radius - self.radius.halve(3));
        offset.dot(self.centre) < self.radius * self.radius || offset.dot(offset) < deep * deep
    }

    /// The bounding box of its pixels; `None` if it reaches the near plane.
    pub(super) fn outline(&self, camera: &Camera<S>) -> Option<Rectangle> {
        let Self { centre: c, radius: r, power, .. } = *self;
        if c.z - r < Camera::<S>::near() {
            return None;
        }
        // the bounds are planes through the eye that touch the ball
        let extent = |c: S, other: S, divisor| roots(c, r * S::root((power - other * other).product(S::ONE)), divisor);
        let divisor = c.z * c.z - r * r;
        let (left, right) = extent(c.x * c.z, c.y, divisor);
        let (bottom, top) = extent(c.y * c.z, c.x, divisor);
        let first = Point::new(next_middle(camera.column(left)), next_middle(camera.row(top)));
        let end = Point::new(next_middle(camera.column(right)), next_middle(camera.row(bottom)));
        Some(Rectangle::new(first, Size::new((end.x - first.x).max(0) as u32, (end.y - first.y).max(0) as u32)))
    }

    /// b² − k·(x² + y² + 1) of a ray: negative if it misses the ball.
    pub(super) fn inside(&self, ray: Vec3<S>) -> S {
        let b = ray.dot(self.centre);
        b * b - self.power * ray.dot(ray)
    }

    /// The depth of a ray's first intersection, and the ball's unit normal there.
    pub(super) fn meet(&self, ray: Vec3<S>, inside: S) -> (S, Vec3<S>) {
        let depth = self.power.divide(ray.dot(self.centre) + S::root(inside.product(S::ONE)));
        (depth, (ray * depth - self.centre) * self.per_radius)
    }
}

/// (middle ∓ half)/divisor
fn roots<S: Scalar>(middle: S, half: S, divisor: S) -> (S, S) {
    ((middle - half).divide(divisor), (middle + half).divide(divisor))
}

#[cfg(test)]
mod tests {
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::RgbColor;

    use super::*;
    use crate::render::View;
    use crate::scalar::Q24;

    const SCREEN: Size = Size::new(48, 48);
    const VIEW: View = View::new(0.0, 0.0).at(Place([0.0, 0.0, 0.0]), Length(20.0));

    fn picture<S: Scalar>(ball: &Ball<S>, view: &View) -> MockDisplay<Rgb888> {
        let mut display = MockDisplay::new();
        ball.draw(0, &Camera::new(view, SCREEN), &Light::new(0.0, 45.0), &mut display).unwrap();
        display
    }

    fn is_drawn(display: &MockDisplay<Rgb888>, at: Point) -> bool {
        display.get_pixel(at).is_some()
    }

    #[test]
    fn its_outline_is_the_cone_of_rays_that_touch_it() {
        fn check<S: Scalar>() {
            for (centre, radius) in [([0.0, 0.0, 0.0], 2.0), ([3.0, -6.0, 2.5], 2.0), ([-4.0, 3.0, -4.0], 1.0)] {
                let ball = Ball::<S>::new(Place(centre), Length(radius), Rgb888::RED);
                let display = picture(&ball, &VIEW);
                let focal = 24.0 / libm::tan(15_f64.to_radians());
                let (mut inside, mut wrong) = (0, 0);
                for y in 0..48 {
                    for x in 0..48 {
                        let ray = [(x as f64 - 23.5) / focal, 1.0, (23.5 - y as f64) / focal];
                        let offset = [centre[0], centre[1] + 20.0, centre[2]];
                        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                        let b = dot(ray, offset);
                        let hit = b * b >= dot(ray, ray) * (dot(offset, offset) - radius * radius);
                        inside += u32::from(hit);
                        wrong += u32::from(hit != is_drawn(&display, Point::new(x, y)));
                    }
                }
                assert!(inside > 10);
                assert_eq!(wrong, 0, "{} {centre:?}", S::NAME);
            }
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }

    #[test]
    fn the_side_towards_the_lamp_is_brighter() {
        let display = picture(&Ball::<Q24>::new(Place([0.0; 3]), Length(4.0), Rgb888::new(100, 100, 100)), &VIEW);
        let tone = |y| display.get_pixel(Point::new(24, y)).unwrap().r();
        assert!(tone(12) > tone(24) && tone(24) > tone(40));
    }

    #[test]
    fn behind_the_camera_or_around_it_nothing_is_drawn() {
        for place in [[0.0, -30.0, 0.0], [0.0, -20.0, 0.0], [0.0, -17.0, 0.0]] {
            let display = picture(&Ball::<f32>::new(Place(place), Length(2.0), Rgb888::RED), &VIEW);
            assert_eq!(display.affected_area(), Rectangle::zero());
        }
    }

    #[test]
    fn it_hides_what_is_beyond_its_outline() {
        let camera = Camera::<Q24>::new(&VIEW, SCREEN);
        let ball = Ball::<Q24>::new(Place([0.0; 3]), Length(2.0), Rgb888::RED);
        let hides = |point| ball.hides(0, camera.place(Vec3::from_f64(point)), &camera);
        // the polar plane of an eye at distance d lies r²/d = 0.2 in front of the middle
        assert!(!hides([0.0, -0.21, 2.5]) && hides([0.0, -0.19, 2.5]));
        assert!(hides([0.0, 3.0, 0.0]) && !hides([0.0, -3.0, 0.0]));
        // on the near side, a little inside and deep inside
        assert!(!hides([0.0, -1.8, 0.0]) && hides([0.0, -1.7, 0.0]));
    }

    #[test]
    fn it_shades_a_cylinder() {
        let ball = Ball::<Q24>::new(Place([20.0, 0.0, 10.0]), Length(3.0), Rgb888::RED);
        let up = Vec3::from_f64([0.0, 0.0, 1.0]);
        let shades = |point| ball.shades(Vec3::from_f64(point), up);
        assert!(shades([20.0, 2.9, 0.0]) && !shades([20.0, 3.1, 0.0]) && !shades([20.0, 0.0, 20.0]));
        assert!(!shades([-100.0, -100.0, 0.0]));
    }
}

//! A ball.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::Solids;
use crate::render::camera::Camera;
use crate::render::fill::next_middle;
use crate::render::light::{Finish, Light};
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

const PAINT: Finish = Finish { gloss: Rgb888::new(60, 60, 60), polish: 5, translucency: 0 };

impl<S: Scalar> Ball<S> {
    /// A ball of this place, radius and colour.
    pub fn new(centre: Place, radius: Length, tone: Rgb888) -> Self {
        Self { centre: centre.to_vec(), radius: S::from_f64(radius.0), tone }
    }

    /// The middle and the radius as the eye sees them.
    fn seen(&self, camera: &Camera<S>) -> (Vec3<S>, S) {
        (camera.place(self.centre), camera.scale(self.radius))
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
        // the polar plane of the eye: (p − c)·(eye − c) = r²
        let (centre, radius) = self.seen(camera);
        (centre - place).dot(centre) < radius * radius
    }

    fn shades(&self, point: Vec3<S>, towards: Vec3<S>) -> bool {
        let offset = self.centre - point;
        let along = offset.dot(towards);
        let reach = self.radius;
        let across = offset - towards * along;
        // beyond the ball's box the square need not fit the type
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
        let (c, r) = self.seen(camera);
        if c.z - r < Camera::<S>::near() {
            return Ok(());
        }
        let lamp = light.lamp_seen(camera);
        let per_radius = r.recip();
        let area = target.bounding_box();
        let end = area.top_left + area.size;
        let (rows_end, columns_end) = (end.y, end.x);
        // A ray (x, y, 1) meets the ball where b² ≥ k·(x² + y² + 1) for b = (x, y, 1)·c and k = c² − r².
        let k = c.dot(c) - r * r;
        let (bottom, top) = roots(c.y * c.z, r * S::root((k - c.x * c.x).product(S::ONE)), c.z * c.z - r * r);
        let rows = next_middle(camera.row(top)).max(area.top_left.y)..next_middle(camera.row(bottom)).min(rows_end);
        for row in rows {
            let y = camera.slope_up(row);
            let m = y * c.y + c.z;
            let square = S::ONE + y * y;
            let inside = (m * m - (k - c.x * c.x) * square).max(S::ZERO);
            let (left, right) = roots(c.x * m, S::root(k.product(inside)), k - c.x * c.x);
            let columns = next_middle(camera.column(left)).max(area.top_left.x)
                ..next_middle(camera.column(right)).min(columns_end);
            if columns.is_empty() {
                continue;
            }
            let stretch = Rectangle::new(Point::new(columns.start, row), Size::new(columns.len() as u32, 1));
            let tones = columns.map(|column| {
                let x = camera.slope_right(column);
                let b = x * c.x + m;
                let inside = (b * b - k * (square + x * x)).max(S::ZERO);
                let depth = k.divide(b + S::root(inside.product(S::ONE)));
                let normal = (Vec3::new(x, y, S::ONE) * depth - c) * per_radius;
                lamp.tone(self.tone, &PAINT, normal)
            });
            target.fill_contiguous(&stretch, tones)?;
        }
        Ok(())
    }
}

/// (middle ∓ half)/divisor
fn roots<S: Scalar>(middle: S, half: S, divisor: S) -> (S, S) {
    ((middle - half).divide(divisor), (middle + half).divide(divisor))
}

//! Shadows on the ground.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888};
use embedded_graphics::primitives::Rectangle;

use super::camera::Spot;
use super::fill;
use super::solid::Solids;
use super::tone::mix;
use crate::grid::Node;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// A square of ground that a shadow may fall on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field<S> {
    /// The middle of the square, cells.
    pub centre: Vec3<S>,
    /// The distance from the middle to an edge, cells.
    pub reach: S,
    /// The unit vector to the lamp.
    pub towards: Vec3<S>,
}

/// The shadow on the ground: none, `()`, or a [`Shadow`].
pub trait Cast {
    /// Computes the shadow of a sheet and of solids.
    fn cast<S: Scalar, O: Solids<S>, const W: usize, const H: usize>(
        &mut self,
        particles: &Particles<S, W, H>,
        solids: &O,
        field: &Field<S>,
    );

    /// The tone of the ground at a place of its square (−1 to 1 from edge to edge), where `tone` is its tone in full light.
    fn darken<S: Scalar>(&self, tone: Rgb888, x: S, y: S) -> Rgb888;
}

impl Cast for () {
    fn cast<S: Scalar, O: Solids<S>, const W: usize, const H: usize>(
        &mut self,
        _: &Particles<S, W, H>,
        _: &O,
        _: &Field<S>,
    ) {
    }

    fn darken<S: Scalar>(&self, tone: Rgb888, _x: S, _y: S) -> Rgb888 {
        tone
    }
}

/// A soft shadow: a map of `N × N` places of the ground, blurred and interpolated.
///
/// Memory: N² bytes and 8 more. `N` up to 256.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shadow<const N: usize> {
    /// The ground's tone where no light from the lamp arrives.
    pub tone: Rgb888,
    /// The number of blurs of the map. Each adds half a place of the map to the square of the width of the shadow's edge.
    pub softness: u32,
    cover: [[u8; N]; N],
}

impl<const N: usize> Shadow<N> {
    /// A shadow of this tone, blurred 2 times.
    pub const fn new(tone: Rgb888) -> Self {
        const { assert!(N > 0 && N <= 256, "a shadow's map has 1 to 256 places a side") };
        Self { tone, softness: 2, cover: [[0; N]; N] }
    }

    /// This shadow with another softness.
    #[must_use]
    pub const fn soften(self, softness: u32) -> Self {
        Self { softness, ..self }
    }

    fn blur(&mut self) {
        for k in 0..N {
            blur(self.cover[k].iter_mut());
            blur(self.cover.iter_mut().map(|row| &mut row[k]));
        }
    }

    fn at(&self, column: i32, row: i32) -> i32 {
        let inside = |k: i32| usize::try_from(k).ok().filter(|&k| k < N);
        match (inside(column), inside(row)) {
            (Some(column), Some(row)) => i32::from(self.cover[row][column]),
            _ => 0,
        }
    }
}

/// Replaces each value by ½ of itself plus ¼ of each neighbour. Values beyond the ends are 0.
fn blur<'a>(line: impl Iterator<Item = &'a mut u8>) {
    let mut before = 0;
    let mut waiting: Option<&mut u8> = None;
    for value in line {
        if let Some(middle) = waiting {
            let sharp = u32::from(*middle);
            *middle = ((before + 2 * sharp + u32::from(*value) + 2) >> 2) as u8;
            before = sharp;
        }
        waiting = Some(value);
    }
    if let Some(last) = waiting {
        *last = ((before + 2 * u32::from(*last) + 2) >> 2) as u8;
    }
}

impl<const N: usize> Cast for Shadow<N> {
    fn cast<S: Scalar, O: Solids<S>, const W: usize, const H: usize>(
        &mut self,
        particles: &Particles<S, W, H>,
        solids: &O,
        field: &Field<S>,
    ) {
        self.cover = [[0; N]; N];
        if field.towards.z <= S::ZERO {
            return;
        }
        let scale = field.reach.recip();
        let slope =
            Vec3::new(field.towards.x.divide(field.towards.z), field.towards.y.divide(field.towards.z), S::ZERO);
        let half = 128 * N as i32;
        let spot = |column, row| {
            let offset = (particles.position.at(Node::new(column, row)) - field.centre) * scale;
            let fallen = offset - slope * offset.z.max(S::ZERO);
            Spot { x: fallen.x.round_times(half) + half, y: fallen.y.round_times(half) + half }
        };
        let area = Map(&mut self.cover).bounding_box();
        for row in 1..H {
            for column in 1..W {
                let [p, q, s, t] = [(column - 1, row - 1), (column, row - 1), (column - 1, row), (column, row)]
                    .map(|(column, row)| spot(column, row));
                for corners in [[q, p, s], [t, q, s]] {
                    let Ok(()) = fill::triangle(corners, Gray8::WHITE, &area, &mut Map(&mut self.cover));
                }
            }
        }
        if solids.count() > 0 {
            // in units of 1/256: 128 in units of 1 does not fit every type
            let part = S::ONE.halve(8);
            let place = |k: usize| field.reach * part.times(2 * k as i32 + 1 - N as i32).divide(part.times(N as i32));
            for (row, line) in self.cover.iter_mut().enumerate() {
                for (column, cover) in line.iter_mut().enumerate() {
                    let point = field.centre + Vec3::new(place(column), place(row), S::ZERO);
                    if solids.shades(point, field.towards) {
                        *cover = u8::MAX;
                    }
                }
            }
        }
        for _ in 0..self.softness {
            self.blur();
        }
    }

    fn darken<S: Scalar>(&self, tone: Rgb888, x: S, y: S) -> Rgb888 {
        let half = 128 * N as i32;
        let (x, y) = (x.round_times(half) + half - 128, y.round_times(half) + half - 128);
        let (column, row) = (x >> 8, y >> 8);
        let (right, down) = (x & 255, y & 255);
        let across = |row| self.at(column, row) * (256 - right) + self.at(column + 1, row) * right;
        let cover = (across(row) * (256 - down) + across(row + 1) * down) >> 16;
        if cover == 0 { tone } else { mix(tone, self.tone, cover + (cover >> 7)) }
    }
}

/// The map of a shadow as a draw target.
struct Map<'a, const N: usize>(&'a mut [[u8; N]; N]);

impl<const N: usize> OriginDimensions for Map<'_, N> {
    fn size(&self) -> Size {
        Size::new_equal(N as u32)
    }
}

impl<const N: usize> DrawTarget for Map<'_, N> {
    type Color = Gray8;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(Point { x, y }, color) in pixels {
            let cover = self.0.get_mut(y as usize).and_then(|row| row.get_mut(x as usize));
            if let Some(cover) = cover {
                *cover = color.luma();
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray8) -> Result<(), Infallible> {
        let area = area.intersection(&self.bounding_box());
        for row in area.rows() {
            for column in area.columns() {
                self.0[row as usize][column as usize] = color.luma();
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloth::Cloth;
    use crate::render::{Ball, Rod};
    use crate::scalar::Q24;
    use crate::units::{Length, Point as Spot, Units};

    const UNITS: Units = Units::sheet([4, 4], [3.0, 3.0], 1.0, 0.1, 1);

    fn field<S: Scalar>(towards: [f64; 3]) -> Field<S> {
        Field {
            centre: Vec3::ZERO,
            reach: S::from_f64(16.0),
            towards: crate::render::light::unit(Vec3::from_f64(towards)),
        }
    }

    /// The number of covered places, and their centroid, cells.
    fn middle<const N: usize>(shadow: &Shadow<N>) -> (f64, f64, f64) {
        let mut sum = (0.0, 0.0, 0.0);
        for (row, line) in shadow.cover.iter().enumerate() {
            for (column, &cover) in line.iter().enumerate() {
                let place = |k: usize| ((k as f64 + 0.5) / N as f64 - 0.5) * 32.0;
                let cover = f64::from(cover) / 255.0;
                sum = (sum.0 + cover, sum.1 + cover * place(column), sum.2 + cover * place(row));
            }
        }
        (sum.0, sum.1 / sum.0, sum.2 / sum.0)
    }

    fn cast<S: Scalar, O: Solids<S>, const N: usize>(solids: &O, height: f64, softness: u32) -> Shadow<N> {
        let mut shadow = Shadow::new(Rgb888::new(0, 0, 0)).soften(softness);
        let cloth = Cloth::<S, 4, 4>::lay(&UNITS, Spot([-1.5, -1.5, height]));
        shadow.cast(&cloth, solids, &field([-1.0, 0.5, 2.0]));
        shadow
    }

    #[test]
    fn a_sheets_shadow_lies_along_the_light_and_has_its_area() {
        fn check<S: Scalar, const N: usize>() {
            for softness in [0, 3] {
                let (count, x, y) = middle(&cast::<S, (), N>(&(), 6.0, softness));
                let expected = 9.0 * (N as f64 / 32.0) * (N as f64 / 32.0);
                assert!((count - expected).abs() < 0.05 * expected, "{} {N}: {count}", S::NAME);
                assert!((x - 3.0).abs() < 0.03 && (y + 1.5).abs() < 0.03, "{} {N}: {x} {y}", S::NAME);
            }
        }
        check::<f64, 128>();
        check::<f32, 256>();
        check::<Q24, 128>();
        check::<Q24, 256>();
    }

    #[test]
    fn solids_cast_shadows_too() {
        fn check<S: Scalar>() {
            let ball = Ball::new(Spot([0.0, 0.0, 4.0]), Length(2.0), Rgb888::new(0, 0, 0));
            // the sheet is inside the ball, whose shadow is an ellipse of area πr²/l_z
            let (count, x, y) = middle(&cast::<S, _, 128>(&ball, 4.0, 0));
            let expected = core::f64::consts::PI * 4.0 / (2.0 / libm::sqrt(5.25)) * 16.0;
            assert!((count - expected).abs() < 0.02 * expected, "{}: {count} {expected}", S::NAME);
            assert!((x - 2.0).abs() < 0.03 && (y + 1.0).abs() < 0.03, "{}: {x} {y}", S::NAME);
            let rod = Rod::new(Spot([-8.0, 0.0, 1.0]), Spot([8.0, 0.0, 1.0]), Length(0.5), Rgb888::new(0, 0, 0));
            let (longer, ..) = middle(&cast::<S, _, 128>(&(ball, rod), 4.0, 0));
            assert!(longer > count + 100.0);
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }

    #[test]
    fn a_lamp_below_the_ground_casts_none() {
        let mut shadow = cast::<Q24, (), 16>(&(), 6.0, 1);
        assert_ne!(shadow.cover, [[0; 16]; 16]);
        shadow.cast(&Cloth::<Q24, 4, 4>::lay(&UNITS, Spot([0.0; 3])), &(), &field([0.3, 0.3, -1.0]));
        assert_eq!(shadow.cover, [[0; 16]; 16]);
    }

    #[test]
    fn tones_between_places_are_interpolated() {
        let mut shadow = Shadow::<2>::new(Rgb888::new(0, 0, 0));
        shadow.cover = [[0, 255], [0, 255]];
        let luma = |x: f64| Gray8::from(shadow.darken(Rgb888::new(200, 200, 200), x, 0.0)).luma();
        assert_eq!([luma(-0.5), luma(0.0), luma(0.5)], [200, 101, 0]);
        assert_eq!(luma(1.0), 101, "half a place beyond the last");
    }

    #[test]
    fn memory_is_as_documented() {
        assert_eq!(size_of::<Shadow<32>>(), 32 * 32 + 8);
    }
}

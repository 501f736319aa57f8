//! The shadow on the ground.

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
use crate::cloth::Cloth;
use crate::grid::Node;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// A square of ground that a shadow may fall on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field<S> {
    /// The middle of the square, cells.
    pub centre: Vec3<S>,
    /// From the middle to an edge, cells.
    pub reach: S,
    /// The unit vector to the lamp.
    pub towards: Vec3<S>,
}

/// What falls on the ground: nothing, `()`, or a [`Shadow`].
pub trait Cast {
    /// Computes the shadow of a sheet and of solids.
    fn cast<S: Scalar, O: Solids<S>, const W: usize, const H: usize>(
        &mut self,
        cloth: &Cloth<S, W, H>,
        solids: &O,
        field: &Field<S>,
    );

    /// The tone of the ground at a place of its square (−1 to 1 from edge to edge) which has this tone in the light.
    fn darken<S: Scalar>(&self, tone: Rgb888, x: S, y: S) -> Rgb888;
}

impl Cast for () {
    fn cast<S: Scalar, O: Solids<S>, const W: usize, const H: usize>(
        &mut self,
        _: &Cloth<S, W, H>,
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
/// Memory: N² bytes and 12 more. `N` up to 256.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shadow<const N: usize> {
    /// The ground's tone where no light from the lamp arrives.
    pub tone: Rgb888,
    /// How far the shadow's edge is blurred: each step adds half a place of the map to the square of its width.
    pub softness: u32,
    cover: [[u8; N]; N],
}

impl<const N: usize> Shadow<N> {
    /// A shadow of this tone, two steps soft.
    pub const fn new(tone: Rgb888) -> Self {
        const { assert!(N > 0 && N <= 256, "a shadow's map has 1 to 256 places a side") };
        Self { tone, softness: 2, cover: [[0; N]; N] }
    }

    /// The same with this softness.
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

/// ¼, ½, ¼ of each value and its neighbours; nothing beyond the ends.
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
        cloth: &Cloth<S, W, H>,
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
            let offset = (cloth.position[Node::new(column, row)] - field.centre) * scale;
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
            // in 256ths, as 128 whole ones do not fit every type
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

/// The map as a target.
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

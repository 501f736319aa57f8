//! A sheet drawn as its faces.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::primitives::Rectangle;

use super::camera::{Camera, Spot};
use super::fill;
use super::gouraud;
use super::ground::Backdrop;
use super::light::{Lamp, Normal};
use super::look::Look;
use super::pattern::{Pattern, Place};
use super::shading::{Flat, Gouraud, Part, Shading, Side};
use super::solid::Solids;
use super::surface;
use super::tone::{Shade, Toned};
use crate::grid::{Grid, Node};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// Draws sheets of `W × H` particles with light and shade, from back to front.
///
/// Each cell is drawn as `N × N` faces: one, unless set by [`smooth`](Self::smooth). A face has one tone, unless [`gouraud`](Self::gouraud) interpolates tones.
///
/// Memory: the look, and 16 bytes per particle for screen positions and the order of cells. Interpolated tones take 16 bytes more per particle, and tables of colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaded<L, const W: usize, const H: usize, const N: usize = 1, T = Flat> {
    /// The look of the picture.
    pub look: L,
    shading: T,
    /// Depths and cells, as keys to be sorted.
    order: Grid<u32, W, H>,
    seen: Grid<Seen, W, H>,
}

/// The screen position and depth of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Seen {
    spot: Spot,
    /// In 2⁻¹³ of the distance to the target; negative for a point that isn't drawn.
    depth: i32,
}

impl Seen {
    const NOWHERE: Self = Self { spot: Spot { x: 0, y: 0 }, depth: -1 };

    fn new<S: Scalar>(point: Vec3<S>, camera: &Camera<S>) -> Self {
        let place = camera.place(point);
        let depth = || place.z.min(S::from_int(7)).round_times(1 << 13);
        camera.spot(place).map_or(Self::NOWHERE, |spot| Self { spot, depth: depth() })
    }
}

impl<L, const W: usize, const H: usize> Shaded<L, W, H> {
    /// A renderer that draws one face for each cell.
    pub const fn new(look: L) -> Self {
        const { assert!(W * H <= 1 << 16, "a shaded sheet has at most 65536 particles") };
        Self { look, shading: Flat, order: Grid::filled(0), seen: Grid::filled(Seen::NOWHERE) }
    }
}

impl<L, T, const W: usize, const H: usize> Shaded<L, W, H, 1, T> {
    /// Draws `N × N` faces for each cell, on a smooth surface through the particles: for large pictures. `N` is at most 64.
    pub fn smooth<const N: usize>(self) -> Shaded<L, W, H, N, T> {
        const { assert!(N > 0 && N <= 64, "a cell is divided into 1 to 64 faces a side") };
        let Self { look, shading, order, seen } = self;
        Shaded { look, shading, order, seen }
    }
}

impl<L, const W: usize, const H: usize, const N: usize> Shaded<L, W, H, N> {
    /// Interpolates tones between particles instead of giving each face one, on displays of the colour `C` and for patterns of `K` colours: see [`Gouraud`].
    pub fn gouraud<C: Shade, const K: usize>(self) -> Shaded<L, W, H, N, Gouraud<C, K, W, H>> {
        const { assert!(!C::PATTERNED, "a display of two colours has no tones in between") };
        let Self { look, order, seen, .. } = self;
        Shaded { look, shading: Gouraud::BLANK, order, seen }
    }
}

impl<F: Pattern, B: Pattern, O, G, T, const W: usize, const H: usize, const N: usize>
    Shaded<Look<F, B, O, G>, W, H, N, T>
{
    /// Draws the backdrop, the solids and the sheet.
    ///
    /// # Errors
    /// Errors of the target.
    pub fn draw<S: Scalar, D: DrawTarget<Color: Shade>>(
        &mut self,
        particles: &Particles<S, W, H>,
        camera: &Camera<S>,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        O: Solids<S>,
        G: Backdrop<S>,
        T: Shading<D::Color, W, H>,
    {
        let Look { light, solids, backdrop, .. } = &mut self.look;
        backdrop.prepare(particles, solids, light);
        backdrop.draw(camera, target)?;
        for (seen, point) in self.seen.0.as_flattened_mut().iter_mut().zip(particles.position.values()) {
            *seen = Seen::new(point, camera);
        }
        let lamp = self.look.light.lamp(camera);
        self.shading.prepare(particles, &lamp);
        let mut solid = farthest(&self.look.solids, camera, None);
        loop {
            let count = self.collect(particles, camera, solid);
            self.faces(particles, camera, &lamp, count, target)?;
            let Some(index) = solid else { return Ok(()) };
            self.look.solids.draw(index, camera, &self.look.light, &mut Toned(target))?;
            solid = farthest(&self.look.solids, camera, Some(index));
        }
    }

    /// Sorts the cells to be drawn next, just before `solid` or (`None`) after all solids, and counts them.
    fn collect<S: Scalar>(&mut self, particles: &Particles<S, W, H>, camera: &Camera<S>, solid: Option<usize>) -> usize
    where
        O: Solids<S>,
    {
        let solids = &self.look.solids;
        let order = self.order.0.as_flattened_mut();
        let mut count = 0;
        for row in 1..H {
            for column in 1..W {
                let corners = corners(column - 1, row - 1);
                let depths = corners.map(|corner| self.seen[corner].depth);
                if depths.into_iter().any(|depth| depth < 0) {
                    continue;
                }
                if solids.count() > 0 {
                    let [p, q, s, t] = corners.map(|node| particles.position.at(node).halve(2));
                    let place = camera.place(p + q + s + t);
                    let before = |index| solids.hides(index, place, camera);
                    let due = solid.is_none_or(before)
                        && !(0..solids.count()).any(|other| is_deeper(solids, camera, other, solid) && before(other));
                    if !due {
                        continue;
                    }
                }
                let depth = depths.into_iter().sum::<i32>() as u32 >> 2;
                order[count] = (0xffff - depth) << 16 | ((row - 1) * W + column - 1) as u32;
                count += 1;
            }
        }
        order[..count].sort_unstable();
        count
    }

    /// Draws the first cells of the order.
    fn faces<S: Scalar, D: DrawTarget<Color: Shade>>(
        &mut self,
        particles: &Particles<S, W, H>,
        camera: &Camera<S>,
        lamp: &Lamp,
        count: usize,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        T: Shading<D::Color, W, H>,
    {
        let Self { look, shading, order, seen } = self;
        let mut easel = Easel::<_, _, _, _, _, W, H> { look, shading, lamp, area: target.bounding_box() };
        for key in &order.0.as_flattened()[..count] {
            let cell = (key & 0xffff) as usize;
            let cell = Node::new(cell % W, cell / W);
            let nodes = corners(cell.column, cell.row);
            if N == 1 {
                let points = || nodes.map(|node| particles.position.at(node));
                easel.face(nodes.map(|node| seen[node]), points, Part { cell, column: 0, row: 0, parts: 1 }, target)?;
                continue;
            }
            let [p, q, s, t] = nodes.map(|node| seen[node].depth);
            let (backward, upward) = (p + s < q + t, p + q < s + t);
            let part = |k: usize| S::from_int(k as i32).divide(S::from_int(N as i32));
            let corner = |column: usize, row: usize| {
                // the screen positions of particles are known already
                let node =
                    (column % N == 0 && row % N == 0).then(|| Node::new(cell.column + column / N, cell.row + row / N));
                let point = surface::point(&particles.position, cell, part(column), part(row));
                (point, node.map_or_else(|| Seen::new(point, camera), |node| seen[node]))
            };
            // the corners of a row: the start of each face, and the end of the last one
            let corners_of =
                |row: usize| (core::array::from_fn::<_, N, _>(|column| corner(column, row)), corner(N, row));
            let at = |(starts, end): &([_; N], _), column: usize| *starts.get(column).unwrap_or(end);
            let mut edge = corners_of(if upward { N } else { 0 });
            for row in (0..N).map(|k| if upward { N - 1 - k } else { k }) {
                let next = corners_of(if upward { row } else { row + 1 });
                let (top, bottom) = if upward { (&next, &edge) } else { (&edge, &next) };
                for column in (0..N).map(|k| if backward { N - 1 - k } else { k }) {
                    let corners = [at(top, column), at(top, column + 1), at(bottom, column), at(bottom, column + 1)];
                    let part = Part { cell, column, row, parts: N };
                    easel.face(corners.map(|(_, seen)| seen), || corners.map(|(point, _)| point), part, target)?;
                }
                edge = next;
            }
        }
        Ok(())
    }
}

/// The inputs to drawing a face, apart from its corners.
struct Easel<'a, F, B, O, G, T, const W: usize, const H: usize> {
    look: &'a Look<F, B, O, G>,
    shading: &'a mut T,
    lamp: &'a Lamp,
    area: Rectangle,
}

impl<F: Pattern, B: Pattern, O, G, T, const W: usize, const H: usize> Easel<'_, F, B, O, G, T, W, H> {
    /// Draws the face of corners p, q (to the right), s (below) and t as the triangles (q, p, s) and (t, q, s).
    fn face<S: Scalar, D: DrawTarget<Color: Shade>>(
        &mut self,
        seen: [Seen; 4],
        points: impl FnOnce() -> [Vec3<S>; 4],
        part: Part,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        T: Shading<D::Color, W, H>,
    {
        if seen.iter().any(|seen| seen.depth < 0) {
            return Ok(());
        }
        let spots = seen.map(|seen| seen.spot);
        let turns = fill::turns(spots);
        // Seen from the front, the turn from columns to rows is anticlockwise.
        let is_front = turns[0] + turns[1] > 0;
        let (look, at) = (self.look, Place::middle::<W, H>(part.cell, [part.column, part.row], part.parts as i32));
        let base = if is_front { look.front.tone(&at) } else { look.back.tone(&at) };
        if let Some((levels, ramp)) = self.shading.levels(part, Side { is_front, base }, self.lamp, &look.finish) {
            return gouraud::face(spots, turns, levels, ramp, &self.area, target);
        }
        let [p, q, s, t] = points();
        // The cross product of the diagonals is twice the area of the face, along its normal.
        let diagonals = ((t - p).times(part.parts as i32), (s - q).times(part.parts as i32));
        let normal = Normal::across(diagonals.0, diagonals.1);
        let tone = self.lamp.tone(base, &look.finish, if is_front { normal } else { normal.reversed() });
        if D::Color::PATTERNED {
            let target = &mut Toned(target);
            fill::face(spots, turns, tone, &self.area, target)
        } else {
            let color = D::Color::nearest(tone);
            fill::face(spots, turns, color, &self.area, target)
        }
    }
}

fn corners(column: usize, row: usize) -> [Node; 4] {
    [Node::new(column, row), Node::new(column + 1, row), Node::new(column, row + 1), Node::new(column + 1, row + 1)]
}

/// Whether a solid is drawn before the solid `than`. Every solid is drawn before `None`.
fn is_deeper<S: Scalar>(solids: &impl Solids<S>, camera: &Camera<S>, index: usize, than: Option<usize>) -> bool {
    than.is_none_or(|than| {
        let (depth, other) = (solids.depth(index, camera), solids.depth(than, camera));
        depth > other || (depth == other && index < than)
    })
}

/// The solid that is drawn next after the solid `after`, or first if that is `None`.
fn farthest<S: Scalar>(solids: &impl Solids<S>, camera: &Camera<S>, after: Option<usize>) -> Option<usize> {
    let left =
        (0..solids.count()).filter(|&index| after.is_none_or(|after| is_deeper(solids, camera, after, Some(index))));
    left.reduce(|next, index| if is_deeper(solids, camera, index, Some(next)) { index } else { next })
}

#[cfg(test)]
mod pictures;

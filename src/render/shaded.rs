//! A sheet as its faces.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::camera::Camera;
use super::fill;
use super::ground::Backdrop;
use super::light::{Lamp, unit};
use super::look::Look;
use super::pattern::{Pattern, Place};
use super::solid::Solids;
use super::surface;
use super::tone::{Shade, Toned};
use crate::cloth::Cloth;
use crate::grid::{Grid, Node};
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// Draws sheets of `W × H` particles with light and shade, what is further away first.
///
/// Each cell is drawn as `N × N` faces, one unless it is [`smooth`](Self::smooth).
///
/// Memory: 4 bytes per particle for the order in which cells are drawn, and the look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaded<L, const W: usize, const H: usize, const N: usize = 1> {
    /// How everything looks.
    pub look: L,
    /// Depth and cell, ready to be sorted.
    order: Grid<u32, W, H>,
}

impl<L, const W: usize, const H: usize> Shaded<L, W, H> {
    /// A renderer that draws one face for each cell.
    pub const fn new(look: L) -> Self {
        const { assert!(W * H <= 1 << 16, "a shaded sheet has at most 65536 particles") };
        Self { look, order: Grid::filled(0) }
    }

    /// Draws `N × N` faces for each cell, on a smooth surface through the particles: for large pictures. `N` up to 64.
    pub fn smooth<const N: usize>(self) -> Shaded<L, W, H, N> {
        const { assert!(N > 0 && N <= 64, "a cell is divided into 1 to 64 faces a side") };
        Shaded { look: self.look, order: self.order }
    }
}

impl<F: Pattern, B: Pattern, O, G, const W: usize, const H: usize, const N: usize> Shaded<Look<F, B, O, G>, W, H, N> {
    /// Draws the backdrop, the solids and the sheet.
    ///
    /// # Errors
    /// Whatever the target reports.
    pub fn draw<S: Scalar, D: DrawTarget<Color: Shade>>(
        &mut self,
        cloth: &Cloth<S, W, H>,
        camera: &Camera<S>,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        O: Solids<S>,
        G: Backdrop<S>,
    {
        let Look { light, solids, backdrop, .. } = &mut self.look;
        backdrop.prepare(cloth, solids, light);
        backdrop.draw(camera, target)?;
        let mut target = Toned(target);
        let mut solid = farthest(&self.look.solids, camera, None);
        loop {
            let count = self.collect(cloth, camera, solid);
            self.faces(cloth, camera, count, &mut target)?;
            let Some(index) = solid else { return Ok(()) };
            self.look.solids.draw(index, camera, &self.look.light, &mut target)?;
            solid = farthest(&self.look.solids, camera, Some(index));
        }
    }

    /// Orders the cells that are drawn next, just before a solid or after all of them, and counts them.
    fn collect<S: Scalar>(&mut self, cloth: &Cloth<S, W, H>, camera: &Camera<S>, solid: Option<usize>) -> usize
    where
        O: Solids<S>,
    {
        let solids = &self.look.solids;
        let order = self.order.0.as_flattened_mut();
        let mut count = 0;
        for row in 1..H {
            for column in 1..W {
                let [p, q, s, t] = corners(column - 1, row - 1).map(|node| cloth.position.at(node).halve(2));
                let place = camera.place(p + q + s + t);
                if place.z < Camera::<S>::near() {
                    continue;
                }
                let before = |index| solids.hides(index, place, camera);
                let due = solid.is_none_or(before)
                    && !(0..solids.count()).any(|other| is_deeper(solids, camera, other, solid) && before(other));
                if due {
                    let depth = place.z.min(S::from_int(7)).round_times(1 << 13) as u32;
                    order[count] = (0xffff - depth) << 16 | ((row - 1) * W + column - 1) as u32;
                    count += 1;
                }
            }
        }
        order[..count].sort_unstable();
        count
    }

    /// Draws the first cells of the order.
    fn faces<S: Scalar, D: DrawTarget<Color = Rgb888>>(
        &self,
        cloth: &Cloth<S, W, H>,
        camera: &Camera<S>,
        count: usize,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let easel = Easel::<_, _, _, _, _, N> {
            look: &self.look,
            lamp: self.look.light.lamp(camera),
            camera,
            area: target.bounding_box(),
        };
        for key in &self.order.0.as_flattened()[..count] {
            let cell = (key & 0xffff) as usize;
            let cell = Node::new(cell % W, cell / W);
            let corners = corners(cell.column, cell.row).map(|node| cloth.position.at(node));
            if N == 1 {
                let place = Place::middle::<W, H>(cell, [0, 0], 1);
                easel.face(corners, &place, target)?;
                continue;
            }
            let [p, q, s, t] = corners.map(|corner| camera.place(corner).z);
            let (backward, upward) = (p + s < q + t, p + q < s + t);
            let part = |k: usize| S::from_int(k as i32).divide(S::from_int(N as i32));
            for row in (0..N).map(|k| if upward { N - 1 - k } else { k }) {
                for column in (0..N).map(|k| if backward { N - 1 - k } else { k }) {
                    let corner = |c, r| surface::point(&cloth.position, cell, part(column + c), part(row + r));
                    let place = Place::middle::<W, H>(cell, [column, row], N as i32);
                    easel.face([corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)], &place, target)?;
                }
            }
        }
        Ok(())
    }
}

/// All that a face's picture depends on beside its corners.
struct Easel<'a, S, F, B, O, G, const N: usize> {
    look: &'a Look<F, B, O, G>,
    lamp: Lamp<S>,
    camera: &'a Camera<S>,
    area: Rectangle,
}

impl<S: Scalar, F: Pattern, B: Pattern, O, G, const N: usize> Easel<'_, S, F, B, O, G, N> {
    /// Draws the face of corners p, q (to the right), s (below) and t as the triangles (q, p, s) and (t, q, s).
    fn face<D: DrawTarget<Color = Rgb888>>(
        &self,
        [p, q, s, t]: [Vec3<S>; 4],
        at: &Place,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let [Some(a), Some(b), Some(c), Some(d)] =
            [p, q, s, t].map(|corner| self.camera.spot(self.camera.place(corner)))
        else {
            return Ok(());
        };
        // Seen from the front, columns and rows turn against the clock. The diagonals span twice the face.
        let is_front = fill::turn(b, a, c) + fill::turn(d, b, c) > 0;
        let diagonals = ((t - p).times(N as i32), (s - q).times(N as i32));
        let normal = unit(diagonals.0.cross(diagonals.1));
        let look = self.look;
        let tone = if is_front {
            self.lamp.tone(look.front.tone(at), &look.finish, normal)
        } else {
            self.lamp.tone(look.back.tone(at), &look.finish, -normal)
        };
        fill::triangle([b, a, c], tone, &self.area, target)?;
        fill::triangle([d, b, c], tone, &self.area, target)
    }
}

fn corners(column: usize, row: usize) -> [Node; 4] {
    [Node::new(column, row), Node::new(column + 1, row), Node::new(column, row + 1), Node::new(column + 1, row + 1)]
}

/// Whether a solid is drawn before another; all are drawn before none.
fn is_deeper<S: Scalar>(solids: &impl Solids<S>, camera: &Camera<S>, index: usize, than: Option<usize>) -> bool {
    than.is_none_or(|than| {
        let (depth, other) = (solids.depth(index, camera), solids.depth(than, camera));
        depth > other || (depth == other && index < than)
    })
}

/// The solid that is drawn next after another.
fn farthest<S: Scalar>(solids: &impl Solids<S>, camera: &Camera<S>, after: Option<usize>) -> Option<usize> {
    let left =
        (0..solids.count()).filter(|&index| after.is_none_or(|after| is_deeper(solids, camera, after, Some(index))));
    left.reduce(|next, index| if is_deeper(solids, camera, index, Some(next)) { index } else { next })
}

#[cfg(test)]
mod pictures;

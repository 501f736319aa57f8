//! Shading of faces: one tone per face, or tones interpolated between corners.

use embedded_graphics::pixelcolor::Rgb888;

use super::light::{Finish, Lamp, Normal};
use super::ramp::{LEVELS, Ramps};
use super::tone::Shade;
use crate::grid::{Grid, Node};
use crate::particles::Particles;
use crate::scalar::Scalar;

/// The shading of a sheet's faces on displays of the colour `C`: [`Flat`] or [`Gouraud`], and no other.
pub trait Shading<C, const W: usize, const H: usize> {
    /// Prepares for drawing this sheet in this light.
    fn prepare<S: Scalar>(&mut self, particles: &Particles<S, W, H>, lamp: &Lamp);

    /// The levels of light (· 2⁸) on the visible side at the corners p, q (to the right), s (below) and t of a part of a cell, and the colour of each level. `None` if a
    /// face has one tone.
    fn levels(&mut self, part: Part, side: Side, lamp: &Lamp, finish: &Finish) -> Option<([i32; 4], &[C; LEVELS])>;
}

/// One of the `parts × parts` parts of a cell, at this column and row.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    pub(super) cell: Node,
    pub(super) column: usize,
    pub(super) row: usize,
    pub(super) parts: usize,
}

/// The visible side of a face.
#[derive(Clone, Copy, Debug)]
pub struct Side {
    pub(super) is_front: bool,
    /// Its colour.
    pub(super) base: Rgb888,
}

/// Each face has one tone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flat;

impl<C, const W: usize, const H: usize> Shading<C, W, H> for Flat {
    #[inline(always)]
    fn prepare<S: Scalar>(&mut self, _: &Particles<S, W, H>, _: &Lamp) {}

    #[inline(always)]
    fn levels(&mut self, _: Part, _: Side, _: &Lamp, _: &Finish) -> Option<([i32; 4], &[C; LEVELS])> {
        None
    }
}

/// Tones are interpolated between particles (H. Gouraud, *Continuous shading of curved surfaces*, 1971), for patterns of up to `K` colours.
///
/// The light on a particle has 128 levels. Each colour of the pattern has a table of its tones at these levels. A particle's normal and its levels on both sides take
/// 16 bytes, and a table of 16-bit colours 264.
/// Patterns of more colours are drawn as well, more slowly: tables are recomputed in every picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gouraud<C, const K: usize, const W: usize, const H: usize> {
    normal: Grid<Normal, W, H>,
    /// Levels of the front and of the back, · 2⁸; `UNKNOWN` until they are needed.
    level: Grid<[u16; 2], W, H>,
    ramps: Ramps<C, K>,
}

const UNKNOWN: u16 = u16::MAX;

impl<C: Shade, const K: usize, const W: usize, const H: usize> Gouraud<C, K, W, H> {
    pub(super) const BLANK: Self =
        Self { normal: Grid::filled(Normal::NONE), level: Grid::filled([UNKNOWN; 2]), ramps: Ramps::NONE };

    #[inline]
    fn level(&mut self, node: Node, is_front: bool, lamp: &Lamp, finish: &Finish) -> i32 {
        let level = &mut self.level[node][usize::from(!is_front)];
        if *level == UNKNOWN {
            let normal = self.normal[node];
            *level = self.ramps.level(lamp.lit(finish, if is_front { normal } else { normal.reversed() }));
        }
        i32::from(*level)
    }
}

impl<C: Shade, const K: usize, const W: usize, const H: usize> Shading<C, W, H> for Gouraud<C, K, W, H> {
    fn prepare<S: Scalar>(&mut self, particles: &Particles<S, W, H>, lamp: &Lamp) {
        self.ramps.prepare(lamp.light());
        self.level = Grid::filled([UNKNOWN; 2]);
        for row in 0..H {
            for column in 0..W {
                let at = |column: usize, row: usize| particles.position.at(Node { column, row });
                // differences between both neighbours; at an edge, between the particle and its only neighbour
                let across = at((column + 1).min(W - 1), row) - at(column.saturating_sub(1), row);
                let down = at(column, (row + 1).min(H - 1)) - at(column, row.saturating_sub(1));
                self.normal.0[row][column] = Normal::across(across, down);
            }
        }
    }

    fn levels(&mut self, part: Part, side: Side, lamp: &Lamp, finish: &Finish) -> Option<([i32; 4], &[C; LEVELS])> {
        let Part { cell: Node { column, row }, parts, .. } = part;
        let [p, q, s, t] = [(column, row), (column + 1, row), (column, row + 1), (column + 1, row + 1)]
            .map(|(column, row)| self.level(Node { column, row }, side.is_front, lamp, finish));
        let ramp = self.ramps.of(side.base);
        if parts == 1 {
            return Some(([p, q, s, t], ramp));
        }
        let mix = |from: i32, to: i32, k: usize| from + (to - from) * k as i32 / parts as i32;
        let between = |right: usize, below: usize| {
            let right = part.column + right;
            mix(mix(p, q, right), mix(s, t, right), part.row + below)
        };
        Some(([between(0, 0), between(1, 0), between(0, 1), between(1, 1)], ramp))
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::pixelcolor::Rgb565;

    use super::*;

    #[test]
    fn memory_is_what_the_documentation_says() {
        const PARTICLES: usize = 8 * 12;
        let [one, four] = [size_of::<Gouraud<Rgb565, 1, 8, 12>>(), size_of::<Gouraud<Rgb565, 4, 8, 12>>()];
        let table = 264;
        assert_eq!(four - one, 3 * table, "of three more tables");
        // the rest: the lights, and the index of the table to replace next
        assert!((0..48).contains(&(one - 16 * PARTICLES - table)), "{one}");
    }
}

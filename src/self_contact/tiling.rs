//! The division of a grid into square tiles of four quads each.

use core::ops::Range;

use crate::grid::Node;

/// The number of 16-bit numbers that a tile's bounds take.
pub(super) const TILE: usize = 12;

/// The tiles of a grid of `W` × `H` particles, row by row.
pub(super) struct Tiling<const W: usize, const H: usize>;

impl<const W: usize, const H: usize> Tiling<W, H> {
    /// Particles along a tile's side: 4, or more if there would be too many tiles to be kept or counted.
    pub(super) const SIDE: usize = {
        let mut side = 4;
        while !fits(W, H, side) {
            side *= 2;
        }
        side
    };
    /// Tiles in a row of tiles.
    pub(super) const ACROSS: usize = W.div_ceil(Self::SIDE);
    /// Rows of tiles.
    pub(super) const DOWN: usize = H.div_ceil(Self::SIDE);
    /// The number of tiles.
    pub(super) const NUMBER: usize = Self::ACROSS * Self::DOWN;

    /// A tile's particles.
    pub(super) fn tile(tile: usize) -> Patch {
        Patch::square::<W, H>(tile % Self::ACROSS * Self::SIDE, tile / Self::ACROSS * Self::SIDE, Self::SIDE)
    }

    /// The particles of one of a tile's quads.
    pub(super) fn quad(tile: usize, quad: usize) -> Patch {
        const { assert!(Self::SIDE >= 2) };
        let half = Self::SIDE / 2;
        let (column, row) = (tile % Self::ACROSS * Self::SIDE, tile / Self::ACROSS * Self::SIDE);
        Patch::square::<W, H>(column + quad % 2 * half, row + quad / 2 * half, half)
    }

    /// Whether tiles are the same or have a corner in common.
    pub(super) fn touch(a: usize, b: usize) -> bool {
        let (across, down) = (a % Self::ACROSS, a / Self::ACROSS);
        across.abs_diff(b % Self::ACROSS) <= 1 && down.abs_diff(b / Self::ACROSS) <= 1
    }
}

/// Whether tiles of so many particles a side can be counted by a byte, and kept in two bytes a particle (a single tile is not kept).
const fn fits(columns: usize, rows: usize, side: usize) -> bool {
    let number = columns.div_ceil(side) * rows.div_ceil(side);
    number == 1 || (number <= 256 && number * TILE <= columns * rows)
}

/// The same node, limited to the grid, so that the compiler leaves out bounds checks.
#[inline(always)]
pub(super) fn inside<const W: usize, const H: usize>(node: Node) -> Node {
    Node { column: node.column.min(W - 1), row: node.row.min(H - 1) }
}

/// A rectangle of particles, which may be empty.
#[derive(Clone, Debug)]
pub(super) struct Patch {
    pub(super) columns: Range<usize>,
    pub(super) rows: Range<usize>,
}

impl Patch {
    fn square<const W: usize, const H: usize>(column: usize, row: usize, side: usize) -> Self {
        Self { columns: column.min(W)..(column + side).min(W), rows: row.min(H)..(row + side).min(H) }
    }

    /// Its particles, row by row.
    pub(super) fn nodes(&self) -> impl Iterator<Item = Node> + use<> {
        let columns = self.columns.clone();
        self.rows.clone().flat_map(move |row| columns.clone().map(move |column| Node { column, row }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn every_particle_is_in_one_quad<const W: usize, const H: usize>() {
        let mut seen = [[0; W]; H];
        for tile in 0..Tiling::<W, H>::NUMBER {
            let patch = Tiling::<W, H>::tile(tile);
            for quad in 0..4 {
                for Node { column, row } in Tiling::<W, H>::quad(tile, quad).nodes() {
                    seen[row][column] += 1;
                    assert!(patch.columns.contains(&column) && patch.rows.contains(&row));
                }
            }
        }
        assert!(seen.iter().flatten().all(|&count| count == 1), "{W} x {H}");
        let number = Tiling::<W, H>::NUMBER;
        assert!(number <= 256 && (number == 1 || number * TILE <= W * H), "{W} x {H}");
    }

    #[test]
    fn tiles_are_all_of_the_grid() {
        every_particle_is_in_one_quad::<1, 1>();
        every_particle_is_in_one_quad::<3, 5>();
        every_particle_is_in_one_quad::<1, 40>();
        every_particle_is_in_one_quad::<9, 13>();
        every_particle_is_in_one_quad::<16, 16>();
        every_particle_is_in_one_quad::<48, 32>();
        every_particle_is_in_one_quad::<65, 64>();
        every_particle_is_in_one_quad::<128, 128>();
        assert_eq!([Tiling::<16, 16>::SIDE, Tiling::<64, 64>::SIDE, Tiling::<128, 128>::SIDE], [4, 4, 8]);
    }
}

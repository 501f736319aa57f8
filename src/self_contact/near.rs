//! The list of parts of a sheet that may meet: pairs of quads, found once in a frame or more often. A sheet that hardly moves keeps its list for some frames.

use crate::grid::{Grid, Node};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;

use super::Law;
use super::extent::{Bounds, Extent};
use super::sweep::{Sweep, spread};
use super::tiling::{Patch, TILE, Tiling};

/// The largest difference of velocities times the time for which a list is made, cells. The time is a frame, or less for faster particles.
const FAR: f64 = 2.0;

/// The distance by which particles may approach each other beyond that before the list is made again, coarse: a sixteenth of a cell.
const SKIN: i32 = 16;

/// Two tiles, and their pairs of quads that are near each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pair {
    pub(super) tiles: [u8; 2],
    /// Bit 4·a + b: quad a of the first tile and quad b of the second.
    pub(super) quads: u16,
}

/// The pairs of tiles that are near each other, four bytes a particle, and two bytes a particle for bounds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near<const W: usize, const H: usize> {
    bounds: Grid<i16, W, H>,
    pairs: Grid<Pair, W, H>,
    count: u16,
    /// The first pair of tiles for which the list had no space.
    beyond: Option<[u8; 2]>,
    /// The last substep for which the list is valid.
    last: u32,
    /// The distance by which particles may still approach each other, coarse.
    skin: i32,
    /// The largest number of pairs of particles in contact at once in this frame.
    pub(crate) contacts: u32,
}

/// The list, without the size of the grid in its type.
#[derive(Clone, Copy, Debug)]
pub(super) struct List<'a> {
    pub(super) pairs: &'a [Pair],
    pub(super) beyond: Option<[u8; 2]>,
}

impl List<'_> {
    pub(super) fn is_empty(&self) -> bool {
        self.pairs.is_empty() && self.beyond.is_none()
    }
}

impl<const W: usize, const H: usize> Near<W, H> {
    pub(crate) const NONE: Self = Self {
        bounds: Grid::filled(0),
        pairs: Grid::filled(Pair { tiles: [0; 2], quads: 0 }),
        count: 0,
        beyond: None,
        last: 0,
        skin: 0,
        contacts: 0,
    };

    pub(super) fn list(&self) -> List<'_> {
        let pairs = self.pairs.as_slice().get(..usize::from(self.count)).unwrap_or_default();
        List { pairs, beyond: self.beyond }
    }

    /// Makes the list again if it is not valid for a substep.
    #[inline]
    pub(super) fn follow<S: Scalar>(&mut self, particles: &Particles<S, W, H>, law: &Law<S>, moment: Moment) {
        if moment.substep == 1 {
            self.contacts = 0;
        } else if moment.substep <= self.last {
            return;
        }
        let spread = spread(particles);
        if moment.substep == 1 {
            self.skin = self.skin.saturating_sub(spread.coarse().saturating_add(1));
            if self.skin > 0 {
                self.last = moment.substeps;
                return;
            }
        }
        let halvings = halvings(spread, moment.substeps);
        self.last = moment.substep + (moment.substeps >> halvings).max(1) - 1;
        self.skin = if self.last >= moment.substeps { SKIN } else { 0 };
        self.renew(particles, law, spread, halvings);
    }

    #[inline(never)] // one copy for all solvers
    fn renew<S: Scalar>(&mut self, particles: &Particles<S, W, H>, law: &Law<S>, spread: S, halvings: u32) {
        let watch = law.watch(spread) + SKIN;
        (self.count, self.beyond) = (0, None);
        let sweep = Sweep::new(particles, halvings);
        let origin = sweep.place(Node { column: 0, row: 0 }).low;
        let mut single = [[0; TILE]];
        let tiles = if Tiling::<W, H>::NUMBER == 1 {
            &mut single[..]
        } else {
            self.bounds.0.as_flattened_mut().as_chunks_mut::<TILE>().0
        };
        for row in 0..Tiling::<W, H>::DOWN {
            sweep.tiles(row, |tile, axis, spans| {
                if let Some(packed) = tiles.get_mut(tile) {
                    Bounds::pack(packed, axis, spans, origin, shift::<W, H>());
                }
            });
        }
        let tiles = tiles.get(..Tiling::<W, H>::NUMBER).unwrap_or_default();
        let all = tiles.iter().fold(Bounds::EMPTY, |all, tile| all.and(&Bounds::unpacked(tile)));
        if law.flatness.is_flat(watch, &all.edges) {
            return;
        }
        let flat = flat_blocks::<S, W, H>(tiles, law, watch);
        let search = Search { sweep, tiles, law, watch, flat };
        let pairs = self.pairs.0.as_flattened_mut();
        let capacity = law.capacity;
        let mut count = 0;
        let mut beyond = None;
        search.pairs(|pair| {
            let place = pairs.get_mut(count).filter(|_| count < capacity);
            if let Some(place) = place {
                *place = pair;
                count += 1;
                return true;
            }
            beyond = Some(pair.tiles);
            false
        });
        (self.count, self.beyond) = (count as u16, beyond);
    }
}

/// The number of halvings of a tick after which velocities differ by at most [`FAR`] in it; no more than there are substeps.
fn halvings<S: Scalar>(spread: S, substeps: u32) -> u32 {
    let mut halvings = 0;
    while spread.halve(halvings) > S::from_f64(FAR) && substeps >> halvings > 1 {
        halvings += 1;
    }
    halvings
}

/// A search for pairs of tiles.
struct Search<'a, S: Scalar, const W: usize, const H: usize> {
    sweep: Sweep<'a, S, W, H>,
    tiles: &'a [[i16; TILE]],
    law: &'a Law<S>,
    /// The distance from which on boxes are not near.
    watch: i32,
    flat: [u32; 8],
}

/// A bit for each tile: whether the block of two by two tiles that starts with it is flat.
fn flat_blocks<S: Scalar, const W: usize, const H: usize>(tiles: &[[i16; TILE]], law: &Law<S>, watch: i32) -> [u32; 8] {
    let (across, down) = (Tiling::<W, H>::ACROSS, Tiling::<W, H>::DOWN);
    let mut flat = [0; 8];
    for row in 0..down {
        for column in 0..across {
            let mut block = Bounds::EMPTY;
            for lower in [row, (row + 1).min(down - 1)] {
                for right in [column, (column + 1).min(across - 1)] {
                    block = block.and(&tiles.get(lower * across + right).map_or(Bounds::EMPTY, Bounds::unpacked));
                }
            }
            if law.flatness.is_flat(watch, &block.edges) {
                let tile = row * across + column;
                flat[tile / 32 % 8] |= 1 << (tile % 32);
            }
        }
    }
    flat
}

/// Calls `visit` with the pairs of tiles of a grid, always in this order, until it returns false.
pub(super) fn each_pair<const W: usize, const H: usize>(mut visit: impl FnMut(usize, usize) -> bool) {
    let across = Tiling::<W, H>::ACROSS;
    for row in 0..Tiling::<W, H>::DOWN {
        for a in 0..(row + 1) * across {
            for b in a.max(row * across)..(row + 1) * across {
                if !visit(a, b) {
                    return;
                }
            }
        }
    }
}

/// The shift by which the places of tiles are coarser on a large grid, so that a sheet stretched to twice its length fits 16 bits.
const fn shift<const W: usize, const H: usize>() -> u32 {
    let side = if W > H { W } else { H };
    let most = (2 * side).next_power_of_two() as u32;
    if most > 128 { most.ilog2() - 7 } else { 0 }
}

impl<S: Scalar, const W: usize, const H: usize> Search<'_, S, W, H> {
    /// Calls `found` with pairs of tiles that are near each other until it returns false.
    fn pairs(&self, mut found: impl FnMut(Pair) -> bool) {
        let across = Tiling::<W, H>::ACROSS;
        let reach = (self.watch >> shift::<W, H>()) + 1;
        let (mut of_row, mut row) = (Extent::EMPTY, usize::MAX);
        let (mut of_tile, mut tile) = (Extent::EMPTY, usize::MAX);
        let mut row_is_near = false;
        let mut ways = None;
        each_pair::<W, H>(|a, b| {
            if b / across != row {
                row = b / across;
                tile = usize::MAX;
                of_row = (row * across..(row + 1) * across).fold(Extent::EMPTY, |all, tile| all.and(self.places(tile)));
            }
            if a != tile {
                tile = a;
                of_tile = self.places(a);
                row_is_near = of_tile.is_near(&of_row, reach);
                ways = None;
            }
            if !row_is_near {
                return true;
            }
            let near =
                if Tiling::<W, H>::touch(a, b) { !self.is_flat(a, b) } else { of_tile.is_near(&self.places(b), reach) };
            if near {
                let quads = self.near_quads(ways.get_or_insert_with(|| self.ways(a)), [a, b]);
                return quads == 0 || found(Pair { tiles: [a as u8, b as u8], quads });
            }
            true
        });
    }

    fn places(&self, tile: usize) -> Extent {
        self.tiles.get(tile).map_or(Extent::EMPTY, |packed| Bounds::unpacked(packed).places)
    }

    /// Whether two tiles that touch lie in a block that is flat.
    fn is_flat(&self, a: usize, b: usize) -> bool {
        let across = Tiling::<W, H>::ACROSS;
        let corner = a / across * across + (a % across).min(b % across);
        self.flat[corner / 32 % 8] >> (corner % 32) & 1 == 1
    }

    /// The boxes of a tile's quads, and of their particles.
    fn ways(&self, tile: usize) -> [Ways; 4] {
        [0, 1, 2, 3].map(|quad| Ways::new(self.sweep, Tiling::<W, H>::quad(tile, quad)))
    }

    /// The pairs of quads of two tiles that are near each other, as [`Pair::quads`].
    fn near_quads(&self, of_a: &[Ways; 4], [a, b]: [usize; 2]) -> u16 {
        let of_b = if a == b { None } else { Some(self.ways(b)) };
        let mut near = 0;
        for (i, first) in of_a.iter().enumerate() {
            for (j, second) in of_b.as_ref().unwrap_or(of_a).iter().enumerate() {
                if (a == b && j < i) || !first.all.is_near(&second.all, self.watch) {
                    continue;
                }
                if !first.is_beside(second) || self.have_a_pair(first, second) {
                    near |= 1 << (4 * i + j);
                }
            }
        }
        near
    }

    /// Whether two quads have particles that are near each other, but not neighbours.
    fn have_a_pair(&self, a: &Ways, b: &Ways) -> bool {
        for (index, i) in a.patch.nodes().enumerate() {
            for (other, j) in b.patch.nodes().enumerate() {
                if !self.law.joins(i, j)
                    && a.way(index, i, self.sweep).is_near(&b.way(other, j, self.sweep), self.watch)
                {
                    return true;
                }
            }
        }
        false
    }
}

/// The boxes around the ways of a quad's particles.
struct Ways {
    patch: Patch,
    /// The box around all of them; empty, and near no box, if the patch has no particle.
    all: Extent,
    /// The boxes of the first four.
    first: [Extent; 4],
}

impl Ways {
    fn new<S: Scalar, const W: usize, const H: usize>(sweep: Sweep<'_, S, W, H>, patch: Patch) -> Self {
        let (mut all, mut first) = (Extent::EMPTY, [Extent::EMPTY; 4]);
        for (index, node) in patch.nodes().enumerate() {
            let place = sweep.place(node);
            all = all.and(place);
            if let Some(kept) = first.get_mut(index) {
                *kept = place;
            }
        }
        Self { patch, all, first }
    }

    /// The box of one of them.
    fn way<S: Scalar, const W: usize, const H: usize>(
        &self,
        index: usize,
        node: Node,
        sweep: Sweep<'_, S, W, H>,
    ) -> Extent {
        if index < self.first.len() { self.first[index] } else { sweep.place(node) }
    }

    /// Whether two quads are the same, or side by side or corner to corner in the sheet: then their boxes are always near.
    fn is_beside(&self, other: &Self) -> bool {
        let (a, b) = (&self.patch, &other.patch);
        a.columns.start <= b.columns.end
            && b.columns.start <= a.columns.end
            && a.rows.start <= b.rows.end
            && b.rows.start <= a.rows.end
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloth::Cloth;
    use crate::self_contact::Thickness;
    use crate::units::Units;
    use crate::vec3::Vec3;

    const SIDE: usize = 12;

    /// A moving sheet that is bent, sheared and crumpled, with an amplitude that grows over 16 seeds.
    fn patch(units: &Units, seed: u32) -> Cloth<f64, SIDE, SIDE> {
        let mut cloth = Cloth::<f64, SIDE, SIDE>::lay(units, units.point([0.0; 3]));
        let number = |k: u32| f64::from((seed * 7919 + k).wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 24) - 0.5;
        let wild = 0.4 * f64::from(seed % 16) / 16.0;
        for (k, node) in Grid::<f64, SIDE, SIDE>::nodes().enumerate() {
            let k = k as u32;
            let [x, y, _] = cloth.position.at(node).to_f64();
            let wave = 2.0 * wild * (number(1) * x + number(2) * y).sin() * 4.0;
            let crumple = [0, 1, 2].map(|axis| wild * number(10 + 3 * k + axis));
            let place = [x + wild * number(3) * y + crumple[0], y + crumple[1], wave + crumple[2]];
            cloth.position.set(node, Vec3::from_f64(place));
            cloth.velocity.set(node, Vec3::from_f64([4, 5, 6].map(|axis| wild * number(1000 + axis * 200 + k))));
        }
        cloth
    }

    #[test]
    fn no_pair_in_reach_is_in_a_flat_patch() {
        let units = Units::sheet([SIDE, SIDE], [1.1, 0.9], 1.0, 0.1, 4);
        let law = Law::<f64>::new(Thickness::new(&units, units.cell), 0.0);
        let mut flat = 0;
        for seed in 0..400 {
            let cloth = patch(&units, seed);
            let sweep = Sweep::new(&cloth, 0);
            let mut tiles = [[0; TILE]; Tiling::<SIDE, SIDE>::NUMBER];
            for row in 0..Tiling::<SIDE, SIDE>::DOWN {
                sweep.tiles(row, |tile, axis, spans| Bounds::pack(&mut tiles[tile], axis, spans, [0; 3], 0));
            }
            let all = tiles.iter().fold(Bounds::EMPTY, |all, tile| all.and(&Bounds::unpacked(tile)));
            if !law.flatness.is_flat(law.coarse, &all.edges) {
                continue;
            }
            flat += 1;
            for time in [0.0, 0.5, 1.0] {
                let at = |node| cloth.position.at(node) + cloth.velocity.at(node) * time;
                for i in Grid::<f64, SIDE, SIDE>::nodes() {
                    for j in Grid::<f64, SIDE, SIDE>::nodes().filter(|&j| j > i && !law.joins(i, j)) {
                        let distance = (at(i) - at(j)).length();
                        assert!(distance >= 1.0, "{i:?} and {j:?} are {distance} apart in {seed}");
                    }
                }
            }
        }
        assert!((40..360).contains(&flat), "{flat} patches are flat");
    }

    #[test]
    fn the_fast_have_their_list_renewed_more_often() {
        assert_eq!([0.5, 2.0, 2.1, 9.0].map(|spread: f64| halvings(spread, 16)), [0, 0, 1, 3]);
        assert_eq!(halvings(1e9_f64, 16), 4);
        assert_eq!(halvings(1e9_f64, 1), 0);
    }
}

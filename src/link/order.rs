//! The order in which the links of a family are visited.

use super::Family;
use crate::grid::Node;
use crate::scalar::Scalar;

/// Calls `visit` with both ends of every link of offset `ACROSS`, `DOWN` in a sheet of `W` × `H` particles; if neither is zero, of both diagonals of the box.
///
/// Links are coloured: links of one colour share no particle. So a mirrored sheet of even width is relaxed as the mirror image, in floats to the last bit.
/// Sweeps from left to right would lean to one side.
#[inline]
pub fn each<const ACROSS: usize, const DOWN: usize, const W: usize, const H: usize>(visit: impl FnMut(Node, Node)) {
    Known::<ACROSS, DOWN>.each::<W, H>(visit);
}

/// The links of a family in the order of [`each`].
pub(crate) trait Order: Copy {
    /// The distance between the ends of a link, in columns and rows.
    fn offset(self) -> [usize; 2];

    /// Calls `visit` in the order of [`each`].
    fn each<const W: usize, const H: usize>(self, visit: impl FnMut(Node, Node));
}

/// An operation on the links of any family.
pub(crate) trait OneByOne<S: Scalar> {
    fn links(&mut self, family: &Family<S>, order: impl Order);
}

/// Applies `visitor` to a family. A board has one grid, and each family gets its own code with offsets known to the compiler: a third faster for leapfrog on a
/// Cortex-M3 than common code for all families. Programs with scene files (`std`) have dozens of grids and compile common code.
#[inline(always)]
pub(crate) fn one_by_one<S: Scalar, const ACROSS: usize, const DOWN: usize>(
    visitor: &mut impl OneByOne<S>,
    family: &Family<S>,
) {
    if cfg!(feature = "std") {
        for_all_families(visitor, family, Offset { across: ACROSS, down: DOWN });
    } else {
        visitor.links(family, Known::<ACROSS, DOWN>);
    }
}

#[inline(never)]
fn for_all_families<S: Scalar>(visitor: &mut impl OneByOne<S>, family: &Family<S>, offset: Offset) {
    visitor.links(family, offset);
}

/// An offset known at compile time.
#[derive(Clone, Copy)]
struct Known<const ACROSS: usize, const DOWN: usize>;

impl<const ACROSS: usize, const DOWN: usize> Order for Known<ACROSS, DOWN> {
    #[inline(always)]
    fn offset(self) -> [usize; 2] {
        [ACROSS, DOWN]
    }

    #[inline(always)]
    fn each<const W: usize, const H: usize>(self, mut visit: impl FnMut(Node, Node)) {
        each_row::<DOWN, H>(|row| {
            in_row::<ACROSS, DOWN, W>(|a, b| {
                visit(Node { column: a, row }, Node { column: b, row: row + DOWN });
            });
        });
    }
}

/// An offset known at run time.
#[derive(Clone, Copy)]
struct Offset {
    across: usize,
    down: usize,
}

impl Order for Offset {
    #[inline(always)]
    fn offset(self) -> [usize; 2] {
        [self.across, self.down]
    }

    #[inline(always)]
    fn each<const W: usize, const H: usize>(self, mut visit: impl FnMut(Node, Node)) {
        let diagonals = if self.across > 0 && self.down > 0 { 2 } else { 1 };
        in_colours(self.down, H, |row, below| {
            in_colours(self.across, W, |column, right| {
                for diagonal in 0..diagonals {
                    let (a, b) = if diagonal == 0 { (column, right) } else { (right, column) };
                    // checked after the choice, too, so that the compiler removes bounds checks
                    if a < W && b < W {
                        visit(Node { column: a, row }, Node { column: b, row: below });
                    }
                }
            });
        });
    }
}

/// Calls `visit` with both ends of every link of this extent in a line of `count` particles. Blocks of `extent` links alternate between two colours.
#[inline(always)]
fn in_colours(extent: usize, count: usize, mut visit: impl FnMut(usize, usize)) {
    let (block, colours) = if extent == 0 { (count, 1) } else { (extent, 2) };
    for colour in 0..colours {
        let mut start = colour * block;
        while start < count {
            for first in start..start + block {
                let second = first + extent;
                // both are checked, so that the compiler removes bounds checks
                if first < count && second < count {
                    visit(first, second);
                }
            }
            start += 2 * block;
        }
    }
}

/// Whether a sheet of `W` × `H` particles has links of this offset.
pub(crate) const fn fits<const ACROSS: usize, const DOWN: usize, const W: usize, const H: usize>() -> bool {
    ACROSS < W && DOWN < H
}

/// Calls `visit` with every row in which links of extent `DOWN` start. Rows whose links share a particle have different colours; one colour follows the other.
#[inline(always)]
pub(crate) fn each_row<const DOWN: usize, const H: usize>(mut visit: impl FnMut(usize)) {
    for colour in 0..colours(DOWN) {
        coloured::<DOWN>(colour, H, &mut visit);
    }
}

/// Calls `visit` with the columns of both ends of the links that start in a row.
#[inline(always)]
pub(crate) fn in_row<const ACROSS: usize, const DOWN: usize, const W: usize>(mut visit: impl FnMut(usize, usize)) {
    const { assert!(ACROSS + DOWN > 0, "a link needs two particles") };
    let sides: &[bool] = if ACROSS > 0 && DOWN > 0 { &[false, true] } else { &[false] };
    for colour in 0..colours(ACROSS) {
        coloured::<ACROSS>(colour, W, |column| {
            // one call for both diagonals, so that it is inlined and its bounds are known
            for &mirrored in sides {
                let (a, b) = if mirrored { (column + ACROSS, column) } else { (column, column + ACROSS) };
                visit(a, b);
            }
        });
    }
}

/// Calls `visit` with the first ends of the links of one colour and extent in a line of `count` particles: every other block of `EXTENT` links.
#[inline(always)]
fn coloured<const EXTENT: usize>(colour: usize, count: usize, mut visit: impl FnMut(usize)) {
    if EXTENT == 0 {
        (0..count).for_each(visit);
        return;
    }
    let end = count.saturating_sub(EXTENT);
    let mut start = colour * EXTENT;
    while start < end {
        for k in 0..EXTENT {
            if start + k < end {
                visit(start + k);
            }
        }
        start += 2 * EXTENT;
    }
}

const fn colours(extent: usize) -> usize {
    if extent == 0 { 1 } else { 2 }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::collections::BTreeSet;
    use std::vec::Vec;

    fn links<const ACROSS: usize, const DOWN: usize>() -> Vec<(Node, Node)> {
        let mut links = Vec::new();
        each::<ACROSS, DOWN, 8, 5>(|a, b| links.push((a, b)));
        links
    }

    #[test]
    fn an_offset_that_is_known_later_is_visited_in_the_same_order() {
        fn check<const ACROSS: usize, const DOWN: usize>() {
            let (mut now, mut later) = (Vec::new(), Vec::new());
            each::<ACROSS, DOWN, 8, 5>(|a, b| now.push((a, b)));
            Offset { across: ACROSS, down: DOWN }.each::<8, 5>(|a, b| later.push((a, b)));
            assert_eq!(now, later, "{ACROSS}, {DOWN}");
        }
        check::<1, 0>();
        check::<0, 1>();
        check::<1, 1>();
        check::<2, 0>();
        check::<0, 2>();
        check::<3, 2>();
    }

    #[test]
    fn every_link_is_visited_once() {
        for (found, count) in [
            (links::<1, 0>(), 7 * 5),
            (links::<0, 1>(), 8 * 4),
            (links::<1, 1>(), 2 * 7 * 4),
            (links::<2, 0>(), 6 * 5),
            (links::<0, 2>(), 8 * 3),
        ] {
            assert_eq!(found.len(), count);
            assert_eq!(found.iter().collect::<BTreeSet<_>>().len(), count);
        }
    }

    #[test]
    fn a_mirrored_sheet_has_the_mirrored_order() {
        fn mirrored(found: &[(Node, Node)]) -> BTreeSet<[(usize, usize); 2]> {
            found
                .iter()
                .map(|(a, b)| {
                    let mut ends = [(7 - a.column, a.row), (7 - b.column, b.row)];
                    ends.sort_unstable();
                    ends
                })
                .collect()
        }
        fn plain(found: &[(Node, Node)]) -> BTreeSet<[(usize, usize); 2]> {
            found
                .iter()
                .map(|(a, b)| {
                    let mut ends = [(a.column, a.row), (b.column, b.row)];
                    ends.sort_unstable();
                    ends
                })
                .collect()
        }
        // colour by colour: a colour ends where a particle occurs a second time
        for found in [links::<1, 0>(), links::<1, 1>(), links::<2, 0>()] {
            let mut start = 0;
            while start < found.len() {
                let mut seen = BTreeSet::new();
                let mut end = start;
                while end < found.len() && seen.insert(found[end].0) && seen.insert(found[end].1) {
                    end += 1;
                }
                assert_eq!(plain(&found[start..end]), mirrored(&found[start..end]));
                start = end;
            }
        }
    }
}

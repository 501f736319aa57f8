//! The places of chains on a grid.

/// The place of a chain: it starts in row `top` and column `first`, and has a particle in each of `count` rows, `slant` columns further in each.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) top: usize,
    pub(super) first: usize,
    pub(super) count: usize,
    pub(super) slant: isize,
}

impl Place {
    /// The row of the chain's particle `k`; limited to the grid, so that the compiler leaves out bounds checks.
    #[inline(always)]
    pub(super) fn row<const H: usize>(self, k: usize) -> usize {
        (self.top + k).min(H - 1)
    }

    /// The column of the chain's particle `k`, likewise; `N` chains lie side by side.
    #[inline(always)]
    pub(super) fn column<const N: usize, const W: usize>(self, k: usize) -> usize {
        self.first.wrapping_add_signed(self.slant * k as isize).min(W.saturating_sub(N))
    }
}

/// Visits every diagonal of two or more particles through the cells of one colour.
pub(super) fn each_diagonal<const W: usize, const H: usize>(colour: usize, mut visit: impl FnMut(Place)) {
    // those that start at the upper border, then at the left and at the right one
    for start in 0..W + 2 * (H - 1) {
        let (first, top) = if start < W {
            (start, 0)
        } else if start < W + H - 1 {
            (0, start - W + 1)
        } else {
            (W - 1, start + 2 - W - H)
        };
        for slant in [1, -1] {
            let room = if slant > 0 { W - 1 - first } else { first };
            let count = 1 + room.min(H - 1 - top);
            // the column of the first cell's left side, plus its row
            let cell = if slant > 0 { first + top } else { first + top + 1 };
            if count > 1 && cell % 2 == colour {
                visit(Place { top, first, count, slant });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_diagonal_is_visited_once() {
        fn check<const W: usize, const H: usize>() {
            let mut visits = [[[0; W]; H]; 2];
            for colour in 0..2 {
                each_diagonal::<W, H>(colour, |place| {
                    for k in 0..place.count - 1 {
                        visits[usize::from(place.slant > 0)][place.top + k][place.column::<1, W>(k)] += 1;
                    }
                });
            }
            for (slant, row, column) in (0..2).flat_map(|s| (0..H).flat_map(move |r| (0..W).map(move |c| (s, r, c)))) {
                let is_there = row + 1 < H && if slant == 1 { column + 1 < W } else { column > 0 };
                assert_eq!(visits[slant][row][column], u32::from(is_there), "{slant} {row} {column} of {W} × {H}");
            }
        }
        check::<5, 8>();
        check::<8, 5>();
        check::<2, 2>();
        check::<1, 3>();
        check::<3, 1>();
    }
}

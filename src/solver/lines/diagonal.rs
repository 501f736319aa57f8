//! Every diagonal of the cells solved exactly, as rows and columns are.
//!
//! Relaxed one by one between exact rows and columns, diagonals are what sweeps wait for. A falling diagonal and a rising one share a particle, so one of them has to act on
//! what the other left. In the order "all falling ones, then all rising ones" a mirrored sheet would not move as the mirror image. Instead cells are coloured as a chess
//! board is: the diagonals through black cells share no particle with one another, and those through white ones don't either. So both kinds of one colour are solved at
//! once, then those of the other; for even widths a mirror maps each colour to itself.
//!
//! A multiplier is kept in the grid of its cell's colour, at the link's upper particle. In every row the links of a colour join neighbours in pairs to the pair below, crosswise:
//! a row's partners are the row below with the two of each pair [swapped]. Machines that compute several numbers at once eliminate down the rows, all diagonals side
//! by side; others take one diagonal after the other, which needs no grids to work in.

use crate::grid::Grid;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

use super::chain::{Chain, Eliminated, Place, skips_masses, yielding};
use super::displace_row;
use super::heavy::Heavy;

impl<S: Scalar, const W: usize, const H: usize> Chain<'_, S, W, H> {
    /// Solves every diagonal. Returns the largest residual of those that were held back, which are far from solved.
    #[inline(never)] // one for all scenes of a grid
    pub(super) fn diagonals(&self, particles: &mut Particles<S, W, H>, tension: [&mut Grid<S, W, H>; 2]) -> S {
        let mut unsolved = S::ZERO;
        if W > 1 && H > 1 {
            for (colour, tension) in tension.into_iter().enumerate() {
                if const { skips_masses::<S>() } {
                    unsolved = unsolved.max(self.diagonals_one_by_one(particles, colour, tension));
                } else {
                    self.diagonals_at_once(particles, colour, tension);
                }
            }
        }
        unsolved
    }

    /// Solves the diagonals of one colour, in floats.
    #[inline(never)] // so that sheet and multipliers are known to be apart
    fn diagonals_at_once(&self, particles: &mut Particles<S, W, H>, colour: usize, tension: &mut Grid<S, W, H>) {
        let (dividend, divisor) = (self.strength.dividend, self.strength.divisor);
        let own = yielding(dividend);
        let mut normals = [Vec3::<[S; W]>::row(Vec3::ZERO); H];
        let [mut factors, mut changes] = [[[S::ZERO; W]; H]; 2];
        let mut pivots = [S::ZERO; W];
        let mut rights = [S::ZERO; W];
        let mut before = Vec3::<[S; W]>::row(Vec3::ZERO);
        for row in 0..H - 1 {
            let parity = (row + colour) % 2;
            let x = &particles.position.0[row];
            let y = particles.position.0[row + 1].components(|y| swapped(y, parity));
            let u = &particles.inverse_mass.0[row];
            let v = swapped(&particles.inverse_mass.0[row + 1], parity);
            let (tension, normals, changes) = (&tension.0[row], &mut normals[row], &mut changes[row]);
            for lane in 0..W {
                let (excess, normal) = (y.at(lane) - x.at(lane)).direction(self.rest);
                changes[lane] = excess - self.strength.times_divisor(tension[lane]);
                normals.set(lane, normal);
            }
            for lane in alone::<W>(parity) {
                normals.set(lane, Vec3::ZERO);
                changes[lane] = S::ZERO;
            }
            for lane in 0..W {
                let coupling = before.at(lane).cosine(normals.at(lane)).scaled(dividend) * u[lane];
                let diagonal = (u[lane] + v[lane]) * own + divisor;
                let above = Eliminated { pivot: pivots[lane], right: rights[lane] };
                let (next, factor) = above.next::<false>(diagonal, coupling, changes[lane]);
                (pivots[lane], rights[lane]) = (next.pivot, next.right);
                factors[row][lane] = factor;
                changes[lane] = next.right;
            }
            // in the next row a link goes on from where the one above it ends
            (pivots, rights) = (swapped(&pivots, parity), swapped(&rights, parity));
            before = normals.components(|normal| swapped(normal, parity));
        }
        let [mut change, mut most] = [[S::ZERO; W]; 2];
        let mut below = Vec3::<[S; W]>::row(Vec3::ZERO);
        for row in (0..H).rev() {
            let mut pull = Vec3::<[S; W]>::row(Vec3::ZERO);
            if row > 0 {
                let parity = (row - 1 + colour) % 2;
                for lane in 0..W {
                    change[lane] = change[lane] * factors[row][lane];
                }
                change = swapped(&change, parity);
                let (tension, normals, changes) =
                    (&mut tension.0[row - 1], &normals[row - 1], &mut changes[row - 1]);
                for lane in 0..W {
                    change[lane] = changes[lane] + change[lane];
                    changes[lane] = change[lane];
                    most[lane] = most[lane].max(change[lane]);
                    tension[lane] = tension[lane] + change[lane];
                    pull.set(
                        lane,
                        normals.at(lane).of_length(self.strength.times_dividend(change[lane]), self.rounding),
                    );
                }
                let above = pull.components(|pull| swapped(pull, parity));
                let w = particles.inverse_mass.0[row];
                displace_row(particles, row, |lane| (below.at(lane) - above.at(lane)) * w[lane], self.moment);
            } else {
                let w = particles.inverse_mass.0[row];
                displace_row(particles, row, |lane| below.at(lane) * w[lane], self.moment);
            }
            below = pull;
        }
        let most = most.iter().fold(S::ZERO, |most, lane| most.max(*lane));
        if self.is_taut(most, Heavy::NONE) {
            self.ease_diagonals(particles, colour, &normals, &changes);
        }
    }

    /// Eases those diagonals of one colour that are taut, whose links have these directions and changes of multipliers.
    #[inline(never)] // few are that taut
    fn ease_diagonals(
        &self,
        particles: &mut Particles<S, W, H>,
        colour: usize,
        normals: &[Vec3<[S; W]>; H],
        changes: &[[S; W]; H],
    ) {
        each_diagonal::<W, H>(colour, |place| {
            let mut normal: Vec3<[S; H]> = Vec3::row(Vec3::ZERO);
            let mut change = [S::ZERO; H];
            let mut most = S::ZERO;
            for k in 0..place.count - 1 {
                let (row, column) = (place.top + k, place.column(k));
                normal.set(k, normals[row].at(column));
                change[k] = changes[row][column];
                most = most.max(change[k]);
            }
            if self.is_taut(most, Heavy::NONE) {
                self.ease(particles, place, 0, (&normal, &change), Heavy::NONE);
            }
        });
    }
}

/// Visits every diagonal through the cells of one colour, those of two particles and more.
pub(super) fn each_diagonal<const W: usize, const H: usize>(colour: usize, mut visit: impl FnMut(Place)) {
    // from the upper border, then from the left one and from the right one
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
            // by the column of the first cell's left side
            let cell = if slant > 0 { first + top } else { first + top + 1 };
            if count > 1 && cell % 2 == colour {
                visit(Place { top, first, count, slant });
            }
        }
    }
}

/// The row with neighbours swapped in pairs, the first of which starts in column `parity`.
#[inline(always)]
fn swapped<S: Copy, const W: usize>(row: &[S; W], parity: usize) -> [S; W] {
    let mut swapped = *row;
    if parity == 0 {
        swap_pairs(&mut swapped);
    } else {
        swap_pairs(&mut swapped[1..]);
    }
    swapped
}

#[inline(always)]
fn swap_pairs<S: Copy>(row: &mut [S]) {
    for pair in row.chunks_exact_mut(2) {
        pair.swap(0, 1);
    }
}

/// The columns that belong to no pair.
#[inline(always)]
fn alone<const W: usize>(parity: usize) -> impl Iterator<Item = usize> {
    let first = (parity == 1).then_some(0);
    let last = ((W - parity) % 2 == 1).then_some(W - 1);
    first.into_iter().chain(last)
}

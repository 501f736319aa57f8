//! Exact solves of rows, one after the other. All stages of a row except the elimination compute many links at once.
//!
//! A row is eliminated from both ends to its middle, so that a mirrored sheet of even width is solved as the mirror image, to the last bit in floats.

use crate::grid::Grid;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::aside::displace_row;
use crate::vec3::Vec3;
use crate::vectors::{ahead, behind, columns};

use super::chain::{Chain, skips_masses};
use super::exponent::Exponent;
use super::geometric_stiffness::geometric_stiffness;
use super::regularise::regularisation;
use super::tridiagonal::twisted;

/// A row of links, indexed by their left particles.
struct Row<S, const W: usize> {
    normal: Vec3<[S; W]>,
    /// The residual to be solved: excess length − divisor·multiplier, where the multiplier is that of the last sweep, or zero in the first sweep.
    residual: [S; W],
    /// The same with the last multiplier in any case, in the first sweep that of the substep before. It is the excess length that spring forces don't balance.
    unsolved: [S; W],
}

/// The matrix of a row.
struct Coefficients<S, const W: usize> {
    diagonal: [S; W],
    /// The coupling of each link with the next one.
    coupling: [S; W],
}

impl<S: Scalar, const W: usize, const H: usize> Chain<'_, S, W, H> {
    /// Solves every row; in the `first` sweep of a part of a substep, multipliers start at zero. Returns the largest unsolved excess length that it found.
    #[inline(never)] // one copy for all scenes of a grid
    pub(super) fn rows(&self, particles: &mut Particles<S, W, H>, multipliers: &mut Grid<S, W, H>, first: bool) -> S {
        let mut worst = S::ZERO;
        if W > 1 {
            for row in 0..H {
                if self.unit_mass.pinned[row] {
                    continue; // nothing moves, and strain between pins needs no further sweep
                }
                let multipliers = &mut multipliers.0[row];
                worst = worst.max(if const { skips_masses::<S>() } && self.unit_mass.rows[row] {
                    self.row::<true>(particles, row, multipliers, first)
                } else {
                    self.row::<false>(particles, row, multipliers, first)
                });
            }
        }
        worst
    }

    /// Solves a row. Returns the largest unsolved excess length that it found.
    #[inline(always)]
    fn row<const UNIT_MASS: bool>(
        &self,
        particles: &mut Particles<S, W, H>,
        row: usize,
        multipliers: &mut [S; W],
        first: bool,
    ) -> S {
        let exponent = self.exponent::<UNIT_MASS>();
        let w = particles.inverse_mass.0[row].map(|w| exponent.scaled(w));
        let mut links = Row { normal: Vec3::row(Vec3::ZERO), residual: [S::ZERO; W], unsolved: [S::ZERO; W] };
        self.gather(&mut links, &particles.position.0[row], multipliers, first, exponent);
        let found = largest(&links.unsolved);
        let worst = if first { largest(&links.residual) } else { found };
        let divisor = self.divisor::<UNIT_MASS, W>(worst, || regularisation(&links.residual, &w, W));
        let matrix = self.coefficients::<UNIT_MASS>(&links.normal, &w, divisor);
        let change: [S; W] =
            twisted::<UNIT_MASS, S, S, W>(|k| matrix.diagonal[k], |k| matrix.coupling[k], |k| links.residual[k]);
        self.pull_row::<UNIT_MASS>(particles, row, &links.normal, &change, &w, multipliers);
        let most = change.iter().fold(S::ZERO, |most, change| most.max(*change));
        if self.is_taut(most, exponent) {
            let tensions = change.map(|change| self.strength.times_dividend(change));
            let by = geometric_stiffness(&links.normal, &tensions, &w, W, self.rest.inverse, exponent);
            displace_row(particles, row, |k| by.at(k), self.moment);
        }
        found
    }

    /// Gathers the links between these particles into `links`: a returned row would be copied on a Cortex-M.
    #[inline(always)]
    fn gather(
        &self,
        links: &mut Row<S, W>,
        x: &Vec3<[S; W]>,
        multipliers: &mut [S; W],
        first: bool,
        exponent: Exponent,
    ) {
        let next = ahead::<1, S, W>(x);
        for k in columns::<1, 0, W>() {
            let (excess, along) = (next(k) - x.at(k)).direction(self.rest);
            links.unsolved[k] = excess - exponent.scaled(self.strength.times_divisor(multipliers[k]));
            links.residual[k] = if first { excess } else { links.unsolved[k] };
            links.normal.set(k, along);
        }
        (links.residual[W - 1], links.unsolved[W - 1]) = (S::ZERO, S::ZERO);
        if first {
            *multipliers = [S::ZERO; W];
        }
    }

    /// The matrix for links with these directions, between particles with these inverse masses.
    #[inline(always)]
    fn coefficients<const UNIT_MASS: bool>(&self, normal: &Vec3<[S; W]>, w: &[S; W], divisor: S) -> Coefficients<S, W> {
        let own = self.own();
        let mut matrix = Coefficients { diagonal: [own + own + divisor; W], coupling: [S::ZERO; W] };
        let next = ahead::<1, S, W>(normal);
        for k in columns::<2, 0, W>() {
            matrix.coupling[k] = self.strength.of_dividend(normal.at(k).cosine(next(k)));
        }
        if !UNIT_MASS {
            for k in 0..W {
                let (here, next) = (w[k], if k + 1 < W { w[k + 1] } else { S::ZERO });
                matrix.coupling[k] = matrix.coupling[k] * next;
                matrix.diagonal[k] = (here + next) * own + divisor;
            }
        }
        matrix
    }

    /// Adds the changes to the multipliers, and moves the particles of a row.
    #[inline(always)]
    fn pull_row<const UNIT_MASS: bool>(
        &self,
        particles: &mut Particles<S, W, H>,
        row: usize,
        normal: &Vec3<[S; W]>,
        change: &[S; W],
        w: &[S; W],
        multipliers: &mut [S; W],
    ) {
        let mut pull = Vec3::row(Vec3::ZERO);
        for k in 0..W {
            multipliers[k] = multipliers[k].difference(-change[k]); // does not wrap
            pull.set(k, normal.at(k).of_length(self.strength.times_dividend(change[k]), self.rounding));
        }
        let before = behind::<1, S, W>(&pull);
        let by = |k| {
            let by = pull.at(k) - before(k);
            if UNIT_MASS { by } else { by * w[k] }
        };
        displace_row(particles, row, by, self.moment);
    }
}

/// The largest magnitude.
#[inline(always)]
fn largest<S: Scalar, const W: usize>(residuals: &[S; W]) -> S {
    residuals.iter().fold(S::ZERO, |most, residual| most.max(residual.abs()))
}

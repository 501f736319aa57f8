//! Rows solved one after the other, all of a row but the elimination for many links at once.
//!
//! A row is eliminated from both its ends to its middle, so that a mirrored sheet of even width is solved as the mirror image, to the last bit in floats.

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

/// A row of links, at their left particles.
struct Row<S, const W: usize> {
    normal: Vec3<[S; W]>,
    /// The excess length of each but for what the multiplier accounts for from which it is solved: the last sweep's, or nothing in the first sweep.
    residual: [S; W],
    /// The same but for what the last multiplier accounts for, be it of the substep before: what is left unsolved, which springs don't hold.
    unsolved: [S; W],
}

/// The matrix of a row.
struct Coefficients<S, const W: usize> {
    diagonal: [S; W],
    /// Of each link with the next one.
    coupling: [S; W],
}

impl<S: Scalar, const W: usize, const H: usize> Chain<'_, S, W, H> {
    /// Solves every row, in the `first` sweep of a substep from nothing. Returns the largest excess length that it found and springs did not hold before.
    #[inline(never)] // one for all scenes of a grid
    pub(super) fn rows(&self, particles: &mut Particles<S, W, H>, multipliers: &mut Grid<S, W, H>, first: bool) -> S {
        let mut worst = S::ZERO;
        if W > 1 {
            for row in 0..H {
                if self.unit_mass.pinned[row] {
                    continue; // nor is what pins are strained by a reason to sweep on
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

    /// Solves a row.
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

    /// Gathers the links between these particles where they are used: what is returned is copied on a Cortex-M.
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

    /// The matrix of links with these directions between particles of these inverse masses.
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

    /// Adds to multipliers what they change by, and moves the particles of a row.
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

/// The largest of these, whatever its sign.
#[inline(always)]
fn largest<S: Scalar, const W: usize>(residuals: &[S; W]) -> S {
    residuals.iter().fold(S::ZERO, |most, residual| most.max(residual.abs()))
}

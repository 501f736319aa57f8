//! Links relaxed one by one, a row at a time.
//!
//! All links between two rows start from the same positions (Jacobi). So in floats a mirrored sheet is relaxed as the mirror image, to the last bit, and a machine may compute
//! four links at once. This does not overshoot: the two diagonals of a cell are nearly at right angles, and the few other links that share a particle lie in a row.

use core::ops::Range;

use crate::grid::Grid;
use crate::link::{Family, Quotient};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Rest, Rounding, Scalar};
use crate::solver::aside::displace_row;
use crate::vec3::Vec3;
use crate::vectors::{ahead, behind, columns, left, right};

use super::exponent::Exponent;

/// The links of one family, and the data that they share.
pub(super) struct Pairs<'a, S: Scalar, const H: usize> {
    rest: &'a Rest<S>,
    strength: Quotient<S>,
    /// The effective mass between two particles of mass 1, 1/(2·a + b).
    effective_mass: S,
    moment: Moment,
    rounding: Rounding,
    unit_mass: &'a [bool; H],
    exponent: Exponent,
}

impl<'a, S: Scalar, const H: usize> Pairs<'a, S, H> {
    pub(super) fn new(
        family: &'a Family<S>,
        strength: Quotient<S>,
        moment: Moment,
        rounding: Rounding,
        unit_mass: &'a [bool; H],
        exponent: Exponent,
    ) -> Self {
        let effective_mass = (strength.dividend + strength.dividend + strength.divisor).recip();
        Self { rest: &family.rest, strength, effective_mass, moment, rounding, unit_mass, exponent }
    }

    /// Relaxes links between particles that are `ACROSS` columns apart.
    #[inline(never)] // one copy for all scenes of a grid
    pub(super) fn row<const ACROSS: usize, const W: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        mut multipliers: Option<&mut Grid<S, W, H>>,
    ) {
        if W <= ACROSS {
            return;
        }
        let links = columns::<ACROSS, 0, W>();
        for row in 0..H {
            let (x, w) = (&particles.position.0[row], &particles.inverse_mass.0[row]);
            let mut none = [S::ZERO; W];
            let multipliers = multipliers.as_deref_mut().map_or(&mut none, |grid| &mut grid.0[row]);
            let effective_mass = self.effective_mass([row; 2], [w, w], left::<ACROSS, S, W>);
            let mut pull = Vec3::row(Vec3::ZERO);
            self.pull::<W>(&mut pull, links.clone(), x, ahead::<ACROSS, S, W>(x), &effective_mass, multipliers);
            without_last::<ACROSS, S, W>(&mut pull, multipliers);
            let before = behind::<ACROSS, S, W>(&pull);
            self.displace(particles, row, &effective_mass, |column| pull.at(column) - before(column));
        }
    }

    /// Relaxes links between particles that are `DOWN` rows apart.
    #[inline(never)] // one copy for all scenes of a grid
    pub(super) fn column<const DOWN: usize, const W: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        mut multipliers: Option<&mut Grid<S, W, H>>,
    ) {
        // from the top down: the links that end in a row are relaxed before those that start in it
        for row in 0..H.saturating_sub(DOWN) {
            let [x, y] = [row, row + DOWN].map(|row| &particles.position.0[row]);
            let [u, v] = [row, row + DOWN].map(|row| &particles.inverse_mass.0[row]);
            let mut none = [S::ZERO; W];
            let multipliers = multipliers.as_deref_mut().map_or(&mut none, |grid| &mut grid.0[row]);
            let effective_mass = self.effective_mass([row, row + DOWN], [u, v], |v| *v);
            let mut pull = Vec3::row(Vec3::ZERO);
            self.pull::<W>(&mut pull, 0..W, x, |column| y.at(column), &effective_mass, multipliers);
            self.displace(particles, row, &effective_mass, |column| pull.at(column));
            self.displace(particles, row + DOWN, &effective_mass, |column| -pull.at(column));
        }
    }

    /// Relaxes links along both diagonals.
    #[inline(never)] // one copy for all scenes of a grid
    pub(super) fn diagonals<const ACROSS: usize, const DOWN: usize, const W: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        mut multipliers: Option<[&mut Grid<S, W, H>; 2]>,
    ) {
        if W <= ACROSS {
            return;
        }
        for colour in 0..2 {
            let mut row = colour;
            while row + DOWN < H {
                let [x, y] = [row, row + DOWN].map(|row| &particles.position.0[row]);
                let [u, v] = [row, row + DOWN].map(|row| &particles.inverse_mass.0[row]);
                let mut none = [[S::ZERO; W]; 2];
                let [falling, rising] = match &mut multipliers {
                    Some([falling, rising]) => [&mut falling.0[row], &mut rising.0[row]],
                    None => none.each_mut(),
                };
                // to the right and down, to the left and down
                let links = columns::<ACROSS, 0, W>();
                let effective_mass = self.effective_mass([row, row + DOWN], [u, v], left::<ACROSS, S, W>);
                let [mut fall, mut rise] = [Vec3::row(Vec3::ZERO); 2];
                self.pull::<W>(&mut fall, links, x, ahead::<ACROSS, S, W>(y), &effective_mass, falling);
                without_last::<ACROSS, S, W>(&mut fall, falling);
                let links = columns::<0, ACROSS, W>();
                let effective_mass = self.effective_mass([row, row + DOWN], [u, v], right::<ACROSS, S, W>);
                self.pull::<W>(&mut rise, links, x, behind::<ACROSS, S, W>(y), &effective_mass, rising);
                without_first::<ACROSS, S, W>(&mut rise, rising);
                self.displace(particles, row, &effective_mass, |column| fall.at(column) + rise.at(column));
                let (fall, rise) = (behind::<ACROSS, S, W>(&fall), ahead::<ACROSS, S, W>(&rise));
                self.displace(particles, row + DOWN, &effective_mass, |column| -(fall(column) + rise(column)));
                row += 2;
            }
        }
    }

    /// The effective masses of the links between two rows with inverse masses `u` and `v`; `shifted` aligns the second row with the first.
    #[inline(always)]
    fn effective_mass<const W: usize>(
        &self,
        rows: [usize; 2],
        [u, v]: [&[S; W]; 2],
        shifted: impl Fn(&[S; W]) -> [S; W],
    ) -> EffectiveMass<S, W> {
        if rows.iter().all(|row| self.unit_mass[*row]) {
            return EffectiveMass::UnitMass(self.effective_mass);
        }
        let (Quotient { dividend, divisor }, exponent) = (self.strength, self.exponent);
        let mut divisors = shifted(v);
        for column in 0..W {
            let inverse_mass = exponent.scaled(u[column] + divisors[column]);
            let against = inverse_mass * dividend + exponent.scaled(divisor);
            // a link between two pins moves nothing
            let stuck = inverse_mass == S::ZERO;
            divisors[column] = if stuck { S::INFINITE_DIVISOR } else { against.divisor() };
        }
        EffectiveMass::Any(divisors)
    }

    /// Moves a row by `pull`, its displacements for mass 1 by links of such an effective mass, times its inverse masses.
    #[inline(always)]
    fn displace<const W: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        row: usize,
        effective_mass: &EffectiveMass<S, W>,
        pull: impl Fn(usize) -> Vec3<S>,
    ) {
        let exponent = if let EffectiveMass::Any(_) = effective_mass { self.exponent } else { Exponent::NONE };
        if self.unit_mass[row] && exponent == Exponent::NONE {
            displace_row(particles, row, pull, self.moment);
        } else {
            let w = particles.inverse_mass.0[row].map(|w| exponent.scaled(w));
            displace_row(particles, row, |column| pull(column) * w[column], self.moment);
        }
    }

    /// Finds the corrections `pull` of the links from one row to another, and adds to their multipliers. (A returned row would be copied on a Cortex-M.)
    #[inline(always)]
    fn pull<const W: usize>(
        &self,
        pull: &mut Vec3<[S; W]>,
        links: Range<usize>,
        x: &Vec3<[S; W]>,
        y: impl Fn(usize) -> Vec3<S>,
        effective_mass: &EffectiveMass<S, W>,
        multipliers: &mut [S; W],
    ) {
        let strength = self.strength;
        match effective_mass {
            &EffectiveMass::UnitMass(effective_mass) => {
                self.each(pull, links, x, y, multipliers, |_, multiplier, excess| {
                    (excess - strength.times_divisor(multiplier)).scaled(effective_mass)
                });
            }
            EffectiveMass::Any(divisors) => self.each(pull, links, x, y, multipliers, |column, multiplier, excess| {
                let missing = excess - self.exponent.scaled(strength.times_divisor(multiplier));
                missing.over(divisors[column])
            }),
        }
    }

    /// The same, where `change` gives the change of a multiplier from the link's column, its multiplier and its excess length.
    #[inline(always)]
    fn each<const W: usize>(
        &self,
        pull: &mut Vec3<[S; W]>,
        links: Range<usize>,
        x: &Vec3<[S; W]>,
        y: impl Fn(usize) -> Vec3<S>,
        multipliers: &mut [S; W],
        change: impl Fn(usize, S, S) -> S,
    ) {
        // no branches, so that a machine can compute four at once
        for column in links {
            let (excess, normal) = (y(column) - x.at(column)).direction(self.rest);
            let by = change(column, multipliers[column], excess);
            multipliers[column] += by;
            pull.set(column, normal.of_length(self.strength.times_dividend(by), self.rounding));
        }
    }
}

/// The effective masses 1/(a·Σw + b) of links, by which residuals are multiplied.
enum EffectiveMass<S, const W: usize> {
    /// The same for all links: all particles have mass 1.
    UnitMass(S),
    /// One for each link, as a [divisor](Scalar::divisor) of its residual.
    Any([S; W]),
}

/// Clears the last `BY < W` columns, in which no link starts.
#[inline(always)]
fn without_last<const BY: usize, S: Scalar, const W: usize>(pull: &mut Vec3<[S; W]>, multipliers: &mut [S; W]) {
    for column in W - BY..W {
        pull.set(column, Vec3::ZERO);
        multipliers[column] = S::ZERO;
    }
}

/// Clears the first `BY < W` columns, in which no link starts.
#[inline(always)]
fn without_first<const BY: usize, S: Scalar, const W: usize>(pull: &mut Vec3<[S; W]>, multipliers: &mut [S; W]) {
    for column in 0..BY {
        pull.set(column, Vec3::ZERO);
        multipliers[column] = S::ZERO;
    }
}

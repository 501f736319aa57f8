//! Links relaxed a row at a time.
//!
//! Links between one row and another act on the positions that all of them found (Jacobi), so that in floats a mirrored sheet is relaxed as the mirror image, to the
//! last bit, and a machine may compute four at once. That does not overshoot: both diagonals of a cell are nearly at right angles, and the few links that
//! share a particle elsewhere lie in a row.

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

/// Links of one kind.
pub(super) struct Pairs<'a, S: Scalar, const H: usize> {
    rest: &'a Rest<S>,
    strength: Quotient<S>,
    /// Of two particles of mass 1, 1/(2·a + b).
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

    /// Links between particles that are `ACROSS` columns apart.
    #[inline(never)] // one for all scenes of a grid
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

    /// Links between particles that are `DOWN` rows apart.
    #[inline(never)] // one for all scenes of a grid
    pub(super) fn column<const DOWN: usize, const W: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        mut multipliers: Option<&mut Grid<S, W, H>>,
    ) {
        // before the links of a row act, those that end in it have acted
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

    /// Links along both diagonals.
    #[inline(never)] // one for all scenes of a grid
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

    /// The effective mass of the links between two rows, whose inverse masses are these once those of the second are `shifted`.
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
            // between two pins nothing gives
            let stuck = inverse_mass == S::ZERO;
            divisors[column] = if stuck { S::INFINITE_DIVISOR } else { against.divisor() };
        }
        EffectiveMass::Any(divisors)
    }

    /// Moves a row by a pull of links of such an effective mass, times inverse masses.
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

    /// Finds how links from a row of particles to another pull by what is missing. (What is returned is copied on a Cortex-M.)
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

    /// Finds how links pull by what `change` makes of their multipliers and their excess lengths: what multipliers change by.
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
        // no branches: so it can be done for four at once
        for column in links {
            let (excess, normal) = (y(column) - x.at(column)).direction(self.rest);
            let by = change(column, multipliers[column], excess);
            multipliers[column] += by;
            pull.set(column, normal.of_length(self.strength.times_dividend(by), self.rounding));
        }
    }
}

/// 1/(a·Σw + b): the mass that two particles show to the multiplier of a link, softened by the link.
enum EffectiveMass<S, const W: usize> {
    /// The same everywhere: all particles have mass 1.
    UnitMass(S),
    /// Of each link, as what its residual is [divided](Scalar::over) by.
    Any([S; W]),
}

/// Nothing in the last `BY < W` columns.
#[inline(always)]
fn without_last<const BY: usize, S: Scalar, const W: usize>(pull: &mut Vec3<[S; W]>, multipliers: &mut [S; W]) {
    for column in W - BY..W {
        pull.set(column, Vec3::ZERO);
        multipliers[column] = S::ZERO;
    }
}

/// Nothing in the first `BY < W` columns.
#[inline(always)]
fn without_first<const BY: usize, S: Scalar, const W: usize>(pull: &mut Vec3<[S; W]>, multipliers: &mut [S; W]) {
    for column in 0..BY {
        pull.set(column, Vec3::ZERO);
        multipliers[column] = S::ZERO;
    }
}

//! The sweep over all links of a scene.

use crate::grid::Grid;
use crate::link::{Family, Links, Quotient, Visitor, directions};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Rounding, Scalar};
use crate::solver::unit_mass::UnitMass;

use super::chain::Chain;
use super::exponent::Exponent;
use super::pairs::Pairs;

/// The binary logarithm of the κ (scaled by the rule in time) above which diagonals are solved exactly. Softer ones converge as fast one by one, which is cheaper.
const STIFF: u32 = 5;

/// The families that a pass over the links solves.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// All but the next one.
    Others,
    /// Links between neighbours in a row or a column.
    Lines,
}

/// The state of the sweeps in a part of a substep.
pub(super) struct Relax<'a, S, const W: usize, const H: usize> {
    pub(super) particles: &'a mut Particles<S, W, H>,
    multipliers: &'a mut [Grid<S, W, H>],
    moment: Moment,
    /// The factor by which the rule in time scales κ.
    stiffness: S,
    pass: Pass,
    /// Whether this is the first sweep.
    first: bool,
    /// The index of the next family's grid of multipliers.
    slot: usize,
    /// The largest residual strain that the sweep found, of rows and of regularised chains.
    residual: S,
    /// How corrections are rounded.
    rounding: Rounding,
    unit_mass: UnitMass<W, H>,
    exponent: Exponent,
    /// The least positive inverse mass, divided by the largest if that is more than 1.
    span: S,
    /// Whether no particle is lighter than an eighth of a mass: then shorter steps converge better than more sweeps.
    pub(super) none_is_light: bool,
}

impl<'a, S: Scalar, const W: usize, const H: usize> Relax<'a, S, W, H> {
    pub(super) fn new(
        particles: &'a mut Particles<S, W, H>,
        multipliers: &'a mut [Grid<S, W, H>],
        moment: Moment,
        stiffness: S,
    ) -> Self {
        let unit_mass = UnitMass::new(particles);
        let (exponent, span, none_is_light) = Exponent::new(particles, &unit_mass.rows);
        let (pass, residual, rounding) = (Pass::Others, S::ZERO, moment.rounding());
        Self {
            particles,
            multipliers,
            moment,
            stiffness,
            pass,
            first: true,
            slot: 0,
            residual,
            rounding,
            unit_mass,
            exponent,
            span,
            none_is_light,
        }
    }

    /// Solves every family once; in the `first` sweep of a part of a substep, multipliers start at zero. Returns the largest residual strain that it found.
    pub(super) fn sweep<L: Links<S>>(&mut self, links: &L, first: bool) -> S {
        (self.first, self.residual) = (first, S::ZERO);
        for pass in [Pass::Others, Pass::Lines] {
            self.pass(links, pass);
        }
        self.residual
    }

    fn pass<L: Links<S>>(&mut self, links: &L, pass: Pass) {
        (self.pass, self.slot) = (pass, 0);
        links.springs(self);
    }

    /// A chain's κ, scaled by the rule in time. The last pivot of a taut chain between two pins is nearly the divisor alone, so the divisor is at least a few units of the number
    /// type's resolution.
    fn strength(&self, family: &Family<S>) -> Quotient<S> {
        let strength = family.strength.scaled(self.stiffness);
        let least = S::from_f64(8.0 * S::RESOLUTION);
        Quotient { divisor: strength.divisor.max(least), ..strength }
    }

    fn diagonals(&mut self, family: &Family<S>, slot: usize) {
        let strength = self.strength(family);
        let Self { moment, rounding, ref unit_mass, exponent, span, .. } = *self;
        let chain = Chain { rest: &family.rest, strength, moment, rounding, unit_mass, exponent, span };
        if let Some([black, white]) = self.multipliers.get_mut(slot..slot + 2) {
            let worst = chain.diagonals(self.particles, [black, white]);
            self.residual = self.residual.max(worst * family.rest.inverse);
        }
    }

    fn lines<const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let strength = self.strength(family);
        let Some(multipliers) = self.multipliers.get_mut(slot) else { return };
        let Self { moment, rounding, ref unit_mass, exponent, span, .. } = *self;
        let chain = Chain { rest: &family.rest, strength, moment, rounding, unit_mass, exponent, span };
        let worst = if const { DOWN == 0 } {
            chain.rows(self.particles, multipliers, self.first)
        } else {
            if self.first {
                *multipliers = Grid::filled(S::ZERO);
            }
            chain.columns(self.particles, multipliers)
        };
        self.residual = self.residual.max(worst * family.rest.inverse);
    }

    fn others<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let strength = family.strength.scaled(self.stiffness);
        let slots = slot..slot + directions::<ACROSS, DOWN>();
        if self.first
            && let Some(multipliers) = self.multipliers.get_mut(slots.clone())
        {
            multipliers.fill(Grid::filled(S::ZERO));
        }
        if const { ACROSS == 1 && DOWN == 1 } && strength.divisor.double(STIFF) < strength.dividend {
            return self.diagonals(family, slot);
        }
        let pairs = Pairs::new(family, strength, self.moment, self.rounding, &self.unit_mass.rows, self.exponent);
        let memory = self.multipliers.get_mut(slots);
        // without stored multipliers, a second sweep would count the same correction twice
        if memory.is_none() && !self.first {
            return;
        }
        let multipliers = memory.unwrap_or(&mut []);
        if const { ACROSS > 0 && DOWN > 0 } {
            let multipliers = if let [falling, rising, ..] = multipliers { Some([falling, rising]) } else { None };
            pairs.diagonals::<ACROSS, DOWN, W>(self.particles, multipliers);
        } else if const { DOWN == 0 } {
            pairs.row::<ACROSS, W>(self.particles, multipliers.first_mut());
        } else {
            pairs.column::<DOWN, W>(self.particles, multipliers.first_mut());
        }
    }
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Relax<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let slot = self.slot;
        self.slot += directions::<ACROSS, DOWN>();
        if const { ACROSS + DOWN == 1 } {
            match self.pass {
                Pass::Others => {}
                Pass::Lines => self.lines::<DOWN>(family, slot),
            }
        } else {
            match self.pass {
                Pass::Others => self.others::<ACROSS, DOWN>(family, slot),
                Pass::Lines => {}
            }
        }
    }
}

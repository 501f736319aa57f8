//! A sweep over all links of a scene.

use crate::grid::Grid;
use crate::link::{Family, Links, Quotient, Visitor};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::ordinary::Ordinary;
use crate::vec3::Vec3;

use super::WARM;
use super::chain::Chain;
use super::heavy::Heavy;
use super::pairs::Pairs;

/// Which families a visit is for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// All, which act with a part of their last multipliers.
    Start,
    /// All but those along rows and columns between neighbours.
    Others,
    /// Rows and columns.
    Lines,
}

/// Relaxes links.
pub(super) struct Relax<'a, S, const W: usize, const H: usize, const N: usize> {
    pub(super) particles: &'a mut Particles<S, W, H>,
    tension: &'a mut [Grid<S, W, H>; N],
    moment: Moment,
    /// What the rule in time makes of κ.
    softness: S,
    pass: Pass,
    /// Whether no sweep of this substep went before.
    first: bool,
    /// The grid of multipliers of the family at hand.
    slot: usize,
    /// The largest strain of a row that the sweep met.
    met: S,
    ordinary: Ordinary<W, H>,
    heavy: Heavy,
}

impl<'a, S: Scalar, const W: usize, const H: usize, const N: usize> Relax<'a, S, W, H, N> {
    pub(super) fn new(
        particles: &'a mut Particles<S, W, H>,
        tension: &'a mut [Grid<S, W, H>; N],
        moment: Moment,
        softness: S,
    ) -> Self {
        let ordinary = Ordinary::new(particles);
        let heavy = Heavy::new(particles, &ordinary.rows);
        let (pass, met) = (Pass::Others, S::ZERO);
        Self { particles, tension, moment, softness, pass, first: true, slot: 0, met, ordinary, heavy }
    }

    /// In fixed point, whose sums are exact, sweeps move positions alone: what velocities have that is not the positions' is set aside in their place. (One by
    /// one the velocities of corrections would be rounded, which pushes a sheet aside.)
    pub(super) fn set_aside(&mut self) {
        let moment = self.moment;
        self.velocities(|velocity, position| velocity - moment.share(position));
    }

    /// Gives velocities what sweeps have added to them.
    pub(super) fn complete(&mut self) {
        let moment = self.moment;
        self.velocities(|velocity, position| velocity + moment.share(position));
    }

    #[inline(always)]
    fn velocities(&mut self, change: impl Fn(Vec3<S>, Vec3<S>) -> Vec3<S>) {
        if !S::FLOATS {
            for (position, velocity) in self.particles.position.0.iter().zip(&mut self.particles.velocity.0) {
                for column in 0..W {
                    velocity.set(column, change(velocity.at(column), position.at(column)));
                }
            }
        }
    }

    /// Lets every link act with a part of its last multiplier.
    pub(super) fn start<L: Links<S>>(&mut self, links: &L) {
        (self.pass, self.slot) = (Pass::Start, 0);
        links.springs(self);
    }

    /// Starts every link from nothing.
    pub(super) fn forget(&mut self) {
        *self.tension = [Grid::filled(S::ZERO); N];
    }

    /// Relaxes every link once. Returns the largest strain of a row that it met.
    pub(super) fn sweep<L: Links<S>>(&mut self, links: &L, first: bool) -> S {
        (self.first, self.met) = (first, S::ZERO);
        for pass in [Pass::Others, Pass::Lines] {
            (self.pass, self.slot) = (pass, 0);
            links.springs(self);
        }
        self.met
    }

    /// Starts a family from nothing.
    fn clear(&mut self, slot: usize) {
        if let Some(tension) = self.tension.get_mut(slot) {
            *tension = Grid::filled(S::ZERO);
        }
    }

    fn lines<const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let Some(tension) = self.tension.get_mut(slot) else { return };
        let strength = family.strength.scaled(self.softness);
        // a taut row between two pins has no pivot but for this: of what a number can tell from nothing, a little is left
        let least = S::from_f64(8.0 * S::RESOLUTION);
        let strength = Quotient { divisor: strength.divisor.max(least), ..strength };
        let chain =
            Chain { rest: &family.rest, strength, moment: self.moment, ordinary: &self.ordinary, heavy: self.heavy };
        if const { DOWN == 0 } {
            let worst = chain.rows(self.particles, tension);
            self.met = self.met.max(worst * family.rest.inverse);
        } else {
            chain.columns(self.particles, tension);
        }
    }

    fn others<const ACROSS: usize, const DOWN: usize, const START: bool>(&mut self, family: &Family<S>, slot: usize) {
        let strength = family.strength.scaled(self.softness);
        let pairs = Pairs::new(family, strength, self.moment, &self.ordinary.rows, self.heavy);
        let soft = strength.divisor >= strength.dividend;
        if START && !soft {
            (slot..slot + slots::<ACROSS, DOWN>()).for_each(|slot| self.clear(slot));
            return;
        }
        let warm = S::from_f64(WARM);
        let memory = self.tension.get_mut(slot..slot + slots::<ACROSS, DOWN>());
        // without a memory a second time would count twice
        if memory.is_none() && (START || !self.first) {
            return;
        }
        let tension = memory.unwrap_or(&mut []);
        if const { ACROSS > 0 && DOWN > 0 } {
            let tension = if let [falling, rising, ..] = tension { Some([falling, rising]) } else { None };
            pairs.diagonals::<ACROSS, DOWN, START, W>(self.particles, tension, warm);
        } else if const { DOWN == 0 } {
            pairs.row::<ACROSS, START, W>(self.particles, tension.first_mut(), warm);
        } else {
            pairs.column::<DOWN, START, W>(self.particles, tension.first_mut(), warm);
        }
    }
}

impl<S: Scalar, const W: usize, const H: usize, const N: usize> Visitor<S> for Relax<'_, S, W, H, N> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let slot = self.slot;
        self.slot += slots::<ACROSS, DOWN>();
        if const { ACROSS + DOWN == 1 } {
            match self.pass {
                Pass::Start => self.clear(slot),
                Pass::Others => {}
                Pass::Lines => self.lines::<DOWN>(family, slot),
            }
        } else {
            match self.pass {
                Pass::Start => self.others::<ACROSS, DOWN, true>(family, slot),
                Pass::Others => self.others::<ACROSS, DOWN, false>(family, slot),
                Pass::Lines => {}
            }
        }
    }
}

/// The grids of multipliers of a family.
const fn slots<const ACROSS: usize, const DOWN: usize>() -> usize {
    if ACROSS > 0 && DOWN > 0 { 2 } else { 1 }
}
